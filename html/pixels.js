// The positions of a picture's pixels on the screen, and what is drawn over pictures.
//
// A pane is a rectangle of the canvas in device pixels. All panes share `view`: the picture's point
// at the centre of a pane, and the scale in CSS pixels per picture pixel. The page's own `state`
// has its panes and its cursor, the chosen pixel.

const canvas = document.getElementById("view");
const context = canvas.getContext("2d");

const scales = [1 / 16, 1 / 8, 1 / 4, 1 / 2, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96];
const view = {x: 0, y: 0, scale: 1};

// The size of a picture pixel in device pixels. From 1 upwards it is a whole number, so that all
// pixels have the same size.
function cellSize() {
  const size = view.scale * devicePixelRatio;
  return size < 1 ? size : Math.round(size);
}

// The left and top of picture pixel (0, 0) in the pane.
function originOf(pane) {
  const cell = cellSize();
  return {
    x: Math.round(pane.x + pane.width / 2 - view.x * cell),
    y: Math.round(pane.y + pane.height / 2 - view.y * cell),
  };
}

// The point of the picture under a point of the pane.
function pointUnder(pane, x, y) {
  const origin = originOf(pane), cell = cellSize();
  return {x: (x - origin.x) / cell, y: (y - origin.y) / cell};
}

// The pane under a mouse event, and the event's point in it, in device pixels.
function paneUnder(event) {
  const box = canvas.getBoundingClientRect();
  const x = (event.clientX - box.left) * devicePixelRatio, y = (event.clientY - box.top) * devicePixelRatio;
  const pane = state.panes.find((each) =>
    x >= each.x && x < each.x + each.width && y >= each.y && y < each.y + each.height);
  return pane && {pane, x, y};
}

// The next scale up or down among `usable` ones; below the smallest, the scale at which the whole
// picture fits.
function scaleBeside(steps, usable = scales) {
  const up = usable.find((scale) => scale > view.scale * 1.001);
  const down = usable.findLast((scale) => scale < view.scale * 0.999);
  return (steps > 0 ? up : Math.max(down ?? 0, Math.min(fitScale(), 1))) ?? view.scale;
}

// Boxes for `count` panes, in the number of columns that shows the picture largest.
function paneBoxes(count, size) {
  const gap = Math.round(8 * devicePixelRatio), strip = stripHeight();
  const inColumns = (columns) => {
    const rows = Math.ceil(count / columns);
    const width = Math.floor((canvas.width - gap * (columns - 1)) / columns);
    const height = Math.floor((canvas.height - gap * (rows - 1)) / rows) - strip;
    return {columns, width, height, scale: Math.min(width / size.width, height / size.height)};
  };
  const {columns, width, height} = Array.from({length: count}, (_, i) => inColumns(count - i))
    .reduce((best, other) => (other.scale > best.scale ? other : best));
  return Array.from({length: count}, (_, i) => ({
    x: (i % columns) * (width + gap),
    y: Math.floor(i / columns) * (height + strip + gap) + strip,
    width,
    height,
  }));
}

// The box of pixels that are at least partly visible in the pane.
function visiblePixels(pane, origin, cell, picture) {
  return {
    left: clamp(Math.floor((pane.x - origin.x) / cell), 0, picture.width),
    top: clamp(Math.floor((pane.y - origin.y) / cell), 0, picture.height),
    right: clamp(Math.ceil((pane.x + pane.width - origin.x) / cell), 0, picture.width),
    bottom: clamp(Math.ceil((pane.y + pane.height - origin.y) / cell), 0, picture.height),
  };
}

function drawGrid(seen, origin, cell) {
  context.fillStyle = "rgb(128 128 128 / 0.4)";
  const left = origin.x + seen.left * cell, right = origin.x + seen.right * cell;
  const top = origin.y + seen.top * cell, bottom = origin.y + seen.bottom * cell;
  for (let x = left; x <= right; x += cell) context.fillRect(x, top, 1, bottom - top);
  for (let y = top; y <= bottom; y += cell) context.fillRect(left, y, right - left, 1);
}

// A light line between dark ones is visible on every colour.
function outline(x, y, width, height, colour) {
  const unit = Math.max(1, Math.round(devicePixelRatio));
  context.lineWidth = 3 * unit;
  context.strokeStyle = "rgb(0 0 0 / 0.6)";
  context.strokeRect(x - 1.5 * unit, y - 1.5 * unit, width + 3 * unit, height + 3 * unit);
  context.lineWidth = unit;
  context.strokeStyle = colour;
  context.strokeRect(x - 1.5 * unit, y - 1.5 * unit, width + 3 * unit, height + 3 * unit);
}

function drawCrosshair(pane) {
  if (!state.cursor) return;
  const origin = originOf(pane), cell = cellSize();
  const x = origin.x + state.cursor.x * cell, y = origin.y + state.cursor.y * cell;
  outline(x, y, Math.max(cell, 1), Math.max(cell, 1), "#3df5ff");
  if (cell >= 12 * devicePixelRatio) return;
  const near = 8 * devicePixelRatio, far = 20 * devicePixelRatio, centre = cell / 2;
  for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
    for (const [colour, width] of [["rgb(0 0 0 / 0.6)", 3], ["#3df5ff", 1]]) {
      context.strokeStyle = colour;
      context.lineWidth = width * Math.max(1, Math.round(devicePixelRatio));
      context.beginPath();
      context.moveTo(x + centre + dx * near, y + centre + dy * near);
      context.lineTo(x + centre + dx * far, y + centre + dy * far);
      context.stroke();
    }
  }
}

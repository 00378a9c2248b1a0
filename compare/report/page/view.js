// Where a pixel of the picture lands on the screen, and the drawing of the panes.
//
// A pane is a rectangle of the canvas in device pixels; it shows layers, of which the wipe has two. All panes share
// `view`: the point of the picture at the centre of a pane, and the scale in CSS pixels a picture pixel.

const largestScale = () => (state.pair.pictures[0].type === "f32" ? 96 : 64);

const stripHeight = () => Math.round(24 * devicePixelRatio); // the title of a pane

// The scale that shows all of the picture, a whole number where it is larger than 1. In a window without room for it, this is
// the scale for a pane of one pixel.
function fitScale() {
  const [width, height] = [state.panes[0].width, state.panes[0].height].map((size) => Math.max(size, 1));
  const scale = Math.min(width / state.pair.width, height / state.pair.height) / devicePixelRatio;
  return scale < 1 ? scale : scales.findLast((step) => step <= Math.min(scale, largestScale()));
}

function draw() {
  context.fillStyle = colourVariable("--stage");
  context.fillRect(0, 0, canvas.width, canvas.height);
  for (const pane of state.panes) drawPane(pane);
}

function drawPane(pane) {
  drawTitle(pane);
  for (const layer of pane.layers) {
    context.save();
    context.beginPath();
    context.rect(pane.x + pane.width * layer.from, pane.y, pane.width * (layer.to - layer.from), pane.height);
    context.clip();
    drawLayer(pane, layer);
    context.restore();
  }
  context.save();
  context.beginPath();
  context.rect(pane.x, pane.y, pane.width, pane.height);
  context.clip();
  if (state.showBoxes) drawBoxes(pane);
  if (pane.layers.length > 1) drawDivider(pane);
  drawCrosshair(pane);
  context.restore();
}

function drawTitle(pane) {
  const strip = stripHeight();
  context.font = `600 ${Math.round(strip * 0.54)}px system-ui, sans-serif`;
  context.textBaseline = "middle";
  for (const {title, colour, from, to} of pane.layers) {
    const right = pane.layers.length > 1 && to === 1;
    context.textAlign = right ? "right" : "left";
    const x = right ? pane.x + pane.width : pane.x + pane.width * from;
    context.fillStyle = colourVariable(colour);
    context.fillRect(right ? x - strip * 0.18 : x, pane.y - strip * 0.85, strip * 0.18, strip * 0.6);
    context.fillStyle = colourVariable("--text");
    context.fillText(title, x + (right ? -1 : 1) * strip * 0.4, pane.y - strip * 0.55);
  }
}

function drawLayer(pane, layer) {
  const origin = originOf(pane), cell = cellSize();
  const seen = visiblePixels(pane, origin, cell, layer.picture);
  fillPixels(colourVariable("--absent"), {x: 0, y: 0, ...layer.picture}, origin, cell, pane);
  const transparent = !layer.picture.opaque && layer.picture.channels % 2 === 0;
  for (const tile of layer.picture.tiles) {
    if (transparent) fillPixels(checks(), tile, origin, cell, pane);
    if (tile.halvings && cell < 1) drawHalving(tile, origin, cell);
    else drawTile(tile, origin, cell, seen);
  }
  if (cell >= 12 * devicePixelRatio) drawGrid(seen, origin, cell);
  if (cell >= 20 * devicePixelRatio) drawValues(layer, seen, origin, cell);
}

// Only the part that is seen: browsers lose precision far outside of the canvas.
function drawTile(tile, origin, cell, seen) {
  const left = Math.max(tile.x, seen.left), right = Math.min(tile.x + tile.width, seen.right);
  const top = Math.max(tile.y, seen.top), bottom = Math.min(tile.y + tile.height, seen.bottom);
  if (left >= right || top >= bottom) return;
  context.imageSmoothingEnabled = cell < 1;
  context.imageSmoothingQuality = "high";
  context.drawImage(tile.canvas, left - tile.x, top - tile.y, right - left, bottom - top,
    origin.x + left * cell, origin.y + top * cell, (right - left) * cell, (bottom - top) * cell);
}

// The version of the heat map of which a pixel covers at least one of the screen.
function drawHalving(tile, origin, cell) {
  const times = Math.min(Math.ceil(-Math.log2(cell)), tile.halvings.length - 1);
  const {canvas: half, width, height} = tile.halvings[times];
  const size = cell * 2 ** times;
  context.imageSmoothingEnabled = false;
  context.drawImage(half, origin.x + tile.x * cell, origin.y + tile.y * cell, width * size, height * size);
}

// Fills a box of pixels, as far as it is on the pane.
function fillPixels(fill, {x, y, width, height}, origin, cell, pane) {
  const left = Math.max(origin.x + x * cell, pane.x), top = Math.max(origin.y + y * cell, pane.y);
  const right = Math.min(origin.x + (x + width) * cell, pane.x + pane.width);
  const bottom = Math.min(origin.y + (y + height) * cell, pane.y + pane.height);
  context.fillStyle = fill;
  if (left < right && top < bottom) context.fillRect(left, top, right - left, bottom - top);
}

// Squares of light grey that show through what is transparent.
function checks() {
  const size = Math.round(8 * devicePixelRatio);
  const tile = newCanvas(2 * size, 2 * size), paint = tile.getContext("2d");
  paint.fillStyle = "#fff";
  paint.fillRect(0, 0, 2 * size, 2 * size);
  paint.fillStyle = "#ccc";
  paint.fillRect(0, 0, size, size);
  paint.fillRect(size, size, size, size);
  return context.createPattern(tile, "repeat");
}

// The lines of text that a layer has for a pixel, printed in it in one size for all that is seen; nothing where they
// would be too small to read.
function drawValues(layer, seen, origin, cell) {
  const cells = [];
  let longest = 3, lines = 1;
  for (let y = seen.top; y < seen.bottom; y++) {
    for (let x = seen.left; x < seen.right; x++) {
      const text = layer.textAt(x, y);
      if (!text) continue;
      cells.push({x, y, text});
      lines = Math.max(lines, text.length);
      for (const line of text) longest = Math.max(longest, line.length);
    }
  }
  const room = cell * 0.94;
  const size = Math.floor(Math.min(room / (longest * 0.61), room / (lines * 1.15), 14 * devicePixelRatio));
  if (size < 7 * devicePixelRatio) return;
  context.font = `${size}px ui-monospace, Menlo, Consolas, monospace`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (const {x, y, text} of cells) {
    context.fillStyle = layer.isBright(x, y) ? "#000" : "#fff";
    text.forEach((line, i) => context.fillText(line, origin.x + (x + 0.5) * cell,
      origin.y + (y + 0.5) * cell + (i - (text.length - 1) / 2) * size * 1.15));
  }
}

// A box is at least a few pixels of the screen large, so that a single wrong pixel is found from any distance. The chosen
// region has its own box.
function drawBoxes(pane) {
  const origin = originOf(pane), cell = cellSize(), least = 8 * devicePixelRatio;
  const drawBox = (box, colour) => {
    const width = Math.max(box.width * cell, least), height = Math.max(box.height * cell, least);
    const x = origin.x + (box.x + box.width / 2) * cell - width / 2;
    const y = origin.y + (box.y + box.height / 2) * cell - height / 2;
    const seen = x < pane.x + pane.width && y < pane.y + pane.height && x + width > pane.x && y + height > pane.y;
    if (seen) outline(x, y, width, height, colour);
  };
  for (const box of shownBoxes().boxes) drawBox(box, "#fff");
  const region = state.pair.regions[state.region];
  if (region) drawBox(region.box, "#ffe14d");
}

function drawDivider(pane) {
  const unit = Math.max(1, Math.round(devicePixelRatio));
  const x = Math.round(pane.x + pane.width * state.divider), middle = pane.y + pane.height / 2;
  context.fillStyle = "rgb(0 0 0 / 0.6)";
  context.fillRect(x - 2 * unit, pane.y, 4 * unit, pane.height);
  context.fillStyle = "#fff";
  context.fillRect(x - unit, pane.y, 2 * unit, pane.height);
  context.beginPath();
  context.arc(x, middle, 9 * unit, 0, 2 * Math.PI);
  context.fill();
  context.fillStyle = "#333";
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.font = `${11 * unit}px sans-serif`;
  context.fillText("◂▸", x, middle + unit);
}

// The pictures in the centre, one for each run, with grid, outlines and crosshair.

const stripHeight = () => (state.runs.length > 1 ? Math.round(24 * devicePixelRatio) : 0);
const largestScale = () => 96;

function fitScale() {
  const pane = state.panes[0], {width, height} = state.runs[0];
  const scale = Math.min(pane.width / width, pane.height / height) / devicePixelRatio;
  return scale < 1 ? scale : scales.findLast((step) => step <= Math.min(scale, largestScale()));
}

// Updates each run's picture to the current moment and draws the overlay over it.
function paintPictures() {
  const {paint, note} = overlays[state.overlay], notes = [];
  for (const playback of state.playbacks) {
    const {run} = playback;
    playback.moveTo(state.at);
    playback.canvas ??= newCanvas(run.width, run.height);
    playback.image ??= new ImageData(playback.picture, run.width, run.height); // shares its bytes with the picture, so it follows it
    if (paint) {
      const image = new ImageData(playback.picture.slice(), run.width, run.height);
      notes.push(note(run, paint(playback, image.data)));
      playback.canvas.getContext("2d").putImageData(image, 0, 0);
    } else {
      const all = [0, 0, run.width, run.height], changed = playback.takeChanged();
      playback.canvas.getContext("2d").putImageData(playback.image, 0, 0, ...(playback.painted === state.overlay ? changed : all));
    }
    playback.painted = state.overlay;
  }
  byId("overlay-note").textContent = notes.filter(Boolean).join(" | ");
}

function layOut() {
  const box = canvas.getBoundingClientRect();
  if (!box.width) return; // hidden
  canvas.width = Math.max(1, Math.round(box.width * devicePixelRatio));
  canvas.height = Math.max(1, Math.round(box.height * devicePixelRatio));
  state.panes = paneBoxes(state.runs.length, state.runs[0]).map((pane, i) => ({...pane, playback: state.playbacks[i]}));
  if (state.fitted) Object.assign(view, {scale: fitScale(), x: state.runs[0].width / 2, y: state.runs[0].height / 2});
}

function drawPictures() {
  context.fillStyle = colourVariable("--stage");
  context.fillRect(0, 0, canvas.width, canvas.height);
  for (const pane of state.panes) drawPane(pane);
  byId("zoom-level").textContent = `${Math.round(view.scale * 1000) / 10} %`;
}

function drawPane(pane) {
  const {run} = pane.playback, origin = originOf(pane), cell = cellSize();
  if (stripHeight()) drawName(pane, run.name);
  context.save();
  context.beginPath();
  context.rect(pane.x, pane.y, pane.width, pane.height);
  context.clip();
  const seen = visiblePixels(pane, origin, cell, run);
  if (seen.left < seen.right && seen.top < seen.bottom) {
    context.imageSmoothingEnabled = cell < 1;
    context.imageSmoothingQuality = "high";
    context.drawImage(pane.playback.canvas, seen.left, seen.top, seen.right - seen.left, seen.bottom - seen.top,
      origin.x + seen.left * cell, origin.y + seen.top * cell, (seen.right - seen.left) * cell, (seen.bottom - seen.top) * cell);
  }
  if (cell >= 8 * devicePixelRatio) drawGrid(seen, origin, cell);
  if (cell >= 44 * devicePixelRatio) drawBytes(pane, seen, origin, cell);
  drawTriangle(run, origin, cell);
  drawCrosshair(pane);
  context.restore();
}

function drawName(pane, name) {
  const strip = stripHeight();
  context.font = `600 ${Math.round(strip * 0.54)}px system-ui, sans-serif`;
  context.textBaseline = "middle";
  context.textAlign = "left";
  context.fillStyle = colourVariable("--text");
  context.fillText(name, pane.x, pane.y - strip * 0.5, pane.width);
}

// Prints the bytes of each pixel inside it.
function drawBytes({playback: {picture, run}}, seen, origin, cell) {
  context.font = `${Math.min(12 * devicePixelRatio, Math.floor(cell / 4.4))}px ui-monospace, Menlo, Consolas, monospace`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (let y = seen.top; y < seen.bottom; y++) {
    for (let x = seen.left; x < seen.right; x++) {
      const at = 4 * (y * run.width + x), [r, g, b] = picture.subarray(at, at + 3);
      context.fillStyle = 0.3 * r + 0.6 * g + 0.1 * b > 128 ? "#000" : "#fff";
      [r, g, b].forEach((byte, i) =>
        context.fillText(byte, origin.x + (x + 0.5) * cell, origin.y + (y + 0.5 + (i - 1) * 0.28) * cell));
    }
  }
}

// The outline of the chosen triangle after snapping.
function drawTriangle(run, origin, cell) {
  const chain = state.triangle === null ? null : cachedChain(run, state.triangle);
  if (!chain?.polygon.length) return;
  for (const [colour, width] of [["rgb(0 0 0 / 0.7)", 4], ["#ffe14d", 1.6]]) {
    context.beginPath();
    chain.polygon.forEach(({snapped: [x, y]}, k) =>
      context[k ? "lineTo" : "moveTo"](origin.x + (x / 256) * cell, origin.y + (y / 256) * cell));
    context.closePath();
    context.strokeStyle = colour;
    context.lineWidth = width * devicePixelRatio;
    context.stroke();
  }
}

function zoomBy(steps, at = null) {
  zoomTo(scaleBeside(steps), at);
}

// Zooms; the point of the picture under `at` stays where it is.
function zoomTo(scale, at = null) {
  const held = at && pointUnder(at.pane, at.x, at.y);
  view.scale = scale;
  state.fitted = false;
  if (held) {
    const moved = pointUnder(at.pane, at.x, at.y);
    moveView(held.x - moved.x, held.y - moved.y);
  } else if (state.cursor) {
    Object.assign(view, {x: state.cursor.x + 0.5, y: state.cursor.y + 0.5});
  }
  drawPictures();
}

function moveView(dx, dy) {
  view.x = clamp(view.x + dx, 0, state.runs[0].width);
  view.y = clamp(view.y + dy, 0, state.runs[0].height);
}

// Moves the view if the cursor is outside it.
function showCursor() {
  const pane = state.panes[0];
  if (!state.cursor || !pane) return;
  const origin = originOf(pane), cell = cellSize();
  const x = origin.x + state.cursor.x * cell, y = origin.y + state.cursor.y * cell;
  if (x >= pane.x && y >= pane.y && x + cell <= pane.x + pane.width && y + cell <= pane.y + pane.height) return;
  Object.assign(view, {x: state.cursor.x + 0.5, y: state.cursor.y + 0.5});
}

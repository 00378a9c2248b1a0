// Mouse, keys and the tool bar.

// Zooms by one step; what is under the given point of a pane stays there.
function zoomBy(steps, at = null) {
  if (!state.pair?.pictures.length) return;
  zoomTo(scaleBeside(steps, scales.filter((scale) => scale <= largestScale())), at);
}

function zoomTo(scale, at = null) {
  const held = at && pointUnder(at.pane, at.x, at.y);
  view.scale = scale;
  state.fitted = false;
  if (held) {
    const now = pointUnder(at.pane, at.x, at.y);
    moveView(held.x - now.x, held.y - now.y);
  }
  update();
}

function moveView(dx, dy) {
  view.x = clamp(view.x + dx, 0, state.pair.width);
  view.y = clamp(view.y + dy, 0, state.pair.height);
}

function fit() {
  Object.assign(view, {scale: fitScale(), x: state.pair.width / 2, y: state.pair.height / 2});
  state.fitted = true;
  update();
}

// Where the keyboard zooms: at the crosshair if it is seen, else at the centre.
function zoomPlace() {
  const pane = state.panes[0], origin = originOf(pane), cell = cellSize();
  if (!state.cursor) return null;
  const x = origin.x + (state.cursor.x + 0.5) * cell, y = origin.y + (state.cursor.y + 0.5) * cell;
  const inside = x >= pane.x && y >= pane.y && x < pane.x + pane.width && y < pane.y + pane.height;
  return inside ? {pane, x, y} : null;
}

function moveCursor(dx, dy) {
  const from = state.cursor ?? {x: Math.floor(view.x) - dx, y: Math.floor(view.y) - dy};
  state.cursor = {
    x: clamp(from.x + dx, 0, state.pair.width - 1),
    y: clamp(from.y + dy, 0, state.pair.height - 1),
  };
  keepCursorInView();
  update();
}

// Moves the view as little as needed.
function keepCursorInView() {
  const pane = state.panes[0], halfX = pane.width / cellSize() / 2, halfY = pane.height / cellSize() / 2;
  const {x, y} = state.cursor;
  view.x = clamp(view.x, x + 1 - halfX, x + halfX);
  view.y = clamp(view.y, y + 1 - halfY, y + halfY);
}

function goToRegion(index) {
  const region = state.pair.regions[index];
  if (!region || !state.pair.pictures.length) return;
  const {x, y, width, height} = region.box, pane = state.panes[0];
  const roomy = Math.min(pane.width / (width + 4), pane.height / (height + 4)) / devicePixelRatio;
  state.region = index;
  state.cursor = {...region.worst};
  Object.assign(view, {x: x + width / 2, y: y + height / 2});
  view.scale = scales.findLast((scale) => scale <= Math.min(roomy, 48)) ?? fitScale();
  state.fitted = false;
  markRegion(index);
  update();
}

function stepRegion(by) {
  const {length} = state.pair.regions;
  if (length) goToRegion(((state.region ?? (by > 0 ? -1 : 0)) + by + length) % length);
}

function setMode(mode) {
  const radio = document.querySelector(`input[name=mode][value=${mode}]`);
  if (radio.disabled) return;
  radio.checked = true;
  state.mode = mode;
  playFlicker(mode === "flicker" && !matchMedia("(prefers-reduced-motion: reduce)").matches);
  arrange();
}

function swap() {
  if (state.mode !== "flicker") return setMode("flicker");
  state.shown = 1 - state.shown;
  arrange();
}

let timer = 0;
function playFlicker(playing) {
  clearInterval(timer);
  const speed = Number(byId("speed").value);
  timer = playing ? setInterval(swap, 1000 / speed) : 0;
  byId("play").textContent = playing ? "Pause" : "Play";
  byId("play").setAttribute("aria-pressed", playing);
  byId("speed-value").textContent = `${speed} a second`;
}

function setDivider(part) {
  state.divider = clamp(part, 0, 1);
  byId("divider").value = state.divider * 100;
  arrange();
}

function setRange(low, high) {
  if (!(low < high)) return;
  state.range = {low, high};
  Object.entries(state.range).forEach(([end, value]) => {
    byId(end).value = Number(floatText(Math.fround(value)).replace("−", "-"));
    byId(`${end}-slider`).value = value;
  });
  paintPair();
  update();
}

const keys = {
  s: () => setMode("side"),
  f: () => setMode("flicker"),
  w: () => setMode("wipe"),
  h: () => setMode("heat"),
  " ": swap,
  p: () => (state.mode === "flicker" ? playFlicker(!timer) : setMode("flicker")),
  n: () => stepRegion(1),
  N: () => stepRegion(-1),
  j: () => stepPair(1),
  k: () => stepPair(-1),
  a: toggleApproval,
  "/": () => byId("name-filter").focus(),
  "+": () => zoomBy(1, zoomPlace()),
  "=": () => zoomBy(1, zoomPlace()),
  "-": () => zoomBy(-1, zoomPlace()),
  0: fit,
  1: () => zoomTo(1, zoomPlace()),
  ",": () => setDivider(state.divider - 0.02),
  ".": () => setDivider(state.divider + 0.02),
  b: () => byId("boxes").click(),
};
const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};

// Letters work everywhere but where one writes or chooses; blanks and arrows keep their meaning on the other controls.
function onKey(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.matches("input[type=number], input[type=search], select")) return;
  const own = event.target === canvas || event.target === document.body;
  const arrow = arrows[event.key], reach = event.shiftKey ? 10 : 1;
  const act = arrow ? () => moveCursor(arrow[0] * reach, arrow[1] * reach) : keys[event.key];
  if (!act || ((arrow || event.key === " ") && !own)) return;
  if (!"jk".includes(event.key) && !state.pair?.pictures.length) return;
  event.preventDefault();
  act();
}

function listenToMouse() {
  let drag = null; // {pane, x, y} of the last event, and whether it is the divider that moves
  let wheel = 0;   // what a touch pad has turned since the last step

  canvas.addEventListener("pointerdown", (event) => {
    const at = paneUnder(event);
    if (!at || event.button) return;
    const dividerX = at.pane.x + at.pane.width * state.divider;
    drag = {...at, divider: at.pane.layers.length > 1 && Math.abs(at.x - dividerX) < 14 * devicePixelRatio};
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    const box = canvas.getBoundingClientRect();
    if (drag) {
      const x = (event.clientX - box.left) * devicePixelRatio, y = (event.clientY - box.top) * devicePixelRatio;
      if (drag.divider) return setDivider((x - drag.pane.x) / drag.pane.width);
      moveView((drag.x - x) / cellSize(), (drag.y - y) / cellSize());
      Object.assign(drag, {x, y});
      state.fitted = false;
    }
    pointAt(paneUnder(event));
  });
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => (drag = null));
  canvas.addEventListener("wheel", (event) => {
    const at = paneUnder(event);
    if (!at) return;
    event.preventDefault();
    wheel += event.deltaY * (event.deltaMode ? 40 : 1);
    if (Math.abs(wheel) < 40) return;
    zoomBy(-Math.sign(wheel), at);
    wheel = 0;
  }, {passive: false});
  canvas.addEventListener("dblclick", (event) => zoomBy(1, paneUnder(event)));
}

function pointAt(at) {
  const point = at && pointUnder(at.pane, at.x, at.y);
  const x = Math.floor(point?.x), y = Math.floor(point?.y);
  const inside = x >= 0 && y >= 0 && x < state.pair?.width && y < state.pair?.height;
  state.cursor = inside ? {x, y} : null;
  update();
}

function listenToControls() {
  document.addEventListener("keydown", onKey);
  byId("modes").addEventListener("change", (event) => setMode(event.target.value));
  byId("zoom-in").onclick = () => zoomBy(1);
  byId("zoom-out").onclick = () => zoomBy(-1);
  byId("zoom-fit").onclick = fit;
  byId("zoom-one").onclick = () => zoomTo(1);
  byId("swap").onclick = swap;
  byId("play").onclick = () => playFlicker(!timer);
  byId("speed").oninput = () => playFlicker(timer !== 0);
  byId("divider").oninput = () => setDivider(byId("divider").value / 100);
  byId("filter").onsubmit = (event) => event.preventDefault();
  byId("previous").onclick = () => stepPair(-1);
  byId("next").onclick = () => stepPair(1);
  byId("name-filter").onkeydown = ({key}) => { if (key === "Enter" || key === "Escape") canvas.focus(); };
  addEventListener("popstate", followAddress);
  byId("boxes").onchange = update;
  byId("opaque").onchange = () => { paintPair(); update(); };
  byId("range-auto").onclick = () => setRange(state.pair.range.low, state.pair.range.high);
  for (const field of ["low", "high"]) {
    const other = (value) => (field === "low" ? setRange(value, state.range.high) : setRange(state.range.low, value));
    byId(field).onchange = () => other(Number(byId(field).value));
    byId(`${field}-slider`).oninput = () => other(Number(byId(`${field}-slider`).value));
  }
  new ResizeObserver(resize).observe(byId("stage"));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", update);
}

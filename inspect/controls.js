// Handles the mouse, keys, buttons and fields.

function listenToPicture() {
  let held = null;
  canvas.addEventListener("pointerdown", (event) => {
    held = {x: event.clientX, y: event.clientY, moved: false};
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!held) return;
    const dx = event.clientX - held.x, dy = event.clientY - held.y;
    if (!held.moved && Math.hypot(dx, dy) < 4) return;
    held = {x: event.clientX, y: event.clientY, moved: true};
    state.fitted = false;
    moveView((-dx * devicePixelRatio) / cellSize(), (-dy * devicePixelRatio) / cellSize());
    drawPictures();
  });
  canvas.addEventListener("pointerup", (event) => {
    if (held && !held.moved) choosePixelUnder(event);
    held = null;
  });
  canvas.addEventListener("pointercancel", () => { held = null; });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoomBy(event.deltaY < 0 ? 1 : -1, paneUnder(event));
  }, {passive: false});
  new ResizeObserver(() => { layOut(); drawPictures(); }).observe(canvas);
  new ResizeObserver(sizeSpace).observe(spaceCanvas);
}

function choosePixelUnder(event) {
  const under = paneUnder(event);
  if (!under) return;
  const {x, y} = pointUnder(under.pane, under.x, under.y);
  choosePixel(Math.floor(x), Math.floor(y));
}

function listenToControls() {
  for (const [name, {name: label}] of Object.entries(overlays)) {
    byId("overlay").append(element("option", {value: name, textContent: label}));
  }
  const on = (id, event, act) => byId(id).addEventListener(event, act);
  on("overlay", "change", ({target}) => change({overlay: target.value}));
  on("zoom-in", "click", () => zoomBy(1));
  on("zoom-out", "click", () => zoomBy(-1));
  on("zoom-fit", "click", () => fitPicture());
  on("scrubber", "input", ({target}) => scrubTo(Number(target.value)));
  on("first", "click", () => goToEnd(0));
  on("back", "click", () => stepBy(-1));
  on("forward", "click", () => stepBy(1));
  on("last", "click", () => goToEnd(state.runs[0].fragmentCount));
  on("pixel-back", "click", () => stepOnPixel(-1));
  on("pixel-forward", "click", () => stepOnPixel(1));
  on("fragment-number", "change", ({target}) => Number(target.value) >= 1 && chooseFragment(Math.round(target.value) - 1));
  on("pixel-x", "change", () => choosePixel(Number(byId("pixel-x").value), Number(byId("pixel-y").value)));
  on("pixel-y", "change", () => choosePixel(Number(byId("pixel-x").value), Number(byId("pixel-y").value)));
  on("triangle-number", "change", ({target}) => chooseTriangle(Math.round(Number(target.value))));
  on("hex", "change", ({target}) => change({hex: target.checked}, "hex"));
  on("other-file", "change", ({target}) => target.files[0] && openOther(target.files[0]));
  on("close-other", "click", closeOther);
  for (const input of document.querySelectorAll("input[name=layout]")) input.addEventListener("change", () => setLayout(input.value));
  document.addEventListener("keydown", onKey);
  window.addEventListener("hashchange", readAddress);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => update());
}

// Arrow keys step through the fragments where they have no other meaning.
function onKey(event) {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const {tagName, type} = event.target;
  if (tagName === "SELECT" || (tagName === "INPUT" && type !== "checkbox" && type !== "file" && type !== "range")) return;
  const keys = {
    ArrowRight: () => (event.shiftKey ? stepOnPixel(1) : stepBy(1)),
    ArrowLeft: () => (event.shiftKey ? stepOnPixel(-1) : stepBy(-1)),
    Home: () => goToEnd(0),
    End: () => goToEnd(state.runs[0].fragmentCount),
    "+": () => zoomBy(1), "=": () => zoomBy(1), "-": () => zoomBy(-1), 0: () => fitPicture(),
    w: () => moveCursor(0, -1), a: () => moveCursor(-1, 0), s: () => moveCursor(0, 1), d: () => moveCursor(1, 0),
    p: () => byId("play").click(), P: () => byId("play").click(),
    W: () => moveCursor(0, -10), A: () => moveCursor(-10, 0), S: () => moveCursor(0, 10), D: () => moveCursor(10, 0),
  };
  if (!keys[event.key]) return;
  event.preventDefault();
  keys[event.key]();
}

function moveCursor(dx, dy) {
  const {width, height} = state.runs[0], from = state.cursor ?? {x: width >> 1, y: height >> 1};
  choosePixel(clamp(from.x + dx, 0, width - 1), clamp(from.y + dy, 0, height - 1));
}

function setLayout(layout) {
  byId("stage").hidden = byId("zoom").hidden = layout === "space";
  byId("space-panel").hidden = layout === "picture";
  layOut();
  drawPictures();
  sizeSpace();
}

function fitPicture() {
  state.fitted = true;
  layOut();
  drawPictures();
}

// The pictures, the maps of disparity, error and doubt, and the pixel under the cursor.

const {width, height, range, has_truth: hasTruth} = manifest;
const data = {}; // disparity, truth: floats; marks, confidence, sums: bytes
const cursor = {x: Math.floor(width / 2), y: Math.floor(height / 2)};
const overlays = {};
const doubts = ["", "occluded", "mismatched", "unsure", "outside", "speckle"];
const doubtColours = ["", "#5aa2ff", "#ff9a4d", "#f2c14e", "#9aa3b0", "#e56bd0"];

// Violet to yellow with evenly growing brightness: nine colours of viridis (Stefan van der Walt and
// Nathaniel Smith, CC0).
const ramp = ["#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80", "#5ec962", "#addc30", "#fde725"];
// Colours for errors: dark is right, white is four pixels off.
const heat = ["#10131a", "#4a1a5c", "#a52c60", "#ee6a24", "#fbc228", "#fffdf0"];
const mostError = 4;

const channels = (colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
const between = (colours) => {
  const stops = colours.map(channels);
  return (share) => {
    const place = clamp(share, 0, 1) * (stops.length - 1), at = Math.min(Math.floor(place), stops.length - 2), part = place - at;
    return stops[at].map((low, i) => low + part * (stops[at + 1][i] - low));
  };
};
const rampColour = between(ramp), heatColour = between(heat);
const nothing = [48, 52, 60];

function svg(tag, attributes, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

// The least and the greatest disparity of the colour scale: those of the truth, or of the result.
function endsOf(values) {
  let [least, greatest] = [Infinity, -Infinity];
  for (const value of values) if (Number.isFinite(value)) [least, greatest] = [Math.min(least, value), Math.max(greatest, value)];
  return least <= greatest ? [least, Math.max(greatest, least + 1e-6)] : [0, 1];
}

const errorAt = (i) => Math.abs(data.disparity[i] - data.truth[i]);
const byDisparity = (values) => (i) => Number.isFinite(values[i]) ? rampColour((values[i] - data.ends[0]) / (data.ends[1] - data.ends[0])) : nothing;
const maps = {
  disparity: () => byDisparity(data.disparity),
  truth: () => byDisparity(data.truth),
  error: () => (i) => {
    if (!Number.isFinite(data.truth[i])) return nothing;
    const colour = heatColour(Number.isFinite(data.disparity[i]) ? errorAt(i) / mostError : 1);
    return data.marks[i] & 1 ? colour : colour.map((value, channel) => .55 * value + .45 * [40, 90, 150][channel]); // hidden in the right picture
  },
  doubt: () => (i) => data.marks[i] >> 1 ? channels(doubtColours[data.marks[i] >> 1]) : rampColour(.08 + .5 * data.confidence[i] / 255),
};

const shownMap = () => document.querySelector("#maps :checked").value;

function drawMap() {
  const colourOf = maps[shownMap()](), image = new ImageData(width, height);
  for (let i = 0; i < width * height; i++) image.data.set([...colourOf(i), 255], 4 * i);
  byId("map-canvas").getContext("2d").putImageData(image, 0, 0);
  byId("legend").replaceChildren(...legends[shownMap()]());
  byId("map").previousSibling.textContent = mapNames[shownMap()];
}

const mapNames = {disparity: "Disparity", truth: "Truth", error: "Error", doubt: "Uncertain"};
const shortNumber = (value) => Number(value.toPrecision(4)).toString().replace("-", "−");
const pixelText = (value) => Number.isFinite(value) ? value.toFixed(2).replace("-", "−") : "none";

function bar(colours, low, high) {
  const strip = element("i", {ariaHidden: "true"});
  strip.style.background = `linear-gradient(to right, ${colours.join(", ")})`;
  return element("span", {className: "ramp"}, low, strip, high);
}
function swatch(colour, name) {
  const box = element("i", {ariaHidden: "true"});
  box.style.background = colour;
  return element("span", {}, box, name);
}
const none = () => swatch(`rgb(${nothing})`, hasTruth ? "none, or not known" : "none");
const legends = {
  disparity: () => [bar(ramp, `${shortNumber(data.ends[0])} px`, `${shortNumber(data.ends[1])} px: near`), none()],
  truth: () => legends.disparity(),
  error: () => [bar(heat, "0 px off", `${mostError} px and more`), swatch("rgb(22, 50, 82)", "blue: the right picture does not show it"), none()],
  doubt: () => [bar([0, .5, 1].map((share) => `rgb(${rampColour(.08 + .5 * share)})`), "certain: peak ratio 0", "1"),
    ...doubts.slice(1).map((name, i) => swatch(doubtColours[i + 1], name))],
};

// Draws a ring around the pixel, always of the same size on the screen.
function mark(side, x, y) {
  const unit = width / Math.max(byId(side).clientWidth, 1), near = 4 * unit, far = 13 * unit;
  const d = `M${x - far} ${y}H${x - near}M${x + near} ${y}H${x + far}M${x} ${y - far}V${y - near}M${x} ${y + near}V${y + far}`;
  return [svg("path", {d, class: "halo"}), svg("path", {d, class: "line"})];
}

function showCursor() {
  const {x, y} = cursor, i = y * width + x, disparity = data.disparity[i];
  for (const side of ["left", "map"]) overlays[side].replaceChildren(...mark(side, x + .5, y + .5));
  overlays.right.replaceChildren(...(Number.isFinite(disparity) ? mark("right", x + .5 - disparity, y + .5) : []));
  byId("readout").textContent = told(i);
  drawCurve(i);
  showSpace();
}

function told(i) {
  const {x, y} = cursor, disparity = data.disparity[i], doubt = doubts[data.marks[i] >> 1];
  const parts = [Number.isFinite(disparity)
    ? `Pixel ${x}, ${y}: disparity ${pixelText(disparity)} px, column ${pixelText(x + .5 - disparity)} of the right picture.`
    : `Pixel ${x}, ${y}: no disparity.`];
  if (hasTruth) {
    const truth = data.truth[i], known = Number.isFinite(truth);
    parts.push(known ? `True: ${pixelText(truth)} px${Number.isFinite(disparity) ? `, off by ${pixelText(errorAt(i))} px` : ""}; ${data.marks[i] & 1 ? "both pictures show it" : "the right picture does not show it"}.` : "The truth is not known here.");
  }
  if (manifest.calibration && Number.isFinite(disparity)) {
    const {focal_px: f, baseline, offset_px: offset} = manifest.calibration;
    const depth = f * baseline / (disparity + offset);
    if (depth > 0 && Number.isFinite(depth)) parts.push(`Depth ${shortNumber(depth)}.`);
  }
  parts.push(doubt ? `It was uncertain: ${doubt}.` : `Peak ratio ${(data.confidence[i] / 255).toFixed(2)}.`);
  return parts.join(" ");
}

function moveCursor(x, y) {
  Object.assign(cursor, {x: clamp(Math.floor(x), 0, width - 1), y: clamp(Math.floor(y), 0, height - 1)});
  showCursor();
}

function pressed(event) {
  const by = event.shiftKey ? 10 : 1, steps = {ArrowLeft: [-by, 0], ArrowRight: [by, 0], ArrowUp: [0, -by], ArrowDown: [0, by]};
  const step = steps[event.key];
  if (event.ctrlKey || event.altKey || event.metaKey || !step) return;
  event.preventDefault();
  moveCursor(cursor.x + step[0], cursor.y + step[1]);
}

function pane(side, name, content) {
  overlays[side] = svg("g", {});
  const drawing = svg("svg", {viewBox: `0 0 ${width} ${height}`, "aria-hidden": "true"}, overlays[side]);
  const moves = side !== "right";
  const frame = element("div", {className: width < 480 ? "picture small" : "picture", id: side, ...(moves ? {tabIndex: 0, role: "application",
    ariaLabel: `${name}: arrow keys move the cursor`} : {role: "img", ariaLabel: name})}, content, drawing);
  if (moves) {
    const moved = (event) => {
      const box = frame.getBoundingClientRect();
      moveCursor((event.clientX - box.left) * width / box.width, (event.clientY - box.top) * height / box.height);
    };
    frame.addEventListener("pointermove", moved);
    frame.addEventListener("pointerdown", moved);
    frame.addEventListener("keydown", pressed);
  }
  return element("div", {}, element("h3", {}, name), frame);
}

function setUpPanes() {
  const picture = (side) => element("img", {src: manifest.pictures[side], alt: "", width, height, draggable: false});
  const map = newCanvas(width, height);
  map.id = "map-canvas";
  byId("panes").append(pane("left", "Left picture", picture("left")), pane("right", "Right picture", picture("right")), pane("map", "Disparity", map));
  for (const radio of document.querySelectorAll("#maps input")) {
    if (!hasTruth && ["error", "truth"].includes(radio.value)) radio.parentNode.hidden = radio.disabled = true;
    radio.addEventListener("change", drawMap);
  }
  new ResizeObserver(showCursor).observe(byId("left"));
}

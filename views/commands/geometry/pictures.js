// Both pictures with marks over them: matches, a point in one, and its epipolar line in the other.
// All marks are in the pictures' pixels.

const sides = ["left", "right"], otherSide = {left: "right", right: "left"};
const {width, height, F: constraint, matches} = manifest;
const point = {side: "left", at: [width / 2, height / 2], match: -1};
const layers = {};
let unit = 1; // five screen pixels, measured in the pictures' pixels

// Violet to yellow. Brightness grows together with the hue, so that values can be told apart
// without colours too.
const ramp = ["#5e3fbe", "#4d6fd0", "#3b9bc4", "#46c19d", "#9bdb5c", "#f6e34a"];
const farColour = "#ff5a3c";
const rampAt = (share) => ramp[Math.round(clamp(share, 0, 1) * (ramp.length - 1))];

function svg(tag, attributes, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

const cross = (x, y, size) => `M${x - size} ${y - size}L${x + size} ${y + size}M${x - size} ${y + size}L${x + size} ${y - size}`;

const colourOf = (match) => match.inlier ? rampAt(match.sampson_px === undefined ? 0 : match.sampson_px / manifest.threshold_px) : farColour;

// Inliers are dots, the others crosses.
function matchMark(match, side) {
  const [x, y] = match[side];
  if (!match.inlier) return svg("path", {d: cross(x, y, .8 * unit), class: "mark", stroke: farColour});
  return svg("circle", {cx: x, cy: y, r: .8 * unit, class: "dot mark", fill: colourOf(match)});
}

const isShown = (match) => ({all: true, inliers: match.inlier, others: !match.inlier, none: false})[document.querySelector("#shown :checked").value];

function showMatches() {
  for (const side of sides) layers[side].matches.replaceChildren(...matches.filter(isShown).map((match) => matchMark(match, side)));
  showLinks();
}

// Lines between the two points of some matches: whole for inliers, dashed for the others.
function links(some, kind) {
  const corner = byId("pair").getBoundingClientRect(), boxes = {};
  for (const side of sides) boxes[side] = byId(side).getBoundingClientRect();
  const at = (match, side) => [boxes[side].left - corner.left + match[side][0] * boxes[side].width / width,
    boxes[side].top - corner.top + match[side][1] * boxes[side].height / height];
  return some.map((match) => svg("path", {d: `M${at(match, "left")}L${at(match, "right")}`, class: kind + (match.inlier ? "" : " far"), stroke: colourOf(match)}));
}

const areConnected = () => byId("connected").checked;

// Many lines are fainter, so that the pictures stay visible.
function showLinks() {
  const shown = areConnected() ? matches.filter(isShown) : [];
  byId("links").style.setProperty("--faint", clamp(60 / shown.length, .15, .7));
  layers.links.replaceChildren(...links(shown, "link"));
}

function showChosenLink() {
  const chosen = areConnected() && point.match >= 0 ? [matches[point.match]] : [];
  layers.chosenLink.replaceChildren(...links(chosen, "under"), ...links(chosen, "chosen"));
}

// The line a x + b y + c = 0 in the other picture: F p for a left point, F^T p for a right one
// (S2-11).
function epipolarLine(side, [x, y]) {
  const entry = (i, k) => side === "left" ? constraint[i][k] : constraint[k][i];
  const line = [0, 1, 2].map((i) => entry(i, 0) * x + entry(i, 1) * y + entry(i, 2)), length = Math.hypot(line[0], line[1]);
  return line.map((value) => value / length);
}

// The end points of the part of a line inside the picture; null if there is none.
function insidePicture([a, b, c]) {
  const ends = [];
  if (Math.abs(b) > 1e-12) ends.push([0, -c / b], [width, -(c + a * width) / b]);
  if (Math.abs(a) > 1e-12) ends.push([-c / a, 0], [-(c + b * height) / a, height]);
  const slack = 1e-6 * (width + height);
  const within = ends.filter(([x, y]) => x >= -slack && x <= width + slack && y >= -slack && y <= height + slack);
  const far = within.find(([x, y]) => Math.hypot(x - within[0][0], y - within[0][1]) > slack);
  return far ? [within[0], far] : null;
}

const haloed = (d) => [svg("path", {d, class: "halo"}), svg("path", {d, class: "line"})];
const lineMark = (ends) => ends ? haloed(`M${ends[0]}L${ends[1]}`) : [];

function pointMark([x, y]) {
  const near = 1.2 * unit, far = 3.2 * unit;
  return haloed(`M${x - far} ${y}H${x - near}M${x + near} ${y}H${x + far}M${x} ${y - far}V${y - near}M${x} ${y + near}V${y + far}`);
}

// The epipole, where the other camera is visible; every epipolar line passes through it. Nothing if
// it is outside the picture.
function epipoleMark(side) {
  if (!manifest.epipoles) return [];
  const [x, y, w] = manifest.epipoles[side], at = [x / w, y / w];
  if (!(at[0] >= 0 && at[0] <= width && at[1] >= 0 && at[1] <= height)) return [];
  return haloed(`M${at[0] - unit} ${at[1] - unit}h${2 * unit}v${2 * unit}h${-2 * unit}z`);
}

function showPoint() {
  const {side, at} = point, other = otherSide[side], match = matches[point.match];
  const ends = constraint && insidePicture(epipolarLine(side, at));
  layers[side].point.replaceChildren(...pointMark(at), ...epipoleMark(side));
  layers[other].point.replaceChildren(...lineMark(ends), ...(match ? pointMark(match[other]) : []), ...epipoleMark(other));
  byId("readout").textContent = told(side, at, match, ends);
  showChosenLink();
}

const pixels = (value) => value.toFixed(2).replace("-", "−");

// The line's equation as text: "−0.27 x − 0.96 y + 335.7 = 0"
function lineText(line) {
  const digits = line.map((value) => Number(Math.abs(value).toPrecision(5)).toString());
  return `${line[0] < 0 ? "−" : ""}${digits[0]} x ${line[1] < 0 ? "−" : "+"} ${digits[1]} y ${line[2] < 0 ? "−" : "+"} ${digits[2]} = 0`;
}
const placeText = ([x, y]) => `(${pixels(x)}, ${pixels(y)})`;

function told(side, at, match, ends) {
  const where = match ? `Match ${point.match + 1} of ${matches.length}: ${side} ${placeText(at)}, ${otherSide[side]} ${placeText(match[otherSide[side]])}.` : `${side === "left" ? "Left" : "Right"} ${placeText(at)}.`;
  if (!constraint) return `${where} There is no line: ${manifest.pair_is.sentence}.`;
  const line = ends ? `Its line in the other picture: ${lineText(epipolarLine(side, at))}.` : "Its line is outside the other picture.";
  const planted = match?.planted_outlier ? " It was added as an outlier." : "";
  const ratio = match?.ratio === undefined ? "" : ` Its ratio to the second nearest is ${match.ratio.toFixed(2)}.`;
  return match ? `${where} ${line} Sampson's distance ${match.sampson_px.toPrecision(3)} px: ${match.inlier ? "an inlier" : "not an inlier"}.${planted}${ratio}` : `${where} ${line}`;
}

function movePoint(side, [x, y]) {
  Object.assign(point, {side, at: [clamp(x, 0, width), clamp(y, 0, height)], match: -1});
  showPoint();
}

// Goes to the previous or next of the shown matches, in the picture that has the point.
function stepMatch(step) {
  const count = matches.length;
  for (let i = 1; i <= count; i++) {
    const next = ((point.match < 0 && step < 0 ? 0 : point.match) + step * i + count * (i + 1)) % count;
    if (!isShown(matches[next])) continue;
    Object.assign(point, {match: next, at: matches[next][point.side]});
    return showPoint();
  }
}

function pressed(side, event) {
  const by = event.shiftKey ? 10 : 1, steps = {ArrowLeft: [-by, 0], ArrowRight: [by, 0], ArrowUp: [0, -by], ArrowDown: [0, by]};
  const step = steps[event.key], jump = {n: 1, p: -1}[event.key.toLowerCase()];
  if (event.ctrlKey || event.altKey || event.metaKey || !(step || jump)) return;
  event.preventDefault();
  if (point.side !== side) Object.assign(point, {side, at: point.match >= 0 ? matches[point.match][side] : point.at});
  if (jump) stepMatch(jump);
  else movePoint(side, [point.at[0] + step[0], point.at[1] + step[1]]);
}

function pictureOf(side, name) {
  const layer = layers[side] = {matches: svg("g", {}), point: svg("g", {})};
  const drawing = svg("svg", {viewBox: `0 0 ${width} ${height}`, "aria-hidden": "true"}, layer.matches, layer.point);
  const image = element("img", {src: manifest.pictures[side], alt: "", width, height, draggable: false});
  const frame = element("div", {className: width < 480 ? "picture small" : "picture", tabIndex: 0, role: "application", id: side,
    ariaLabel: `The ${side} picture: arrow keys move the point, N and P go from match to match`}, image, drawing);
  const moved = (event) => {
    const box = frame.getBoundingClientRect();
    movePoint(side, [(event.clientX - box.left) * width / box.width, (event.clientY - box.top) * height / box.height]);
  };
  frame.addEventListener("pointermove", moved);
  frame.addEventListener("pointerdown", moved);
  frame.addEventListener("keydown", (event) => pressed(side, event));
  return element("div", {}, element("h3", {}, name), frame);
}

// Gives marks the same size on the screen, whatever the picture's scale.
function fitMarks() {
  unit = 5 * width / Math.max(byId("left").clientWidth, 1);
  showMatches();
  showPoint();
}

function setUpPictures() {
  layers.links = svg("g", {});
  layers.chosenLink = svg("g", {});
  byId("pair").append(...sides.map((side) => pictureOf(side, manifest.picture_names[side])),
    svg("svg", {id: "links", "aria-hidden": "true"}, layers.links, layers.chosenLink));
  byId("connected").checked = Boolean(manifest.found);
  byId("connected").addEventListener("change", fitMarks);
  for (const radio of document.querySelectorAll("#shown input")) radio.addEventListener("change", showMatches);
  byId("previous").addEventListener("click", () => stepMatch(-1));
  byId("next").addEventListener("click", () => stepMatch(1));
  new ResizeObserver(fitMarks).observe(byId("left"));
  fitMarks();
  stepMatch(1);
}

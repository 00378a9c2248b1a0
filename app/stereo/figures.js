// The maps, each with its key.

const capitalised = (text) => text.slice(0, 1).toUpperCase() + text.slice(1);
// A minus sign that is as wide as a plus.
const signed = (value, digits) => {
  const text = Math.abs(value).toFixed(digits);
  return Number(text) === 0 ? text : (value < 0 ? "−" : "+") + text;
};
const percentOf = (part, whole) => `${(whole ? 100 * part / whole : 0).toFixed(2)} %`;

function enlarge(name, title, alt) {
  byId("large-title").textContent = title;
  Object.assign(byId("large-picture"), {src: manifest.pictures[name], alt});
  byId("large").showModal();
}

function pictureButton(name, title, alt) {
  const button = element("button", {type: "button", className: "enlarge", ariaLabel: `${title}: open in full size`}, picture(name, alt));
  button.addEventListener("click", () => enlarge(name, title, alt));
  return button;
}

function swatches(entries) {
  return element("ul", {className: "key"}, ...entries.map(([colour, text]) => {
    const swatch = element("i", {ariaHidden: "true"});
    swatch.style.background = colour;
    return element("li", {}, swatch, text);
  }));
}

function ramp(colours, low, high) {
  const bar = element("i", {ariaHidden: "true"});
  bar.style.background = `linear-gradient(to right, ${colours.join(", ")})`;
  return element("div", {className: "ramp"}, element("span", {}, low), bar, element("span", {}, high));
}

function figure(title, names, alt, ...below) {
  const buttons = names.map(([name, part]) => pictureButton(name, part ? `${title}: ${part}` : title, part ? `${alt}: ${part}` : alt));
  const shown = buttons.length === 1 ? buttons[0] : element("div", {className: "two"}, ...buttons);
  return element("figure", {}, element("h3", {}, title), shown, ...below);
}

const caption = (text) => element("figcaption", {}, text);
const verdict = (about) => capitalised(manifest.verdicts.find((one) => one.about === about)?.text ?? "");

function disparityFigure() {
  const {limit, colours} = manifest.scales.disparity;
  const {left, histogram} = manifest.disparity;
  const bars = histogram.counts.length ? [chart(histogramLabel(), histogramChart)] : [];
  const note = histogram.counts.length
    ? `${percentOf(left.too_near, left.drawn)} of what the left eye sees is nearer than the budget allows, ${percentOf(left.too_far, left.drawn)} is farther: both are striped. Bars grow with the square root of their share.`
    : "Nothing is drawn.";
  return figure("Disparity of the left eye's pixels", [["disparity"]], "A map of parallax, orange in front of the window, blue behind it",
    ramp(colours, `${signed(-limit, 1)} px`, `${signed(limit, 1)} px`), swatches([["#585c64", "nothing drawn"]]), ...bars, caption(note));
}

function cutFigure() {
  const cuts = manifest.window_violations;
  const rows = cuts.slice(0, 12).map((one) => [one.eye, [one.left_edge && "left", one.right_edge && "right"].filter(Boolean).join(", "),
    one.rows, signed(one.least_px, 1), one.nearest.toPrecision(4), one.what]);
  const rest = cuts.length > rows.length ? [caption(`And ${count(cuts.length - rows.length, "smaller piece")}.`)] : [];
  return figure("In front of the window and cut by an edge", [["cut_left", "left eye"], ["cut_right", "right eye"]], "The picture in grey, pieces that an edge cuts in red",
    element("div", {className: "scroll"}, table(["eye", "edge", "rows", "px", "distance", "what"], ["", "", "number", "number", "number", "words"], rows)), ...rest);
}

function oneEyeFigure() {
  return figure("Seen by one eye only", [["one_eye_left", "left eye"], ["one_eye_right", "right eye"]], "The picture in grey, what only this eye sees in colour",
    swatches([["#e67e14", "hidden from the other"], ["#468ce1", "outside its picture"], ["#d73cbe", "missing there"]]),
    caption(verdict("seen by one eye")));
}

function figures() {
  const {pictures, scales, anaglyph} = manifest;
  const all = [disparityFigure()];
  if (pictures.cut_left) all.push(cutFigure());
  all.push(oneEyeFigure());
  all.push(figure("Rivalry", [["rivalry"]], "A map of luminance rivalry of the left eye's colours",
    ramp(scales.heat, "0 alike", "1 opposite"), caption(verdict("rivalry"))));
  if (pictures.ghosts) {
    all.push(figure("Ghosts", [["ghosts"]], "A map of the other eye's light that leaks into an eye",
      ramp(scales.heat, "0 %", `${(100 * scales.ghost_limit).toFixed(1)} % of white`), caption(`The larger of both eyes. ${verdict("ghosts")}`)));
  }
  all.push(figure("Stereo information", [["information"]], "The left picture in grey, edges in colour",
    swatches([["#e67e14", "edges that the eyes see at different places"], ["#468ce1", "edges in the window's plane"]]),
    caption(verdict("stereo information"))));
  return all;
}

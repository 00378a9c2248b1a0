// The condition numbers, laid out.

const short = (value) => value === null ? "unknown" : Number(value.toPrecision(3)).toString();
const condition = (value) => value === null ? "∞" : Number(value.toPrecision(4)).toString();
const bounded = ({bound, unit}) => bound === null ? "none" : `${short(bound)} ${unit}`;
const onScreen = ({pixels, unit}) => pixels === null && unit !== "px" ? "–" : `${short(pixels)} px`;
const mark = ({passes}) => passes ? "passes" : "";

function overview() {
  const rows = manifest.numbers.map((one) => [element("a", {href: `#${one.key}`}, one.name), condition(one.condition), bounded(one),
    onScreen(one), one.worst ? one.worst.text : "the whole picture"]);
  return table(["", "condition", "bound", "on the screen", "worst at"], ["", "number", "number", "number", ""], rows, (at) => mark(manifest.numbers[at]));
}

// A chart with bars from a millionth of a pixel to a thousand, by powers of ten. The line marks one
// pixel.
function bars() {
  const lowest = -6, highest = 3;
  const share = (pixels) => 100 * clamp((Math.log10(Math.max(pixels, 1e-300)) - lowest) / (highest - lowest), 0, 1);
  const shown = manifest.numbers.filter(({pixels, passes}) => pixels !== null || passes);
  if (!shown.length) return [];
  const cells = shown.flatMap((one) => {
    const bar = element("div", {className: `bar ${mark(one)}`, role: "img", ariaLabel: `${one.name}: ${onScreen(one)}`}, element("span", {}), element("i", {}));
    bar.firstChild.style.width = `${one.pixels === null ? 100 : share(one.pixels)}%`;
    bar.lastChild.style.left = `${share(1)}%`;
    return [element("span", {}, one.name), bar, element("span", {className: "number"}, onScreen(one))];
  });
  return [element("figcaption", {}, "Largest error on the screen, in powers of ten; the line is at one pixel"), element("div", {className: "scale"}, ...cells)];
}

function part(one) {
  const at = one.worst, command = at && at.command ? element("code", {}, at.command) : null;
  const where = at ? element("span", {}, at.text, command) : "the whole picture";
  const pairs = [["condition", condition(one.condition)], ["bound", bounded(one)], ["on the screen", onScreen(one)],
    ["formula", one.formula], ["source", one.source], ["worst at", where], ["in the picture", one.seen], ["what to do", one.advice]];
  const heading = element("h2", {}, one.name, one.passes ? element("span", {className: "passes"}, "  – more than a pixel or a texel") : null);
  return element("section", {id: one.key, className: mark(one)}, heading, element("dl", {}, ...terms(pairs)));
}

document.title = `${manifest.scene}: glassbox study stiffness`;
byId("title").textContent = `What decides how exact ${manifest.scene} is`;
byId("summary").textContent = `${manifest.width} × ${manifest.height}`;
byId("overview").append(overview());
byId("chart").append(...bars());
byId("chart").hidden = !byId("chart").children.length;
byId("numbers").append(...manifest.numbers.map(part));
byId("left-out").append(...manifest.left_out.map((one) => element("li", {}, one)));
byId("program").textContent = manifest.program;
byId("command").textContent = manifest.command;

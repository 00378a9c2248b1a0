// The picture with an ellipse for each region, and the results of the rules for the picked one.

const {regions} = manifest;
const why = {
  whole: "it touches the picture's border",
  size: "it is too small",
  prototypes: "too few of its pixels have prototype colours",
  others: "too many of its pixels have a fourth colour",
  areas: "the areas of its colours are not those of concentric discs",
  centroids: "its colours have several centres",
  spread: "its colours are spread equally",
  ranks: "its colours have another order by area than by spread",
  sheet: "its code is not on the wall",
};
const kindOf = (region) => region.broken ? "none" : region.agrees === false ? "odd" : "glyph";
const kinds = {glyph: "a glyph", odd: "a glyph that disagrees with the camera", none: "none"};
const shown = (value, digits = 2) => value.toFixed(digits).replace("-", "−");
const svg = (tag, attributes, ...children) => {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
};
let marks = [], rows = [];

function pick(at) {
  const region = regions[at];
  marks.forEach((mark, i) => mark.classList.toggle("picked", i === at));
  rows.forEach((row, i) => row.classList.toggle("picked", i === at));
  byId("readout").textContent = region.broken ? `No glyph: ${why[region.broken]}.`
    : `Glyph ${region.identity}: ${region.code}, from the inside out.` + (region.agrees === false ? " The camera disagrees with it." : "");
  byId("facts").replaceChildren(...terms([
    ["centre", `${shown(region.x)}, ${shown(region.y)} px`],
    ["diameter", `${shown(region.diameter_px, 1)} px, ${shown(region.across_px, 1)} px across`],
    ["code by its colours", region.identity < 0 ? "nothing" : `${region.identity}: ${region.code}`],
    ["prototype colours", `${shown(100 * region.classified, 0)} % of its pixels`],
    ["other colours", `${shown(100 * region.others, 1)} % of these`],
    ["shares", region.shares.map((share) => `${shown(100 * share, 0)} %`).join(", ")],
    ["distance of centres", `${shown(region.apart_px)} px`],
    ["position on the wall", region.world && `${region.world.map((value) => shown(value, 3)).join(", ")} m`],
  ]));
}

// The axes of a filled ellipse that has these second moments.
function ellipse({x, y, moments: [a, b, d]}) {
  const middle = (a + d) / 2, half = Math.hypot((a - d) / 2, b);
  const turn = Math.atan2(2 * b, a - d) / 2 * 180 / Math.PI;
  return svg("ellipse", {cx: x, cy: y, rx: 2 * Math.sqrt(middle + half), ry: 2 * Math.sqrt(Math.max(middle - half, .01)),
    transform: `rotate(${turn} ${x} ${y})`});
}

function setUpPicture() {
  marks = regions.map((region, at) => {
    const mark = svg("a", {class: kindOf(region), tabindex: 0, role: "button",
      "aria-label": region.broken ? `no glyph: ${why[region.broken]}` : `glyph ${region.identity}`}, ellipse(region));
    mark.addEventListener("click", () => pick(at));
    mark.addEventListener("keydown", (event) => { if (event.key === "Enter" || event.key === " ") { event.preventDefault(); pick(at); } });
    return mark;
  });
  const {width, height, uri} = manifest;
  byId("picture").append(svg("svg", {viewBox: `0 0 ${width} ${height}`, role: "group", "aria-label": "The picture, with its regions"},
    svg("image", {href: uri, width, height}), ...marks));
  const colours = {glyph: "currentColor", odd: "#ffb000", none: "currentColor"};
  byId("legend").append(...Object.entries(kinds).map(([kind, text]) => {
    const ring = element("i", {ariaHidden: "true"});
    ring.style.borderColor = colours[kind];
    ring.style.borderStyle = kind === "glyph" ? "solid" : "dashed";
    return element("span", {}, ring, `${text}: ${regions.filter((region) => kindOf(region) === kind).length}`);
  }));
}

function setUpTable() {
  const made = table(["", "what", "x", "y", "px across", "colours"], ["number", "", "number", "number", "number", ""],
    regions.map((region, at) => {
      const button = element("button", {type: "button", ariaLabel: `pick region ${at + 1}`}, String(at + 1));
      button.addEventListener("click", () => pick(at));
      return [button, region.broken ? `none (${region.broken})` : region.identity, shown(region.x, 1), shown(region.y, 1), shown(region.across_px, 1), region.code];
    }));
  byId("table").append(made);
  rows = [...made.querySelectorAll("tbody tr")];
}

document.title = `${manifest.picture}: glassbox views glyphs`;
byId("title").textContent = manifest.picture;
byId("summary").textContent = `${count(manifest.glyphs, "glyph")} in ${count(regions.length, "region")}`;
byId("text").textContent = manifest.text;
byId("program").textContent = manifest.program;
byId("command").textContent = manifest.command;
setUpPicture();
setUpTable();
document.body.dataset.ready = "yes";

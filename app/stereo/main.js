// The report, laid out.

const shortNumber = (value) => value === "inf" ? "∞" : value === "-inf" ? "−∞" : value === null ? "–" : Number(value.toPrecision(5)).toString();
const fixed = (value, digits) => typeof value === "number" ? signed(value, digits) : shortNumber(value);

function parallaxTable() {
  const {budget_percent: budget} = manifest.disparity;
  const rows = manifest.parallax.map((row) => {
    const seen = row.name.endsWith("seen");
    const percent = element("span", {className: seen && Math.abs(row.percent_of_width) > budget ? "too-much" : ""}, `${fixed(row.percent_of_width, 2)} %`);
    const mm = element("span", {className: seen && row.diverges ? "too-much" : ""}, `${fixed(row.display_mm, 1)} mm`);
    return [row.name, shortNumber(row.distance), `${fixed(row.px, 2)} px`, percent, mm, `${fixed(row.display_degrees, 2)}°`];
  });
  return table(["", "distance", "parallax", "of the width", "on the display", "angle"], ["", ...Array(5).fill("number")], rows);
}

function methodsTable() {
  const {methods, method: chosen, measured_lenses: measured} = manifest.anaglyph;
  const rows = methods.map((one) => [one.method, one.mean_rivalry.toFixed(3), measured ? `${(100 * one.mean_ghost).toFixed(2)} %` : "–"]);
  return table(["method", "mean rivalry", "mean ghost"], ["", "number", "number"], rows, (at) => methods[at].method === chosen ? "chosen" : "");
}

function adviceItem({text, options}) {
  return element("li", {}, text, options.length ? element("code", {}, options.join(" ")) : null);
}

function showWords() {
  const signs = {good: "✓", warning: "!", bad: "✗", fact: "·"}, spoken = {good: "good: ", warning: "warning: ", bad: "bad: ", fact: ""};
  for (const {about, level, text} of manifest.verdicts) {
    const term = element("dt", {}, capitalised(about));
    term.dataset.level = level;
    term.dataset.sign = signs[level];
    byId("verdicts").append(term, element("dd", {className: level}, element("span", {className: "hidden"}, spoken[level]), capitalised(text)));
  }
  const items = manifest.advice.map(adviceItem);
  byId("advice-list").append(...items);
  if (!items.length) byId("advice-list").replaceWith(element("p", {}, "Nothing."));
}

const {eyes} = manifest;
document.title = `${manifest.scene}: glassbox stereo`;
byId("title").textContent = manifest.scene;
byId("summary").textContent = `${manifest.width} × ${manifest.height}, ${eyes.projection}; eyes ${shortNumber(eyes.separation)} apart (${eyes.separation_is_from}), window at ${shortNumber(eyes.window)} (${eyes.window_is_at})`;
showWords();
setUpEyes();
byId("parallax-table").append(parallaxTable());
byId("figures").append(...figures());
byId("methods-table").append(methodsTable());
if (manifest.anaglyph.recolour) {
  byId("curve").append(element("h3", {}, "Or other colours"), chart(compromiseLabel(), compromiseChart),
    caption("The scene's colours, desaturated and brightened: the smallest change of colours for each rivalry. The marked point meets the target."));
}
byId("close-large").addEventListener("click", () => byId("large").close());
byId("program").textContent = manifest.program;
byId("command").textContent = manifest.command;
drawCharts();

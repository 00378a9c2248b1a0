// The page: a section for each experiment.

const charts = [];
let wantedThreads = 1;

const terms = (pairs) => pairs.filter(([, text]) => text).flatMap(([term, text]) => [element("dt", {}, term), element("dd", {}, text)]);

function rowOf(experiment, each, scenes, threads) {
  const cells = [[each.series, ""], ...(scenes ? [[each.scene, ""]] : []), [digits(each.parameter, 6), "number"], [digits(each.error), "number"]];
  const theory = each.predicted_error !== null;
  cells.push([theory ? digits(each.predicted_error) : "", "number"], [theory ? digits(each.ratio) : "", "number" + (each.finding ? " fails" : "")]);
  const unit = timeUnit(experiment);
  for (const count of threads) {
    const time = timeOf(each, count);
    cells.push([time ? digits(time.ns / unit.ns) : "", "number"], [time ? time.ns_quartiles.map((ns) => digits(ns / unit.ns)).join(" to ") : "", "number"]);
  }
  cells.push([[each.times[0]?.standing, each.finding ? "finding" : ""].filter(Boolean).join(", "), ""]);
  return element("tr", {className: each.times[0]?.standing ?? ""}, ...cells.map(([text, className]) => element("td", {className}, text)));
}

function tableOf(experiment) {
  const scenes = scenesOf(experiment).some(Boolean), threads = threadsOf(experiment), unit = timeUnit(experiment);
  const heads = ["configuration", ...(scenes ? ["scene"] : []), experiment.axis_unit || "axis", withUnit("error", experiment.error_unit), "theory", "error / theory",
    ...threads.flatMap((each) => [`${unit.name} a ${experiment.item}, ${count(each, "thread")}`, "quartiles"]), ""];
  const numbers = (i) => i > (scenes ? 1 : 0) && i < heads.length - 1 ? "number" : "";
  return element("table", {}, element("thead", {}, element("tr", {}, ...heads.map((head, i) => element("th", {scope: "col", className: numbers(i)}, head)))),
    element("tbody", {}, ...experiment.configurations.map((each) => rowOf(experiment, each, scenes, threads))));
}

// Each explanation once, with what it explains.
function findingsOf({configurations}) {
  const found = configurations.filter(({finding}) => finding);
  const items = [...new Set(found.map(({explanation}) => explanation))].map((text) => {
    const places = found.filter(({explanation}) => explanation === text).map((each) => `${each.series} at ${digits(each.parameter, 6)} (ratio ${digits(each.ratio)})`);
    return element("li", {}, element("strong", {className: "fails"}, "Finding: "), text || "not explained.", ` Here: ${places.join("; ")}.`);
  });
  return items.length ? element("ul", {className: "findings"}, ...items) : null;
}

function figure(name, caption) {
  const canvas = element("canvas", {role: "img", ariaLabel: `${caption}; the table below has the same numbers`});
  canvas.dataset.chart = name;
  return element("figure", {}, element("figcaption", {}, caption), element("div", {className: "plot"}, canvas));
}

function section(experiment) {
  const {id, name, question, reference, theory, command} = experiment, figures = [];
  if (threadsOf(experiment).length) figures.push(figure("time", "Error against time"));
  figures.push(figure("axis", "Error against the axis"));
  return element("section", {id, ariaLabel: id},
    element("h2", {}, `${id} ${name}`),
    element("p", {className: "question"}, question),
    element("dl", {className: "about"}, ...terms([["Axis", withUnit(experiment.axis, experiment.axis_unit)],
      ["Error", withUnit(experiment.error, experiment.error_unit)], ["Reference", reference], ["Theory", theory]])),
    element("div", {className: "charts"}, ...figures),
    findingsOf(experiment),
    element("details", {open: true}, element("summary", {}, "Numbers"), element("div", {className: "scroll"}, tableOf(experiment))),
    element("code", {}, command));
}

function drawAll(theme) {
  for (const chart of charts.splice(0)) chart.destroy();
  for (const experiment of manifest.experiments) {
    const threads = shownThreads(experiment, wantedThreads);
    for (const canvas of byId(experiment.id).querySelectorAll("canvas")) {
      const data = canvas.dataset.chart === "time" ? timeData(theme, experiment, threads) : axisData(theme, experiment, threads);
      charts.push(draw(canvas, theme, experiment, threads, data));
    }
  }
}

function showContents() {
  byId("contents").append(...manifest.experiments.map((each) => {
    const found = each.configurations.filter(({finding}) => finding).length;
    return element("li", {}, element("a", {href: `#${each.id}`}, `${each.id} ${each.name}`), found ? ` (${count(found, "finding")})` : "");
  }));
  byId("summary").textContent = `${count(manifest.experiments.length, "experiment")}; ${manifest.machine}; ${manifest.effort} run`;
  byId("origin").append(...terms([["Machine", manifest.machine], ["Compiler", manifest.compiler], ["Flags", manifest.flags], ["Glassbox", manifest.version],
    ["Effort", manifest.effort], ["Threads", `up to ${manifest.threads}`]]));
  byId("command").textContent = manifest.command;
}

function showThreads() {
  const all = [...new Set(manifest.experiments.flatMap(threadsOf))].sort((a, b) => a - b);
  if (all.length < 2) return byId("threads").remove();
  byId("threads").append(...all.map((threads) => {
    const input = element("input", {type: "radio", name: "threads", value: threads, checked: threads === 1,
      onchange: () => { wantedThreads = threads; drawAll(theme()); }});
    return element("label", {}, input, element("span", {}, `Times with ${count(threads, "thread")}`));
  }));
}

const dark = matchMedia("(prefers-color-scheme: dark)");
const theme = () => dark.matches ? themes.dark : themes.light;

showContents();
byId("experiments").append(...manifest.experiments.map(section));
showThreads();
drawAll(theme());
dark.addEventListener("change", () => drawAll(theme()));
// Paper is white, and as wide as it is.
addEventListener("beforeprint", () => {
  drawAll(themes.light);
  for (const chart of charts) chart.resize(660, 330);
});
addEventListener("afterprint", () => drawAll(theme()));

// The page: a table of all cases, each in full below it, a chart for each sweep.

const charts = [];
const errorOf = ({error, bound}) => `${digits(error)} ${number(error) <= number(bound) ? "≤" : ">"} ${digits(bound)}`;
const ratioOf = ({error, bound}) => number(bound) > 0 ? digits(number(error) / number(bound)) : "";
const caught = ({mutants}) => mutants.filter(({passes}) => !passes).length;

function caseRow(each) {
  const {id, name, naive, ours, unit, mutants, holds} = each;
  const cells = [[element("a", {href: `#${id}`}, id), ""], [name, ""], [digits(naive.error), "number"], [digits(ours.error), "number"],
    [digits(ours.bound), "number"], [ratioOf(ours), "number"], [ours.condition === null ? "" : digits(ours.condition), "number"],
    [mutants.length ? `${caught(each)} of ${mutants.length}` : "none", "number"], [holds ? "pass" : "FAIL", holds ? "" : "fails"], [unit, ""]];
  return element("tr", {}, ...cells.map(([text, className]) => element("td", {className}, text)));
}

function caseTable() {
  const heads = ["case", "", "naive error", "our error", "bound", "ratio", "condition", "mutants caught", "", "unit"];
  return element("table", {}, element("thead", {}, element("tr", {}, ...heads.map((head) => element("th", {scope: "col"}, head)))),
    element("tbody", {}, ...manifest.cases.map(caseRow)));
}

const terms = (pairs) => pairs.filter(([, text]) => text).flatMap(([term, text]) => [element("dt", {}, term), element("dd", {}, text)]);
const subjectText = (subject, unit) => `${subject.name}: ${errorOf(subject)} ${unit}. ${subject.seen}`;

function caseSection({id, name, construction, stage, right, unit, oracle, ours, naive, mutants, pictures}) {
  return element("section", {id, ariaLabel: id},
    element("h2", {}, `${id} ${name}`),
    element("dl", {className: "about"}, ...terms([["Built", construction], ["Stage", stage], ["Right", right], ["Oracle", oracle],
      ["Ours", subjectText(ours, unit)], ["Naive", subjectText(naive, unit)], ...mutants.map((each) => ["Mutant", subjectText(each, unit)])])),
    element("div", {className: "pictures"}, ...pictures.map((picture) => element("figure", {},
      element("img", {src: `data:image/png;base64,${picture.png}`, alt: `${id}, ${picture.name}`}), element("figcaption", {}, picture.name)))));
}

// A sweep in the form of an experiment without times; its bound stands where the theory does.
function asExperiment(sweep) {
  const configurations = sweep.series.flatMap(({name, points}) => points.map(({parameter, error, bound}) => ({series: name, scene: "", parameter, error,
    predicted_error: bound, ratio: number(bound) > 0 ? number(error) / number(bound) : 0, finding: false, times: []})));
  return {...sweep, id: sweep.name, item: "", logarithmic_axis: true, configurations};
}

// A cross where a series is of no use any more.
function limitsOf(sweep, {x, y, datasets}, theme) {
  const experiment = asExperiment(sweep);
  return sweep.series.filter(({gives_up: at}) => at !== null).map((series) => {
    const point = series.points.find(({parameter}) => parameter === series.gives_up), style = styleOf(theme, experiment, series.name, "");
    const data = [{x: x.place(number(point.parameter)), y: y.place(number(point.error)), configuration: experiment.configurations.find(
      (each) => each.series === series.name && each.parameter === point.parameter)}];
    return {data, key: series.name, showLine: false, pointStyle: "crossRot", pointRadius: 14, pointBorderWidth: 3, pointBorderColor: style.colour, order: -1};
  });
}

function sweepTable({series, axis, axis_unit: unit, error_unit: errorUnit}) {
  const heads = ["", withUnit(axis, unit), withUnit("error", errorUnit), "bound"];
  const rows = series.flatMap(({name, points}) => points.map((point) => [name, digits(point.parameter, 6), digits(point.error),
    point.bound === null ? "" : digits(point.bound)]));
  return element("table", {}, element("thead", {}, element("tr", {}, ...heads.map((head) => element("th", {scope: "col"}, head)))),
    element("tbody", {}, ...rows.map((row) => element("tr", {}, ...row.map((text, i) => element("td", {className: i ? "number" : ""}, text))))));
}

function sweepSection(sweep) {
  const canvas = element("canvas", {role: "img", ariaLabel: `${sweep.title}; the table below has the same numbers`});
  const limits = sweep.series.map(({name, ours, gives_up: at}) => element("li", {}, `${name}${ours ? " (ours)" : ""}: `
    + (at === null ? "never gives up" : `gives up at ${digits(at)}`)));
  return element("section", {id: sweep.name, ariaLabel: sweep.title},
    element("h2", {}, sweep.title),
    element("p", {className: "question"}, sweep.question),
    element("dl", {className: "about"}, ...terms([["Error", withUnit(sweep.error, sweep.error_unit)], ["Reference", sweep.reference],
      ["Bound", `${sweep.bound}; dashed in the chart`], ["Gives up", `${sweep.tolerance}; a cross in the chart`]])),
    element("figure", {}, element("div", {className: "plot"}, canvas)),
    element("ul", {className: "limits"}, ...limits),
    element("details", {}, element("summary", {}, "Numbers"), element("div", {className: "scroll"}, sweepTable(sweep))));
}

function drawAll(theme) {
  for (const chart of charts.splice(0)) chart.destroy();
  for (const sweep of manifest.sweeps) {
    const experiment = asExperiment(sweep), data = axisData(theme, experiment, undefined);
    data.datasets.push(...limitsOf(sweep, data, theme));
    charts.push(draw(byId(sweep.name).querySelector("canvas"), theme, experiment, undefined, data));
  }
}

const dark = matchMedia("(prefers-color-scheme: dark)");
const theme = () => dark.matches ? themes.dark : themes.light;

const hold = manifest.cases.filter(({holds}) => holds).length;
byId("summary").textContent = [manifest.cases.length ? `${hold} of ${count(manifest.cases.length, "case")} hold` : "",
  manifest.sweeps.length ? count(manifest.sweeps.length, "sweep") : ""].filter(Boolean).join("; ");
if (manifest.cases.length) byId("table").append(caseTable());
else byId("cases").remove();
byId("full").append(...manifest.cases.map(caseSection));
byId("experiments").append(...manifest.sweeps.map(sweepSection));
byId("left-out").append(...terms(manifest.left_out.map(({id, name, reason}) => [id, `${name}: ${reason}`])));
byId("command").textContent = manifest.command;
drawAll(theme());
dark.addEventListener("change", () => drawAll(theme()));
addEventListener("beforeprint", () => drawAll(themes.light));
addEventListener("afterprint", () => drawAll(theme()));

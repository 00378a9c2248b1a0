// The page: a table of all cases, each case in full below it, and a chart for each sweep.

const errorOf = ({error, bound}) => `${digits(error)} ${number(error) <= number(bound) ? "≤" : ">"} ${digits(bound)}`;
const ratioOf = ({error, bound}) => number(bound) > 0 ? digits(number(error) / number(bound)) : "";
const caught = (mutants) => mutants.filter(({passes}) => !passes).length;

function caseRow({id, name, naive, ours, unit, mutants, drawn, holds}) {
  return [element("a", {href: `#${id}`}, id), name, digits(naive.error), digits(ours.error), digits(ours.bound), ratioOf(ours),
    ours.condition === null ? "" : digits(ours.condition), mutants.length ? `${caught(mutants)} of ${mutants.length}` : "none",
    drawn.length ? `${drawn.filter(({passes}) => passes).length} of ${drawn.length}` : "",
    element("span", {className: holds ? "" : "fails"}, holds ? "pass" : "FAIL"), unit];
}

const caseTable = () => table(["case", "", "naive error", "our error", "bound", "ratio", "condition", "mutants caught", "drawn right", "", "unit"],
  ["", "", ...Array(7).fill("number"), "", ""], manifest.cases.map(caseRow));

const subjectText = (subject, unit) => `${subject.name}: ${errorOf(subject)} ${unit}. ${subject.seen}`;

function caseSection({id, name, construction, stage, right, unit, oracle, ours, naive, mutants, drawn, not_drawn: whyNot, pictures}) {
  return element("section", {id, ariaLabel: id},
    element("h2", {}, `${id} ${name}`),
    element("dl", {className: "about"}, ...terms([["Built", construction], ["Stage", stage], ["Right", right], ["Oracle", oracle],
      ["Ours", subjectText(ours, unit)], ["Naive", subjectText(naive, unit)], ...mutants.map((each) => ["Mutant", subjectText(each, unit)]),
      ...drawn.map(({name, seen}) => ["Drawn", `${name}: ${seen}`]), ...(whyNot ? [["No picture", whyNot]] : [])])),
    element("div", {className: "pictures"}, ...pictures.map((picture) => element("figure", {},
      element("img", {src: `data:image/png;base64,${picture.png}`, alt: `${id}, ${picture.name}`}), element("figcaption", {}, picture.name)))));
}

// A sweep in the form of an experiment without times. Its bound takes the place of the theory.
function asExperiment(sweep) {
  const configurations = sweep.series.flatMap(({name, points, gives_up: end}) => points.map(({parameter, error, bound}) => ({series: name, scene: "",
    parameter, error, predicted_error: bound, ratio: number(bound) > 0 ? number(error) / number(bound) : 0, finding: false, times: [], gives_up: parameter === end})));
  return {...sweep, id: sweep.name, item: "", logarithmic_axis: true, configurations};
}

function sweepTable({series, axis, axis_unit: unit, error_unit: errorUnit}) {
  const rows = series.flatMap(({name, points}) => points.map(({parameter, error, bound}) => [name, digits(parameter, 6), digits(error), bound === null ? "" : digits(bound)]));
  return table(["", withUnit(axis, unit), withUnit("error", errorUnit), "bound"], ["", "number", "number", "number"], rows);
}

function sweepSection(sweep) {
  const limits = sweep.series.map(({name, ours, gives_up: at}) => element("li", {}, `${name}${ours ? " (ours)" : ""}: `
    + (at === null ? "never fails" : `fails at ${digits(at)}`)));
  return element("section", {id: sweep.name, ariaLabel: sweep.title},
    element("h2", {}, sweep.title),
    element("p", {className: "question"}, sweep.question),
    element("dl", {className: "about"}, ...terms([["Error", withUnit(sweep.error, sweep.error_unit)], ["Reference", sweep.reference],
      ["Bound", `${sweep.bound}; dashed in the chart`], ["Fails at", `${sweep.tolerance}; a cross in the chart`]])),
    element("figure", {}, chart(`${sweep.title}; the table below has the same numbers`, (theme) => axisChart(theme, asExperiment(sweep)))),
    element("ul", {className: "limits"}, ...limits),
    element("details", {}, element("summary", {}, "Numbers"), element("div", {className: "scroll"}, sweepTable(sweep))));
}

const hold = manifest.cases.filter(({holds}) => holds).length;
byId("summary").textContent = [manifest.cases.length ? `${hold} of ${count(manifest.cases.length, "case")} hold` : "",
  manifest.sweeps.length ? count(manifest.sweeps.length, "sweep") : ""].filter(Boolean).join("; ");
if (manifest.cases.length) byId("table").append(caseTable());
else byId("cases").remove();
byId("full").append(...manifest.cases.map(caseSection));
byId("experiments").append(...manifest.sweeps.map(sweepSection));
byId("left-out").append(...terms(manifest.left_out.map(({id, name, reason}) => [id, `${name}: ${reason}`])));
byId("command").textContent = manifest.command;
drawCharts();

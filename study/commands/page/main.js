// The page: a section for each experiment.

let wantedThreads = 1;

function rowOf(experiment, each, scenes, threads) {
  const unit = timeUnit(experiment), theory = each.predicted_error !== null;
  const ratio = theory ? element("span", {className: each.finding ? "fails" : ""}, digits(each.ratio)) : "";
  const times = threads.flatMap((count) => {
    const time = timeOf(each, count);
    return time ? [digits(time.ns / unit.ns), time.ns_quartiles.map((ns) => digits(ns / unit.ns)).join(" to ")] : ["", ""];
  });
  return [each.series, ...(scenes ? [each.scene] : []), digits(each.parameter, 6), digits(each.error), theory ? digits(each.predicted_error) : "", ratio,
    ...times, [each.times[0]?.standing, each.finding ? "finding" : "", each.times.some(({disturbed}) => disturbed > 0) ? "disturbed" : ""].filter(Boolean).join(", ")];
}

function tableOf(experiment) {
  const {configurations} = experiment, scenes = scenesOf(experiment).some(Boolean), threads = threadsOf(experiment), unit = timeUnit(experiment);
  const heads = ["configuration", ...(scenes ? ["scene"] : []), experiment.axis_unit || "axis", withUnit("error", experiment.error_unit), "theory", "error / theory",
    ...threads.flatMap((each) => [`${unit.name} a ${experiment.item}, ${count(each, "thread")}`, "quartiles"]), ""];
  const kinds = heads.map((head, i) => i > (scenes ? 1 : 0) && i < heads.length - 1 ? "number" : "");
  return table(heads, kinds, configurations.map((each) => rowOf(experiment, each, scenes, threads)), (at) => configurations[at].times[0]?.standing ?? "");
}

const explains = ({explains: range, ratio}) => range && number(ratio) >= range[0] && number(ratio) <= range[1];
function explanationOf(each) {
  if (!each.explanation) return "not explained.";
  const known = `${each.explanation} (ratios from ${digits(each.explains[0])} to ${digits(each.explains[1])}).`;
  return explains(each) ? known : `not explained: the ratio is another one than the known reason explains: ${known}`;
}

// Each explanation once, with the configurations that it explains.
function findingsOf({configurations}) {
  const found = configurations.filter(({finding}) => finding);
  const items = [...new Set(found.map(explanationOf))].map((text) => {
    const places = found.filter((each) => explanationOf(each) === text).map((each) => `${each.series} at ${digits(each.parameter, 6)} (ratio ${digits(each.ratio)})`);
    return element("li", {}, element("strong", {className: "fails"}, "Finding: "), text, ` Found at: ${places.join("; ")}.`);
  });
  return items.length ? element("ul", {className: "findings"}, ...items) : null;
}

function figure(caption, experiment, makeChart) {
  return element("figure", {}, element("figcaption", {}, caption), chart(`${caption}; the table below has the same numbers`,
    (theme) => makeChart(theme, experiment, shownThreads(experiment, wantedThreads))));
}

// The charts and the table of one measure.
function measured(part, several) {
  const figures = [], name = part.measure || "error", title = name[0].toUpperCase() + name.slice(1);
  if (threadsOf(part).length) figures.push(figure(`${title} against time`, part, timeChart));
  figures.push(figure(`${title} against the axis`, part, axisChart));
  return [several ? element("h3", {}, title) : null,
    element("dl", {className: "about"}, ...terms([["Axis", withUnit(part.axis, part.axis_unit)],
      ["Error", withUnit(part.error, part.error_unit) + (part.more_is_better ? "; more is better" : "")]])),
    element("div", {className: "charts"}, ...figures),
    element("details", {open: true}, element("summary", {}, "Numbers"), element("div", {className: "scroll"}, tableOf(part)))].filter(Boolean);
}

// The machine's load and clock rate when measuring began; empty if the system did not report them.
const stateOf = ({load, mhz}) => [Number.isFinite(number(load)) ? `load ${digits(load, 2)}` : "", number(mhz) > 0 ? `${digits(mhz, 4)} MHz` : ""].filter(Boolean).join(", ");

function section(experiment) {
  const {id, name, question, reference, theory, command} = experiment, parts = byMeasure(experiment);
  return element("section", {id, ariaLabel: id},
    element("h2", {}, `${id} ${name}`),
    element("p", {className: "question"}, question),
    element("dl", {className: "about"}, ...terms([["Reference", reference], ["Theory", theory], ["Machine", stateOf(experiment)]].filter(([, text]) => text))),
    ...parts.flatMap((part) => measured(part, parts.length > 1)),
    findingsOf(experiment),
    element("code", {}, command));
}

function showContents() {
  byId("contents").append(...manifest.experiments.map((each) => {
    const found = each.configurations.filter(({finding}) => finding).length;
    return element("li", {}, element("a", {href: `#${each.id}`}, `${each.id} ${each.name}`), found ? ` (${count(found, "finding")})` : "");
  }));
  byId("summary").textContent = `${count(manifest.experiments.length, "experiment")}; ${manifest.machine}; ${manifest.effort} run`;
  byId("origin").append(...terms([["Machine", manifest.machine], ["Instructions", manifest.target], ["Caches", manifest.caches || "unknown"], ["Compiler", manifest.compiler], ["Flags", manifest.flags], ["Glassbox", manifest.version],
    ["Effort", manifest.effort], ["Threads", `up to ${manifest.threads}`]]));
  byId("command").textContent = manifest.command;
}

function showThreads() {
  const all = [...new Set(manifest.experiments.flatMap(threadsOf))].sort((a, b) => a - b);
  if (all.length < 2) return byId("threads").remove();
  byId("threads").append(...all.map((threads) => {
    const input = element("input", {type: "radio", name: "threads", value: threads, checked: threads === 1,
      onchange: () => { wantedThreads = threads; drawCharts(); }});
    return element("label", {}, input, element("span", {}, `Times with ${count(threads, "thread")}`));
  }));
}

showContents();
byId("experiments").append(...manifest.experiments.map(section));
showThreads();
drawCharts();

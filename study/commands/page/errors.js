// The charts: error against time, and error against the axis.

const dominatedColour = "#8a8f98"; // for points that a competitor beats
// Each series has a colour and a shape.
const shapes = ["circle", "rect", "triangle", "rectRot", "star", "crossRot", "cross", "rectRounded"];
const dashes = [[], [8, 3], [2, 2], [8, 3, 2, 3]]; // for scenes

function styleOf(theme, experiment, series, scene) {
  const i = seriesOf(experiment).indexOf(series), j = scenesOf(experiment).indexOf(scene);
  return {colour: theme.series[i % theme.series.length], shape: shapes[i % shapes.length], dash: dashes[j % dashes.length]};
}

// The properties of a configuration, one per line.
function told(experiment, configuration, threads) {
  const {series, scene, parameter, error, predicted_error: predicted, ratio, finding} = configuration, lines = [[series, scene].filter(Boolean).join(", ")];
  lines.push(`${experiment.axis}: ${digits(parameter, 6)} ${experiment.axis_unit}`.trim());
  lines.push(`error: ${digits(error)} ${experiment.error_unit}`.trim());
  if (predicted !== null) lines.push(`theory: ${digits(predicted)}, ratio ${digits(ratio)}${finding ? ": a finding" : ""}`);
  const time = timeOf(configuration, threads);
  if (time) {
    const unit = timeUnit(experiment), [lower, upper] = time.ns_quartiles.map((ns) => digits(ns / unit.ns));
    lines.push(`${digits(time.ns / unit.ns)} ${unit.name} (${lower} to ${upper}) a ${experiment.item}, ${count(threads, "thread")}`);
    lines.push({front: "on the Pareto front", dominated: "dominated"}[time.standing]);
    if (time.disturbed > 0) lines.push("disturbed: another program used the machine meanwhile");
  }
  return lines;
}

const groups = (experiment) => experiment.configurations.reduce((all, each) => {
  const key = JSON.stringify([each.series, each.scene]);
  return all.set(key, [...(all.get(key) ?? []), each]);
}, new Map()).values();

function pointStyles(theme, style, configurations, threads) {
  const dominated = configurations.map((each) => timeOf(each, threads)?.standing === "dominated");
  const open = ["star", "cross", "crossRot"].includes(style.shape); // shapes without a filled inside
  return {
    pointStyle: style.shape, pointRadius: 6, pointHoverRadius: 8, pointHitRadius: 6,
    pointBackgroundColor: dominated.map((grey) => grey ? dominatedColour + "80" : style.colour),
    pointBorderColor: dominated.map((grey) => grey ? dominatedColour : open ? style.colour : theme.text),
    pointBorderWidth: open ? 2.5 : 1.2,
  };
}

// The legend with one entry per series, which hides and shows everything that belongs to the
// series.
function legend(datasets) {
  const named = datasets.filter(({label}, i) => label !== undefined && datasets.findIndex((other) => other.label === label) === i);
  return {
    position: "bottom",
    labels: {
      usePointStyle: true, boxHeight: 8,
      generateLabels: (chart) => named.map(({label, key, style}) => ({
        text: label, key, pointStyle: style.shape, fillStyle: style.colour, strokeStyle: style.colour, lineWidth: 1, fontColor: chart.options.color,
        hidden: !chart.isDatasetVisible(datasets.findIndex((other) => other.key === key))})),
    },
    onClick: (event, item, {chart}) => {
      datasets.forEach((each, i) => each.key === item.key && chart.setDatasetVisibility(i, item.hidden));
      chart.update();
    },
  };
}

const errorChart = (experiment, threads, x, y, datasets) => pointChart({
  x, y: titled(y, withUnit(experiment.measure || "error", experiment.error_unit)), datasets, legend: legend(datasets),
  told: ({configuration}) => told(experiment, configuration, threads)});

function timeChart(theme, experiment, threads) {
  const unit = timeUnit(experiment), timed = experiment.configurations.filter((each) => timeOf(each, threads));
  const time = (each) => timeOf(each, threads).ns / unit.ns, error = (each) => number(each.error);
  const quartiles = (each) => timeOf(each, threads).ns_quartiles.map((ns) => ns / unit.ns);
  const x = logarithmicAxis(timed.flatMap((each) => [time(each), ...quartiles(each)])), y = logarithmicAxis(timed.map(error));
  const at = (each) => ({x: x.place(time(each)), y: y.place(error(each)), configuration: each});
  const datasets = [];
  for (const group of groups({configurations: timed})) {
    const {series, scene} = group[0], style = styleOf(theme, experiment, series, scene);
    datasets.push({label: series, key: series, style, data: group.map(at), showLine: false, ...pointStyles(theme, style, group, threads)});
    // A bar from the lower to the upper quartile, with a gap before the next; dashed if the machine
    // was disturbed.
    const bar = (each) => [...quartiles(each).map((ns) => ({x: x.place(ns), y: y.place(error(each))})), {x: NaN, y: NaN}];
    for (const disturbed of [false, true]) {
      const own = group.filter((each) => timeOf(each, threads).disturbed > 0 === disturbed);
      datasets.push({key: series, data: own.flatMap(bar), showLine: true, spanGaps: false, borderColor: style.colour, borderWidth: 2, borderDash: disturbed ? [3, 3] : [],
        pointRadius: 0, pointHitRadius: 0, order: 1});
    }
  }
  const fronts = new Map(); // one for each group that competes
  for (const each of timed.filter((one) => timeOf(one, threads).standing === "front")) {
    const key = JSON.stringify([each.scene, experiment.axis_is_chosen ? 0 : each.parameter]);
    fronts.set(key, [...(fronts.get(key) ?? []), at(each)]);
  }
  for (const front of fronts.values()) {
    datasets.push({data: front.sort((a, b) => a.x - b.x || b.y - a.y), showLine: true, stepped: "before", borderColor: theme.quiet, borderWidth: 1,
      pointRadius: 0, pointHitRadius: 0, order: 1});
  }
  return errorChart(experiment, threads, titled(x, `${unit.name} a ${experiment.item}, ${count(threads, "thread")}`), y, datasets);
}

function axisChart(theme, experiment, threads) {
  const {configurations} = experiment, parameters = configurations.map((each) => number(each.parameter));
  const predicted = configurations.filter((each) => each.predicted_error !== null);
  const x = axisFor(parameters, experiment.logarithmic_axis);
  const y = logarithmicAxis([...configurations.map((each) => number(each.error)), ...predicted.map((each) => number(each.predicted_error))]);
  const byParameter = (a, b) => number(a.parameter) - number(b.parameter), datasets = [];
  const at = (each, value) => ({x: x.place(number(each.parameter)), y: y.place(number(value)), configuration: each});
  for (const unsorted of groups(experiment)) {
    const group = [...unsorted].sort(byParameter), {series, scene} = group[0], style = styleOf(theme, experiment, series, scene);
    const line = {borderColor: style.colour, backgroundColor: style.colour, showLine: true, key: series};
    datasets.push({...line, label: series, style, data: group.map((each) => at(each, each.error)), borderWidth: 2, borderDash: style.dash,
      ...pointStyles(theme, style, group, threads)});
    // A cross marks the point from which a series is no longer useful (in sweeps only).
    const ends = group.filter(({gives_up: end}) => end).map((each) => at(each, each.error));
    if (ends.length) datasets.push({...line, data: ends, showLine: false, pointStyle: "crossRot", pointRadius: 14, pointBorderWidth: 3, pointBorderColor: style.colour, order: -1});
    const theory = group.filter((each) => each.predicted_error !== null);
    if (!theory.length) continue;
    datasets.push({...line, data: theory.map((each) => at(each, each.predicted_error)), borderWidth: 1.5, borderDash: [3, 4],
      pointStyle: "line", pointRadius: theory.length === 1 ? 14 : 0, pointBorderColor: style.colour, pointHitRadius: 0, order: 1});
  }
  return errorChart(experiment, threads, titled(x, withUnit(experiment.axis, experiment.axis_unit)), y, datasets);
}

// The chart: a point for each way, in the colour and shape of the setting (knob) that it changes.

const knobs = {none: "as asked", samples: "samples", shading: "shading", filter: "texture filter", depth: "depth format",
  level: "level of detail", engine: "engine, same bytes", several: "several options"};
const shapes = ["star", "circle", "rect", "triangle", "rectRot", "rectRounded", "crossRot", "circle"];
const measures = {
  rms: {title: "RMS", axis: "root mean square error [1/255]", of: (point) => 255 * point.rms},
  flip: {title: "FLIP", axis: "mean of FLIP [0 to 1]", of: (point) => point.flip},
  wrong: {title: "Wrong pixels", axis: "pixels off by more than 8/255 [%]", of: (point) => 100 * point.wrong},
};
let shownMeasure = "rms";

const unit = timeUnit({configurations: manifest.points.map(({ns}) => ({times: [{ns}]}))});
const timeText = (ns) => `${digits(ns / unit.ns)} ${unit.name}`;
const usedKnobs = Object.keys(knobs).filter((knob) => manifest.points.some((point) => point.knob === knob));

// The lines shown for the point under the mouse.
function told(point) {
  const [lower, upper] = point.ns_quartiles;
  return [point.name, `RMS ${digits(255 * point.rms)}/255, FLIP ${digits(point.flip)}, ${digits(100 * point.wrong)} % wrong`,
    `${timeText(point.ns)} (${timeText(lower)} to ${timeText(upper)}), ${count(point.threads, "thread")}`, point.standing ?? "",
    point.disturbed ? "disturbed: another program used the machine meanwhile" : ""].filter(Boolean);
}

function styleOf(theme, knob) {
  const i = Object.keys(knobs).indexOf(knob), open = ["star", "crossRot"].includes(shapes[i]);
  const colour = knob === "several" ? theme.quiet : theme.series[i % theme.series.length];
  return {pointStyle: shapes[i], pointRadius: knob === "several" ? 4 : 7, pointHoverRadius: 9, pointHitRadius: 6, pointBackgroundColor: colour,
    pointBorderColor: open ? colour : theme.text, pointBorderWidth: open ? 2.5 : 1, borderColor: colour};
}

// Bars from the lower to the upper quartile, with a gap before the next.
const bars = (points, x, y) => points.flatMap((point) =>
  [...point.ns_quartiles.map((ns) => ({x: x.place(ns / unit.ns), y: y.place(measures[shownMeasure].of(point))})), {x: NaN, y: NaN}]);

function errorChart(theme) {
  const points = manifest.points, {of, axis} = measures[shownMeasure];
  const x = logarithmicAxis(points.flatMap(({ns, ns_quartiles}) => [ns, ...ns_quartiles].map((each) => each / unit.ns)));
  const y = logarithmicAxis(points.map(of));
  const at = (point) => ({x: x.place(point.ns / unit.ns), y: y.place(of(point)), point});
  const datasets = usedKnobs.flatMap((knob) => {
    const own = points.filter((point) => point.knob === knob), style = styleOf(theme, knob);
    return [{label: knobs[knob], data: own.map(at), showLine: false, order: knob === "several" ? 2 : 1, ...style},
      ...[false, true].map((disturbed) => ({data: bars(own.filter((point) => Boolean(point.disturbed) === disturbed), x, y), showLine: true, spanGaps: false,
        borderColor: style.borderColor, borderWidth: 1.5, borderDash: disturbed ? [3, 3] : [], pointRadius: 0, pointHitRadius: 0, order: 3}))];
  });
  const line = {showLine: true, pointRadius: 0, pointHitRadius: 0, order: 4};
  if (shownMeasure === "rms") {
    // Only steps downwards are drawn: of times that count as equal, the slower way may have the
    // larger error.
    let least = Infinity;
    const steps = points.filter(({standing}) => standing === "front").sort((a, b) => a.ns - b.ns)
      .filter((point) => of(point) < least && (least = of(point), true));
    datasets.push({...line, data: steps.map(at), stepped: "before", borderColor: theme.quiet, borderWidth: 1.5});
  }
  datasets.push({...line, data: [at(chosen)], showLine: false, pointRadius: 13, pointStyle: "circle", pointBackgroundColor: "transparent",
    pointBorderColor: theme.bad, pointBorderWidth: 2.5});
  const labels = {usePointStyle: true, boxHeight: 8, filter: ({text}) => text !== undefined};
  const described = pointChart({x: titled(x, `${unit.name} a frame`), y: titled(y, axis), datasets,
    legend: {position: "bottom", labels, onClick: () => {}}, told: ({point}) => told(point)});
  described.options.onClick = (event, hits, drawn) => {
    const hit = hits.map(({datasetIndex, index}) => drawn.data.datasets[datasetIndex].data[index].point).find(Boolean);
    if (hit) setTimeout(() => choose(hit)); // after this chart has handled the click, because choosing draws another chart
  };
  return described;
}

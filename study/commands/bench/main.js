// The charts: a bar for each time of a frame, and a curve for each scaling.

// Formats times like the table of numbers on the page (three_digits of text.cpp).
const threeDigits = (value) => value === 0 ? "0" : value.toFixed(Math.max(0, 2 - Math.floor(Math.log10(Math.abs(value)))));
const milliseconds = (value) => `${threeDigits(value)} ms`;

const allSeries = [["ms", "Glassbox"], ["peer_ms", "peer"], ["floor_ms", "floor"]]
  .map(([key, label], i) => ({key, label, i, data: manifest.results.map((result) => result[key] ?? null)}))
  .filter(({data}) => data.some((ms) => ms !== null));

// The end of a path that is too long, because it has the file's name.
function shortened(text, letters) {
  const all = [...text];
  return all.length > letters ? "…" + all.slice(-letters).join("") : text;
}

const barLabel = ({scene, threads, ratio}, letters) => [shortened(scene, letters), count(threads, "thread"), ...(ratio === null ? [] : [`ratio ${threeDigits(ratio)}`])];

// Writes the time behind each bar.
const timesOfBars = {
  afterDatasetsDraw(chart) {
    const {ctx: context, data} = chart;
    Object.assign(context, {fillStyle: chart.options.color, font: Chart.helpers.toFontString(Chart.defaults.font), textBaseline: "middle", textAlign: "left"});
    data.datasets.forEach((set, i) => chart.isDatasetVisible(i) && chart.getDatasetMeta(i).data.forEach(({x, y}, at) => {
      if (set.data[at] !== null) context.fillText(milliseconds(set.data[at]), x + 6, y);
    }));
  },
};

// All bars have the same scale, so that lengths can be compared between scenes.
const barChart = (theme) => ({
  type: "bar",
  data: {labels: manifest.results.map(({scene}) => scene), datasets: allSeries.map(({label, i, data}) => ({label, data, backgroundColor: theme.series[i]}))},
  options: {
    indexAxis: "y", layout: {padding: {right: 70}},
    scales: {
      x: {position: "top", beginAtZero: true, grid: {drawBorder: false}, ticks: {maxTicksLimit: 6, maxRotation: 0, autoSkipPadding: 16, callback: (ms) => `${ms} ms`}},
      y: {grid: {display: false}, ticks: {autoSkip: false, color: theme.text,
        callback(value) { return barLabel(manifest.results[value], clamp(Math.round(this.chart.width / 30), 12, 40)); }}},
    },
    plugins: {legend: {display: allSeries.length > 1, align: "start", labels: {boxWidth: 14}}, tooltip: {callbacks: {label: ({raw, dataset}) => `${dataset.label}: ${milliseconds(raw)}`}}},
  },
  plugins: [timesOfBars],
});

function barSection() {
  const {results} = manifest, place = chart("Milliseconds for each frame; the numbers below are the same", barChart);
  const peer = results.find((result) => result.peer)?.peer, floors = results.some((result) => result.floor_ms);
  place.style.height = `${4 + results.length * (peer ? 3.9 : 3)}rem`;
  return element("section", {}, element("h2", {}, "Time of a frame"),
    peer ? element("p", {}, `The peer is ${peer}; the ratio is its time divided by that of Glassbox.`) : null,
    floors ? element("p", {}, "The floor is the time that the memory needs to move the necessary bytes.") : null, place);
}

// A line marks where the curve bends.
function curveChart(theme, {by, points, bend}) {
  const x = logarithmicAxis(points.map((point) => point.x)), y = logarithmicAxis(points.map(({ms}) => ms));
  return pointChart({
    x: titled(x, by), y: titled(y, "ms"),
    lines: bend && {bend: references(x, "top", theme.quiet, [[bend.at, "the exponent changes here"]])},
    datasets: [{data: points.map((point) => ({x: point.x, y: point.ms, point})), showLine: true, borderColor: theme.series[0], backgroundColor: theme.series[0], pointRadius: 4}],
    told: ({point}) => [`${point.x.toLocaleString("en")} ${by}`, `${milliseconds(point.ms)} (${point.ms_quartiles.map(threeDigits).join(" to ")})`],
  });
}

function curveSection(scaling) {
  const {by, told, points} = scaling;
  return element("section", {}, element("h2", {}, `Time against ${by}`), element("p", {}, told),
    points.length ? chart(`Time against ${by}; the numbers below are the same`, (theme) => curveChart(theme, scaling)) : null);
}

if (manifest.results.length) byId("charts").append(barSection());
byId("charts").append(...(manifest.scaling ?? []).map(curveSection));
drawCharts();

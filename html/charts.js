// Charts by Chart.js in the colours of the page. They are drawn again when these change, and for
// paper, which is white.

// Colours by Okabe and Ito, which people with any kind of colour vision can tell apart, in an order
// that suits the page's brightness.
const themes = {
  light: {text: "#171b22", quiet: "#566071", grid: "#dfe2e8", bad: "#b3261e",
    series: ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"]},
  dark: {text: "#eef1f5", quiet: "#a6b0bf", grid: "#353c47", bad: "#ff8a80",
    series: ["#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#f0e442", "#d55e00", "#ffffff"]},
};
const dark = matchMedia("(prefers-color-scheme: dark)");
const drawings = [];

// A place for a chart on the page. `label` describes it for people who cannot see it; `describe`
// returns the chart for Chart.js in a theme.
function chart(label, describe) {
  const canvas = element("canvas", {role: "img", ariaLabel: label});
  drawings.push({canvas, describe});
  return element("div", {className: "plot"}, canvas);
}

// Draws all charts. Their places must be on the page already.
function drawCharts(theme = dark.matches ? themes.dark : themes.light) {
  const {fontFamily: family, fontSize} = getComputedStyle(document.body);
  Chart.defaults.set({
    animation: false, maintainAspectRatio: false, devicePixelRatio: Math.max(2, devicePixelRatio), clip: 12,
    color: theme.text, borderColor: theme.grid, font: {family, size: .85 * parseFloat(fontSize)},
    scale: {ticks: {color: theme.quiet}, grid: {borderColor: theme.quiet}}, plugins: {tooltip: {displayColors: false}},
  });
  for (const {canvas, describe} of drawings) {
    Chart.getChart(canvas)?.destroy();
    new Chart(canvas, describe(theme));
  }
}

dark.addEventListener("change", () => drawCharts());
addEventListener("beforeprint", () => {
  drawCharts(themes.light);
  for (const {canvas} of drawings) Chart.getChart(canvas).resize(660, canvas.parentNode.clientHeight);
});
addEventListener("afterprint", () => drawCharts());

// Points and lines between two axes. `told` returns the lines of text shown for a point under the
// mouse.
function pointChart({x, y, lines, datasets, legend = {display: false}, told}) {
  return {
    type: "scatter", data: {datasets},
    options: {scales: {x, y, ...lines}, plugins: {legend, tooltip: {callbacks: {label: ({raw}) => told(raw)}}}},
  };
}

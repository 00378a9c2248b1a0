// Charts of how many pixels have which parallax, and of what other colours cost.

// The colour of a disparity in the map.
function disparityColour(px) {
  const {limit, colours} = manifest.scales.disparity, middle = (colours.length - 1) / 2;
  const share = limit > 0 ? clamp(px / limit, -1, 1) : 0;
  return colours[Math.round(middle + share * middle)];
}

function striped(colour) {
  const tile = newCanvas(8, 8), context = tile.getContext("2d");
  Object.assign(context, {fillStyle: colour, strokeStyle: "#141414", lineWidth: 3});
  context.fillRect(0, 0, 8, 8);
  for (const x of [-8, 0, 8]) {
    context.moveTo(x - 4, 12);
    context.lineTo(x + 12, -4);
  }
  context.stroke();
  return context.createPattern(tile, "repeat");
}

// A histogram of the left eye's disparities. Bars have the map's colours and stripes beyond the
// budget; the window is at 0.
function histogramChart(theme) {
  const {histogram, budget_in_front_px: front, budget_behind_px: behind, budget_percent: percent} = manifest.disparity;
  const {first_px: first, bin_px: bin, counts} = histogram, all = counts.reduce((sum, one) => sum + one, 0);
  const x = linearAxis([first, first + bin * counts.length, -front, behind, 0]), highest = Math.sqrt(Math.max(...counts) / all);
  // An empty bin at either end: Chart.js makes bars as wide as they are apart, and would otherwise
  // move the axis by half a bar.
  const bars = [0, ...counts, 0].map((count, i) => ({x: first + (i - .5) * bin, y: Math.sqrt(count / all), low: first + (i - 1) * bin, high: first + i * bin}));
  const colours = bars.map(({x: px}) => px < -front || px > behind ? striped(disparityColour(px)) : disparityColour(px));
  return pointChart({
    x: {...titled(x, "in front ←  parallax, px  → behind"), offset: false, grid: {offset: false, color: ({tick}) => tick?.value === 0 ? theme.text : "transparent"},
      ticks: {...x.options.ticks, callback: (px) => signed(px, 3).replace(/\.?0+$/, "")}},
    y: {min: 0, max: highest, grid: {display: false}, afterBuildTicks: (axis) => { axis.ticks = [{value: highest / 2}, {value: highest}]; },
      ticks: {callback: (root) => `${(100 * root ** 2).toPrecision(2)} %`}},
    lines: {budget: references(x, "top", theme.bad, [[-front, `−${percent} %`], [behind, `+${percent} %`]])},
    datasets: [{type: "bar", data: bars, backgroundColor: colours, borderColor: theme.grid, borderWidth: .5, barPercentage: 1, categoryPercentage: 1}],
    told: ({low, high, y}) => `${low.toPrecision(4)} to ${high.toPrecision(4)} px: ${(100 * y ** 2).toFixed(2)} %`,
  });
}

function histogramLabel() {
  const {histogram: {first_px: first, bin_px: bin, counts}, budget_in_front_px: front, budget_behind_px: behind} = manifest.disparity;
  const all = counts.reduce((sum, one) => sum + one, 0);
  return `Histogram: ${all} pixels between ${signed(first, 1)} and ${signed(first + bin * counts.length, 1)} px of parallax, the budget from ${signed(-front, 1)} to ${signed(behind, 1)} px`;
}

// The mean rivalry against the mean colour difference that recolouring can reach. The chosen
// setting is marked.
function compromiseChart(theme) {
  const {recolour, target_rivalry: target} = manifest.anaglyph, all = [...recolour.curve, recolour];
  const x = linearAxis([0, ...all.map((one) => one.ciede2000)]), y = linearAxis([0, target, ...all.map((one) => one.rivalry)]);
  const at = (one) => ({x: one.ciede2000, y: one.rivalry, one}), points = (color, rest) => ({borderColor: color, backgroundColor: color, ...rest});
  return pointChart({
    x: titled(x, "mean colour difference, CIEDE2000"), y: titled(y, "mean rivalry"),
    lines: {target: references(y, "right", theme.bad, [[target, `target ${target}`]])},
    datasets: [points(theme.series[1], {data: [at(recolour)], pointRadius: 7, order: -1}),
      points(theme.series[0], {data: recolour.curve.map(at), showLine: true, pointRadius: 3.5})],
    told: ({one}) => [`desaturated ${one.desaturate.toFixed(2)}, brightened ${one.brighten.toFixed(2)}:`, `rivalry ${one.rivalry.toFixed(3)}, difference ${one.ciede2000.toFixed(1)}`],
  });
}

function compromiseLabel() {
  const {curve} = manifest.anaglyph.recolour, most = Math.max(...curve.map(({ciede2000}) => ciede2000));
  return `Rivalry falls from ${curve[0].rivalry.toFixed(3)} while the colour difference grows to ${most.toFixed(1)}`;
}

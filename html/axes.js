// Axes of charts: each gives the position of a value on it, and the options for Chart.js.

const tickNumber = (value) => value >= 1e-3 && value < 1e5 ? String(Number(value.toPrecision(1))) : value.toExponential(0).replace("+", "");

// At most eight powers of ten; if there are fewer than two, also their multiples by two and five.
function marks(low, high) {
  const first = Math.ceil(low), last = Math.floor(high), step = Math.ceil((last - first + 1) / 8), chosen = [];
  for (let power = first; power <= last; power += step) chosen.push(power);
  if (chosen.length >= 2) return chosen;
  for (let power = first - 1; power <= last; power++) chosen.push(power + Math.log10(2), power + Math.log10(5));
  return chosen.filter((power) => power >= low && power <= high);
}

// A logarithmic axis: 0 is placed below the least value, and infinite values or NaN above the
// greatest. A single value has a decade around it.
function logarithmicAxis(values) {
  const powers = values.filter((value) => value > 0 && Number.isFinite(value)).map(Math.log10);
  let low = powers.length ? Math.min(...powers) : -1, high = powers.length ? Math.max(...powers) : 0;
  if (high - low < 1) [low, high] = [(low + high - 1) / 2, (low + high + 1) / 2];
  const margin = (high - low) * .05, labels = new Map(marks(low - margin / 2, high + margin / 2).map((power) => [power, tickNumber(10 ** power)]));
  const zero = low - 3 * margin, beyond = high + 3 * margin;
  if (values.includes(0)) labels.set(low = zero, "0");
  if (values.some((value) => !Number.isFinite(value))) labels.set(high = beyond, "∞");
  const place = (value) => value === 0 ? 10 ** zero : Number.isFinite(value) ? value : 10 ** beyond;
  const ticks = [...labels].sort(([a], [b]) => a - b);
  return {
    place,
    options: {
      type: "logarithmic", min: 10 ** (low - margin), max: 10 ** (high + margin),
      afterBuildTicks: (axis) => { axis.ticks = ticks.map(([power]) => ({value: 10 ** power})); },
      ticks: {callback: (unused, i) => ticks[i][1], autoSkip: false, maxRotation: 0},
    },
  };
}

function linearAxis(values) {
  const plain = values.filter(Number.isFinite), low = Math.min(...plain), high = Math.max(...plain);
  const margin = (high - low || 1) * .04;
  return {place: (value) => value, options: {type: "linear", min: low - margin, max: high + margin, ticks: {includeBounds: false, maxRotation: 0}}};
}

const axisFor = (values, logarithmic) => logarithmic && values.every((value) => !(value < 0)) ? logarithmicAxis(values) : linearAxis(values);

// The axis with a title.
const titled = ({options}, text) => ({...options, title: {display: true, text}});

// A second axis on the other side of the chart: dashed lines at some of its values, each with its
// name.
function references({place, options: {type, min, max}}, position, color, lines) {
  return {
    type, min, max, position, offset: false,
    afterBuildTicks: (axis) => { axis.ticks = lines.map(([value]) => ({value: place(value)})); },
    ticks: {callback: (unused, i) => lines[i][1], color, autoSkip: false, maxRotation: 0},
    grid: {offset: false, color, lineWidth: 2, borderDash: [6, 4], drawBorder: false, drawTicks: false},
  };
}

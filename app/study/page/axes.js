// Axes of the charts: powers of ten with a place for 0 and one for what is no number.

const powerText = (power) => power >= -3 && power <= 4 ? String(Number((10 ** power).toPrecision(1))) : `1e${power}`;

// At most eight of the whole numbers from low to high.
function spread(low, high) {
  const step = Math.ceil((high - low + 1) / 8), chosen = [];
  for (let power = low; power <= high; power += step) chosen.push(power);
  return chosen;
}

// 0 stands a decade below the least value, infinity a decade above the greatest. One value alone has a decade around it.
function logarithmicAxis(values) {
  const powers = values.filter((value) => value > 0 && Number.isFinite(value)).map(Math.log10);
  let low = powers.length ? Math.floor(Math.min(...powers)) : -1, high = powers.length ? Math.ceil(Math.max(...powers)) : 0;
  if (high === low) high = low + 1;
  const labels = new Map(spread(low, high).map((power) => [power, powerText(power)]));
  const exact = values.includes(0), absent = values.some((value) => !Number.isFinite(value));
  if (exact) labels.set(--low, "0");
  if (absent) labels.set(++high, "∞");
  const place = (value) => value === 0 ? 10 ** low : Number.isFinite(value) ? value : 10 ** high;
  const ticks = [...labels].sort(([a], [b]) => a - b);
  return {
    place,
    options: {
      type: "logarithmic", min: 10 ** low, max: 10 ** high,
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

// Values that follow from the results.

// JSON cannot represent infinity.
const number = (value) => ({infinity: Infinity, "-infinity": -Infinity, nan: NaN})[value] ?? value;
const seriesOf = (experiment) => [...new Set(experiment.configurations.map(({series}) => series))];
const scenesOf = (experiment) => [...new Set(experiment.configurations.map(({scene}) => scene))];
const threadsOf = (experiment) => [...new Set(experiment.configurations.flatMap(({times}) => times.map(({threads}) => threads)))].sort((a, b) => a - b);
const timeOf = (configuration, threads) => configuration.times.find((time) => time.threads === threads);
// The experiment's own error first, then each of its other measures, each as an experiment.
const byMeasure = (experiment) => [{name: "", more_is_better: false}, ...experiment.measures]
  .map(({name: measure, ...rest}) => ({...experiment, ...rest, measure, configurations: experiment.configurations.filter((each) => each.measure === measure)}))
  .filter(({configurations}) => configurations.length);
const withUnit = (name, unit) => unit ? `${name} [${unit}]` : name;

function digits(value, places = 3) {
  const plain = number(value);
  if (plain === Infinity) return "∞";
  if (Number.isNaN(plain)) return "not a number";
  if (plain === 0) return "0";
  const power = Math.floor(Math.log10(Math.abs(plain)));
  if (power >= -3 && power < 6) return Number(plain.toPrecision(places)).toString();
  const [mantissa, exponent] = plain.toExponential(places - 1).split("e");
  return `${Number(mantissa)}e${Number(exponent)}`;
}

// The same as in study/commands/text.cpp: one unit for all times of an experiment.
function timeUnit(experiment) {
  const shortest = Math.min(...experiment.configurations.flatMap(({times}) => times.map(({ns}) => ns)));
  return shortest < 1e3 ? {ns: 1, name: "ns"} : shortest < 1e6 ? {ns: 1e3, name: "µs"} : {ns: 1e6, name: "ms"};
}

// The number of threads shown: one thread if an experiment was not timed with more.
function shownThreads(experiment, wanted) {
  const all = threadsOf(experiment);
  return all.includes(wanted) ? wanted : all[0];
}

// Compares the page's arithmetic with what the run recorded: every number of the recorded pixels
// bit for bit, and the bounds to within a few roundings of a double.

const boundTolerance = 1e-12; // relative: a bound is some forty operations in double

class Check {
  constructor() {
    Object.assign(this, {numbers: 0, bounds: 0, wrong: []});
  }
  same(what, computed, recorded) {
    computed.forEach((value, k) => {
      this.numbers++;
      if (!Object.is(value, recorded[k])) this.wrong.push(`${what}: ${value} instead of ${recorded[k]}`);
    });
  }
  near(what, computed, recorded) {
    computed.forEach((value, k) => {
      this.bounds++;
      const off = Math.abs(value - recorded[k]);
      if (!(value === recorded[k] || off <= boundTolerance * Math.abs(recorded[k]))) this.wrong.push(`bound of ${what}: ${value} instead of ${recorded[k]}`);
    });
  }
}

// Reads the columns from the beginning, some numbers per call.
function reader(columns) {
  const at = {};
  return (name, size) => {
    const from = at[name] ?? 0;
    at[name] = from + size;
    return columns[name].subarray(from, from + size);
  };
}

function checkTriangles(run, check) {
  const take = reader(run.columns);
  for (const number of run.columns["traced.number"]) {
    const chain = chainOf(run, number), name = `triangle ${number}`;
    for (const corner of chain.corners) {
      check.same(`${name}, world`, corner.world, take("traced.world", 3));
      check.same(`${name}, eye`, corner.eye, take("traced.eye", 3));
      check.same(`${name}, clip`, corner.clip, take("traced.clip", 4));
      check.same(`${name}, outcode`, [corner.outcode], take("traced.outcode", 1));
      check.near(`${name}, world`, corner.bound.world, take("bound.world", 3));
      check.near(`${name}, eye`, corner.bound.eye, take("bound.eye", 3));
      check.near(`${name}, clip`, corner.bound.clip, take("bound.clip", 4));
    }
    check.same(`${name}, vertices`, [chain.polygon.length], take("traced.vertices", 1));
    for (const {ndc, screen, bound} of chain.polygon) {
      check.same(`${name}, NDC`, [...ndc.position, ndc.inverseW], take("traced.ndc", 4));
      check.same(`${name}, screen`, screen.position, take("traced.screen", 3));
      const ndcBound = take("bound.ndc", 4), onScreen = take("bound.screen", 3);
      if (!bound) continue; // made by clipping
      check.near(`${name}, NDC`, [...bound.ndc.position, bound.ndc.inverseW], ndcBound);
      check.near(`${name}, screen`, bound.screen, onScreen);
    }
    check.same(`${name}, pieces`, [chain.pieces.length], take("traced.pieces", 1));
    for (const {setup, front, culled} of chain.pieces) {
      check.same(`${name}, area`, [setup?.doubleArea ?? 0], take("traced.area", 1));
      check.same(`${name}, 1/area`, [setup?.inverseArea ?? 0], take("traced.inverse_area", 1));
      check.same(`${name}, facing`, [(setup?.clockwise ? 1 : 0) | (front ? 2 : 0) | (culled ? 4 : 0)], take("traced.flags", 1));
    }
  }
}

function checkFragments(run, check) {
  const take = reader(run.columns);
  for (const i of recordedFragments(run)) {
    const f = fragmentOf(run, i), name = `fragment ${i + 1}`;
    const edges = take("record.edges", 3), lambda = take("record.lambda", 3), weights = take("record.weights", 3);
    const depth = take("record.depth", 1), inverseW = take("record.inverse_w", 1), bounds = take("bound.fragment", 8);
    if (f.chain) {
      check.same(`${name}, edges`, f.edges, edges);
      check.same(`${name}, lambda`, f.lambda, lambda);
      check.same(`${name}, weights`, f.weights, weights);
      check.same(`${name}, depth`, [f.depth], depth);
      check.same(`${name}, 1/w`, [f.inverseW], inverseW);
      if (f.bound) check.near(name, [...f.bound.lambda, ...f.bound.weights, f.bound.depth, f.bound.inverseW], bounds);
    }
    check.same(`${name}, depth code`, [f.code], take("record.code", 1));
    check.same(`${name}, stored depth`, [f.stored.code], take("record.stored", 1));
    const before = take("record.before", 4), after = take("record.after", 4);
    if (f.fate !== "written" && f.fate !== "blended") continue;
    check.same(`${name}, before`, f.before, before);
    check.same(`${name}, after`, f.after, after);
  }
}

function checkRun(run) {
  const check = new Check();
  checkTriangles(run, check);
  checkFragments(run, check);
  return check;
}

function offerCheck() {
  const {facts} = state.runs[0];
  byId("check").hidden = !facts.records_complete;
  byId("check-note").textContent = facts.recorded && !facts.records_complete ?
    "These pixels have too many records for a page: choose fewer pixels with --rect." : "";
  byId("check-button").addEventListener("click", () => {
    const {numbers, bounds, wrong} = checkRun(state.runs[0]);
    byId("check-note").textContent = `${count(numbers, "number")} and ${count(bounds, "bound")} computed again: ` +
      (wrong.length ? `${wrong.length.toLocaleString("en")} differ from the run's records, the first is ${wrong[0]}.` : "all are equal to the run's records.");
  });
}

// The stops on a triangle's way through the stages: each is a step of its chain, with the space and
// the overlay that show it best. Also finds the next triangle or fragment of a kind.

const stops = [
  {step: "object", stage: "Assembly", space: "object", overlay: "id"},
  {step: "world", stage: "Vertices", space: "world", overlay: "none"},
  {step: "eye", stage: "Vertices", space: "eye", overlay: "none"},
  {step: "clip", stage: "Vertices", space: "clip", overlay: "none"},
  {step: "clipped", stage: "Clipping", space: "clip", overlay: "clipped"},
  {step: "ndc", stage: "Setup, culling", space: "ndc", overlay: "none"},
  {step: "screen", stage: "Setup, culling", space: "screen", overlay: "none"},
  {step: "snapped", stage: "Setup, culling", space: "screen", overlay: "none"},
  {step: "facing", stage: "Setup, culling", space: "screen", overlay: "culled"},
  {step: "edges", stage: "Coverage", space: "screen", overlay: "none"},
  {step: "fragment", stage: "Coverage", space: "screen", overlay: "overdraw"},
  {step: "depth", stage: "Depth test", space: "screen", overlay: "hidden"},
  {step: "colour", stage: "Colour", space: "screen", overlay: "none"},
];

const sectionOf = (step) => byId(`step-${step}`);
// Only stops that exist for the chosen triangle: one that was not cut has no clipped polygon, one
// that was culled no fragment.
const stopsHere = () => stops.filter(({step}) => sectionOf(step));

// Shows the step in the panel, or the last step before it that exists.
function goToStop({step, space, overlay}) {
  change({stop: step, space, overlay});
  const earlier = stops.slice(0, stops.findIndex((stop) => stop.step === step) + 1);
  const section = earlier.map((stop) => sectionOf(stop.step)).findLast(Boolean);
  section?.scrollIntoView({block: "start"});
}

// Goes to the stop that shows a stage best: its last one, but for the vertices the first.
function goToStage(name) {
  stopPlaying();
  if (state.triangle === null && state.fragment === null) chooseSomething();
  const ofStage = stops.filter(({stage}) => stage === name);
  goToStop(name === "Vertices" ? ofStage[0] : ofStage.at(-1));
}

// The next of `count` items after `from`, cyclically, for which the test holds; -1 if there is
// none.
function nextWhere(count, from, test) {
  for (let i = 1; i <= count; i++) if (test((from + i) % count)) return (from + i) % count;
  return -1;
}

// Finds the next triangle by its marks, or the next fragment by its fate.
const withMark = (mark) => (run) => {
  const {"triangle.marks": all, "triangle.number": number} = run.columns;
  const row = nextWhere(all.length, run.rowOf.get(state.triangle ?? -1) ?? -1, (i) => all[i] & mark);
  if (row >= 0) chooseTriangle(number[row]);
  return row >= 0;
};
const untouched = (run) => {
  const {"triangle.marks": all, "triangle.number": number} = run.columns, gone = marks.rejected | marks.clippedAway | marks.cut;
  const row = nextWhere(all.length, run.rowOf.get(state.triangle ?? -1) ?? -1, (i) => !(all[i] & gone));
  if (row >= 0) chooseTriangle(number[row]);
  return row >= 0;
};
const withFate = (name) => (run) => {
  const all = run.columns["fragment.fate"], fate = fates.indexOf(name);
  const found = nextWhere(all.length, state.fragment ?? -1, (i) => all[i] === fate);
  chooseFragment(found);
  return found >= 0;
};

// Chooses the next item of the part, and shows the stage that put it there.
function goToNext(stage, label, choose) {
  stopPlaying();
  if (choose(state.runs[0])) goToStage(stage);
  else say(`None that is ${label} is in this page, which is of a part of the picture.`);
}

// ---- what the page opens with ----

// A drawn pixel near the middle. A pixel in which a fragment is hidden may be twice as far away.
// Null if nothing is drawn.
function openingPixel({width, height, startOf, facts}) {
  const [x0, y0, x1, y1] = facts.rectangle ?? [0, 0, width, height];
  let best = null, least = Infinity;
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const fragments = startOf[y * width + x + 1] - startOf[y * width + x];
      if (!fragments) continue;
      const cost = Math.hypot(x + 0.5 - (x0 + x1) / 2, y + 0.5 - (y0 + y1) / 2) * (fragments > 1 ? 1 : 2);
      if (cost < least) [best, least] = [[x, y], cost];
    }
  }
  return best;
}

function chooseSomething() {
  const run = state.runs[0], pixel = run.facts.pixel ?? openingPixel(run);
  if (pixel) choosePixel(...pixel);
  else if (run.triangleCount) chooseTriangle(run.columns["triangle.number"][0]);
}

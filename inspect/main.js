// The state of the page, and how it changes. Everything shown follows from `state`.

const state = {
  runs: [], playbacks: [], panes: [],
  at: 0,           // number of fragments drawn in the picture
  cursor: null,    // the chosen pixel
  fragment: null,  // the chosen fragment
  triangle: null,  // the chosen triangle: that of the fragment, if there is one
  vertex: 0,       // 0 .. 2 its corners, from 3 on the vertices after clipping
  stop: null,      // the step of the chain that is shown
  overlay: "none", space: "world", hex: false, fitted: true,
  open: new Set(), // the matrices that are open
};

// Changes the state and shows it. `focus` is the name or id of the control that keeps the focus
// when its panel is made anew.
function change(values, focus = null) {
  if (values.triangle !== undefined && values.triangle !== state.triangle && values.vertex === undefined) state.vertex = 0;
  if (values.space !== undefined && values.space !== state.space) enterSpace(spaces[state.space], spaces[values.space]);
  Object.assign(state, values);
  update();
  if (focus) (document.querySelector(`input[name="${focus}"]:checked`) ?? byId(focus))?.focus();
}

function update() {
  const run = state.runs[0];
  const chain = state.triangle === null ? null : cachedChain(run, state.triangle);
  if (state.vertex >= 3 && !(chain && state.vertex - 3 < chain.polygon.length && chain.marks & marks.cut)) state.vertex = 0;
  paintPictures();
  drawPictures();
  showPanel();
  markStop();
  showScrubber();
  drawSpace();
  writeAddress();
}

function showScrubber() {
  const run = state.runs[0];
  byId("scrubber").max = run.fragmentCount;
  byId("scrubber").value = state.at;
  byId("scrubber").setAttribute("aria-valuetext", `${state.at.toLocaleString("en")} of ${count(run.fragmentCount, "fragment")}`);
  byId("fragment-number").max = run.fragmentCount;
  byId("fragment-number").value = state.fragment === null ? "" : state.fragment + 1;
  byId("triangle-number").value = state.triangle ?? "";
  byId("pixel-x").value = state.cursor?.x ?? "";
  byId("pixel-y").value = state.cursor?.y ?? "";
  byId("overlay").value = state.overlay;
  byId("space-name").value = state.space;
  byId("hex").checked = state.hex;
  byId("now").className = "";
  byId("now").textContent = `After ${state.at.toLocaleString("en")} of ${count(run.fragmentCount, "fragment")}. ` + fragmentText(run);
}

function fragmentText(run) {
  if (state.fragment === null) return "";
  const {number, x, y, fate, before, after} = fragmentOf(run, state.fragment);
  return `Fragment ${(state.fragment + 1).toLocaleString("en")}: ${number === null ? "line or point" : `triangle ${number}`}, ` +
    `pixel (${x}, ${y}), ${fate}` + (fate === "written" || fate === "blended" ? `, ${bytesText(before)} → ${bytesText(after)}` : "") + ".";
}

// ---- choosing ----

function fragmentValues(i) {
  const c = state.runs[0].columns, number = c["fragment.triangle"][i];
  return {fragment: i, triangle: number === noTriangle ? null : number, cursor: {x: c["fragment.x"][i], y: c["fragment.y"][i]}};
}

// Shows the picture as it was right after the fragment.
function chooseFragment(i) {
  stopPlaying();
  if (!(i >= 0 && i < state.runs[0].fragmentCount)) return;
  Object.assign(state, {cursor: fragmentValues(i).cursor});
  showCursor();
  change({...fragmentValues(i), at: i + 1});
}

// The fragment visible at a pixel after the first `at` fragments, or else the last one that arrived
// there, chosen; none if none has arrived.
function pixelValues(cursor, at) {
  const run = state.runs[0], past = Array.from(fragmentsAt(run, cursor.x, cursor.y)).filter((i) => i < at);
  const chosen = past.findLast((i) => run.columns["fragment.fate"][i] >= 2) ?? past.at(-1);
  return chosen === undefined ? {fragment: null, triangle: null, cursor} : fragmentValues(chosen);
}

// Chooses a pixel. The picture stays the same.
function choosePixel(x, y) {
  stopPlaying();
  const run = state.runs[0];
  if (!(x >= 0 && y >= 0 && x < run.width && y < run.height)) return;
  state.cursor = {x: Math.floor(x), y: Math.floor(y)};
  showCursor();
  change(pixelValues(state.cursor, state.at));
}

// Says something in place of the moment, in full also where the window is narrow.
const say = (text) => Object.assign(byId("now"), {textContent: text, className: "said"});

function chooseTriangle(number) {
  stopPlaying();
  const run = state.runs[0];
  if (!run.rowOf.has(number)) {
    say(`Triangle ${number} is not in this page: it has no area as modelled, or the page is of a part of the picture.`);
    return;
  }
  const first = firstFragmentOf(run, number);
  change({triangle: number, ...(first < 0 ? {fragment: null} : fragmentValues(first))});
}

// Chooses a triangle, and leaves the pixel chosen.
function chooseHere(number) {
  stopPlaying();
  change({triangle: number, fragment: null});
}

const stepBy = (by) => chooseFragment(clamp((state.fragment ?? state.at - Math.max(by, 0)) + by, 0, state.runs[0].fragmentCount - 1));

function stepOnPixel(by) {
  const {cursor, fragment} = state;
  if (!cursor) return;
  const list = fragmentsAt(state.runs[0], cursor.x, cursor.y), now = list.indexOf(fragment ?? -1);
  const next = list[now < 0 ? (by > 0 ? 0 : list.length - 1) : now + by];
  if (next !== undefined) chooseFragment(next);
}

// The state after the first `at` fragments, with the last of them chosen.
const momentValues = (at) => (at > 0 ? {...fragmentValues(at - 1), at} : {at: 0, fragment: null});

function scrubTo(at) {
  stopPlaying();
  change(momentValues(at));
}

// Shows the picture before the first fragment, or after the last. The chosen pixel stays.
function goToEnd(at) {
  stopPlaying();
  change({at, ...(state.cursor ? pixelValues(state.cursor, at) : {fragment: null})});
}

// ---- the address bar ----

let addressTimer = 0;
function writeAddress() {
  clearTimeout(addressTimer);
  addressTimer = setTimeout(() => {
    const {cursor, fragment, triangle, vertex, stop, overlay, space, at, runs} = state, parts = [];
    if (cursor) parts.push(`pixel=${cursor.x},${cursor.y}`);
    if (fragment !== null) parts.push(`fragment=${fragment + 1}`);
    else if (triangle !== null) parts.push(`triangle=${triangle}`);
    if (at !== runs[0].fragmentCount) parts.push(`after=${at}`);
    if (vertex) parts.push(`vertex=${vertex}`);
    if (stop) parts.push(`step=${stop}`);
    if (overlay !== "none") parts.push(`overlay=${overlay}`);
    if (space !== "world") parts.push(`space=${space}`);
    const hash = parts.length ? "#" + parts.join("&") : "#";
    if (hash !== (location.hash || "#")) history.replaceState(null, "", hash);
  }, 120);
}

function readAddress() {
  const run = state.runs[0], words = new URLSearchParams(location.hash.slice(1));
  const whole = (name, below) => {
    const value = Number(words.get(name) ?? NaN);
    return Number.isInteger(value) && value >= 0 && value < below ? value : null;
  };
  const values = {at: whole("after", run.fragmentCount + 1) ?? run.fragmentCount, fragment: null, triangle: null, cursor: null,
    vertex: whole("vertex", 13) ?? 0, stop: stops.find(({step}) => step === words.get("step"))?.step ?? null,
    overlay: Object.hasOwn(overlays, words.get("overlay") ?? "") ? words.get("overlay") : run.facts.opening_overlay,
    space: Object.hasOwn(spaces, words.get("space") ?? "") ? words.get("space") : "world"};
  const [x, y] = (words.get("pixel") ?? "").split(",").map(Number);
  const fragment = whole("fragment", run.fragmentCount + 1), triangle = whole("triangle", 2 ** 32);
  if (fragment) Object.assign(values, fragmentValues(fragment - 1));
  else if (triangle !== null && run.rowOf.has(triangle)) values.triangle = triangle;
  if (Number.isInteger(x) && x >= 0 && x < run.width && Number.isInteger(y) && y >= 0 && y < run.height) values.cursor = {x, y};
  change(values);
  showCursor();
  drawPictures();
  if (values.cursor && !fragment && triangle === null) choosePixel(x, y);
  else if (!fragment && triangle === null) chooseSomething();
  sectionOf(state.stop)?.scrollIntoView({block: "nearest"});
}

async function start() {
  const run = await loadRun(document, "This page");
  state.runs = [run];
  state.playbacks = [new Playback(run)];
  state.at = run.fragmentCount;
  showTitle();
  showStages();
  showStudent(run);
  offerCheck();
  listenToControls();
  listenToPicture();
  listenToSpace();
  listenToPlay();
  layOut();
  byId("message").textContent = "";
  readAddress();
  document.body.dataset.ready = "yes";
  // These are needed by some overlays only.
  for (const name of manifest.pictures) run.others[name] = await unpackPicture(byId(name).textContent, run.width, run.height);
  run.normalPicture = await unpackPicture(run.normals, run.width, run.height);
  if (["normals", "parts", ...manifest.pictures].includes(state.overlay)) update();
}

start().catch((error) => { byId("message").textContent = `This page cannot be shown: ${error.message}.`; });

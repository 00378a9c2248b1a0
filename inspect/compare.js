// A second run next to the first, and the places where they differ.

async function openOther(file) {
  byId("compare-note").textContent = `Reading ${file.name} …`;
  try {
    const page = new DOMParser().parseFromString(await file.text(), "text/html"); // its scripts do not run
    const run = await loadRun(page, `B: ${file.name}`);
    if (run.width !== state.runs[0].width || run.height !== state.runs[0].height) {
      throw new Error(`its picture has ${run.width} × ${run.height} pixels, but this page's has ${state.runs[0].width} × ${state.runs[0].height}`);
    }
    addRun(run);
    showDivergence();
  } catch (error) {
    byId("compare-note").textContent = `${file.name} cannot be compared with this page: ${error.message}.`;
  }
}

function addRun(run) {
  state.runs[0].name = "A: this page";
  state.runs[1] = run;
  state.playbacks[1] = new Playback(run);
  byId("close-other").hidden = byId("first-divergence").hidden = false;
  state.fitted = true;
  layOut();
}

function closeOther() {
  state.runs.length = state.playbacks.length = 1;
  byId("close-other").hidden = byId("first-divergence").hidden = true;
  byId("compare-note").textContent = "";
  byId("divergences").replaceChildren();
  state.fitted = true;
  layOut();
  update();
}

const sameNumbers = (a, b) => a.length === b.length && a.every((value, i) => Object.is(value, b[i]));
const firstDifference = (a, b) => {
  const common = Math.min(a.length, b.length);
  for (let i = 0; i < common; i++) if (a[i] !== b[i]) return i;
  return a.length === b.length ? -1 : common;
};

// The first fragment that belongs to another triangle, piece or pixel, has another fate or leaves
// other bytes: its number, and what differs. Columns of written bytes have only the written
// fragments, so they are compared fragment by fragment.
function firstFragmentDivergence(a, b) {
  const names = ["triangle", "piece", "x", "y", "fate"], common = Math.min(a.fragmentCount, b.fragmentCount);
  let first = a.fragmentCount === b.fragmentCount ? Infinity : common, what = "one run has more fragments";
  for (const name of names) {
    const at = firstDifference(a.columns[`fragment.${name}`].subarray(0, common), b.columns[`fragment.${name}`].subarray(0, common));
    if (at >= 0 && at < first) [first, what] = [at, {triangle: "another triangle", piece: "another piece", x: "another pixel", y: "another pixel", fate: "another fate"}[name]];
  }
  for (let i = 0; i < Math.min(first, common); i++) {
    const pa = a.place[i], pb = b.place[i];
    if (pa < 0 || pb < 0) continue;
    if (["r", "g", "b", "a"].some((k) => a.columns[`written.${k}`][pa] !== b.columns[`written.${k}`][pb])) return {at: i, what: "another colour"};
  }
  return Number.isFinite(first) ? {at: first, what} : null;
}

// The differences stage by stage, in the order of the data flow: a sentence for each, and the
// choice that shows it.
function divergencesOf(a, b) {
  const found = [], note = (text, choose) => found.push({text, choose});
  const fa = a.facts, fb = b.facts;
  if (!sameNumbers(fa.view.eye_from_world, fb.view.eye_from_world)) note("The view matrices differ.");
  if (!sameNumbers(fa.view.clip_from_eye, fb.view.clip_from_eye)) note("The projection matrices differ.");
  if (fa.draws.length !== fb.draws.length) note(`The runs have ${fa.draws.length} and ${fb.draws.length} draws.`);
  const draw = fa.draws.findIndex((each, i) => fb.draws[i] && !sameNumbers(each.clip_from_anchored, fb.draws[i].clip_from_anchored));
  if (draw >= 0) note(`The matrices of draw ${draw} differ.`);
  for (const axis of letters.slice(0, 3)) {
    const at = firstDifference(a.columns[`position.${axis}`], b.columns[`position.${axis}`]);
    if (at < 0) continue;
    note(`The positions differ from entry ${at} on.`);
    break;
  }
  const row = firstDifference(a.columns["triangle.number"], b.columns["triangle.number"]);
  if (row >= 0) note(`The triangles differ from the ${ordinal(row + 1)} on.`);
  const mark = firstDifference(a.columns["triangle.marks"], b.columns["triangle.marks"]);
  if (mark >= 0 && mark !== row) {
    const triangle = a.columns["triangle.number"][mark];
    note(`Triangle ${triangle} is the first with another result.`, {triangle, fragment: null});
  }
  const fragment = firstFragmentDivergence(a, b);
  if (fragment) note(`Fragment ${(fragment.at + 1).toLocaleString("en")} is the first that differs: ${fragment.what}.`, {fragment: fragment.at});
  return found;
}
const ordinal = (n) => `${n.toLocaleString("en")}${["th", "st", "nd", "rd"][n % 100 > 10 && n % 100 < 14 ? 0 : Math.min(n % 10, 4) % 4]}`;

function showDivergence() {
  const found = divergencesOf(state.runs[0], state.runs[1]);
  byId("compare-note").textContent = found.length ? "Differences in the order of the stages:" : "The two runs are equal, to the last byte.";
  byId("divergences").replaceChildren(...found.map(({text, choose}) => element("li", {},
    choose ? element("button", {type: "button", textContent: text, onclick: () => jumpTo(choose)}) : text)));
  const last = found.findLast(({choose}) => choose);
  byId("first-divergence").disabled = !last;
  byId("first-divergence").onclick = () => jumpTo(last.choose);
  if (last) jumpTo(last.choose);
  else update();
}

function jumpTo(choose) {
  if (choose.fragment === null || choose.fragment === undefined) change(choose);
  else chooseFragment(Math.min(choose.fragment, state.runs[0].fragmentCount - 1));
}

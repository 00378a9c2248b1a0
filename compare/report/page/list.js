// The list of all pairs: what it shows, in which order, and the way through it.

const verdictNames = {
  different: "Different",
  uncompared: "Not compared",
  missing: "Missing",
  new: "New",
  "within-tolerance": "Within tolerance",
  same: "Same",
};
const verdicts = Object.keys(verdictNames).filter((verdict) => manifest.pairs.some((pair) => pair.verdict === verdict));

// What is asked of the list. `show` has the states that are shown.
const wanted = {show: new Set(verdicts), text: "", sort: "worst"};

// Runs of digits count as numbers: 2 comes before 10.
const naturally = new Intl.Collator("en", {numeric: true}).compare;
const byName = (a, b) => naturally(a.name, b.name);

// The size of a difference; what could not be counted is infinite.
const pixelsOf = ({differences, verdict}) => differences?.differing_pixels ?? (verdict === "same" ? 0 : Infinity);
const stepsOf = ({differences, verdict}) => {
  const largest = differences?.largest ?? (verdict === "same" ? 0 : "unbounded");
  return largest === "unbounded" ? Infinity : largest;
};
const falling = (a, b) => (a === b ? 0 : b - a);

// The manifest has the worst first, state by state. Those of a state without sizes are put in the order of their names. All
// other orders keep this one among equals.
const hasNoSize = ({verdict}) => ["same", "new", "missing"].includes(verdict);
const byState = (a, b) => verdicts.indexOf(a.verdict) - verdicts.indexOf(b.verdict);
manifest.pairs.sort((a, b) => byState(a, b) || (hasNoSize(a) ? byName(a, b) : 0));

const orders = {
  worst: () => 0,
  name: byName,
  pixels: (a, b) => falling(pixelsOf(a), pixelsOf(b)),
  largest: (a, b) => falling(stepsOf(a), stepsOf(b)),
  state: (a, b) => byState(a, b) || byName(a, b),
};

let listed = []; // the pairs that the list shows, in its order
const rows = new Map(); // from a pair to its row

function setUpList() {
  document.body.classList.toggle("many", manifest.pairs.length > 1);
  for (const pair of manifest.pairs) rows.set(pair, rowOf(pair));
  byId("states").append(...verdicts.map((verdict) => {
    const box = element("input", {type: "checkbox", value: verdict});
    box.onchange = () => {
      wanted.show[box.checked ? "add" : "delete"](verdict);
      changeList();
    };
    const label = element("label", {}, box, element("span", {}, verdictNames[verdict], element("b", {}, numberText(numberWith(verdict)))));
    label.dataset.verdict = verdict;
    return label;
  }));
  byId("name-filter").oninput = () => { wanted.text = byId("name-filter").value; changeList(); };
  byId("sort").onchange = () => { wanted.sort = byId("sort").value; changeList(); };
}

const numberText = (number) => number.toLocaleString("en");
const numberWith = (verdict) => manifest.pairs.filter((pair) => pair.verdict === verdict).length;

function changeList() {
  showList();
  keepAddress();
}

// Without a text: the name stands beside it.
const thumbnailImage = (png) => element("img", {src: `data:image/png;base64,${png}`, alt: "", loading: "lazy", decoding: "async"});

function rowOf(pair) {
  const picture = pair.thumbnail ? thumbnailImage(pair.thumbnail) : null;
  const button = element("button", {type: "button", onclick: () => choosePair(pair)},
    element("span", {className: "thumbnail"}, picture), element("span", {className: "pair-name"}, pair.name),
    element("small", {}, shortFinding(pair), ...setAsideMarks(pair)));
  const row = element("li", {}, button, approvalBox(pair));
  row.dataset.verdict = pair.verdict;
  row.classList.toggle("flat", !pair.thumbnail);
  return row;
}

function shortFinding({differences, verdict, error, canvas}) {
  if (verdict === "same") return "same";
  if (!differences) return verdict === "different" ? "another kind of picture" : error?.cause ?? verdictNames[verdict];
  const size = differences.differing_pixels ? `, largest ${largestText(differences)}` : "";
  return `${canvas ? "another size; " : ""}${count(differences.differing_pixels, "pixel")}${size}`;
}

// How many pixels were set aside, each number with its colour of the heat map.
function setAsideMarks({differences}) {
  const mark = (level, aside, what) => aside?.pixels
    ? element("span", {className: "mark", title: `${count(aside.pixels, "pixel")} ${what}`},
        swatch(level), numberText(aside.pixels), element("span", {className: "hidden"}, ` ${what}`))
    : null;
  return [mark(movedEdge, differences?.moved_edges, "at moved edges"),
    mark(belowThreshold, differences?.below_threshold, "below the threshold")].filter(Boolean);
}

// Shows the pairs that are wanted, and the controls as they are.
function showList() {
  const part = wanted.text.toLocaleLowerCase("en");
  listed = manifest.pairs.filter(({name, verdict}) => wanted.show.has(verdict) && name.toLocaleLowerCase("en").includes(part))
    .sort(orders[wanted.sort]);
  byId("pairs").replaceChildren(...listed.map((pair) => rows.get(pair)));
  for (const box of byId("states").querySelectorAll("input")) box.checked = wanted.show.has(box.value);
  if (byId("name-filter").value !== wanted.text) byId("name-filter").value = wanted.text;
  byId("sort").value = wanted.sort;
  byId("list-count").textContent = listed.length === manifest.pairs.length ? count(listed.length, "pair")
    : `${numberText(listed.length)} of ${count(manifest.pairs.length, "pair")}`;
  showPlaceInList();
}

// Where the open pair is in the list.
function showPlaceInList() {
  const place = listed.indexOf(state.facts);
  byId("place").textContent = place < 0 ? "not in the list" : `${numberText(place + 1)} of ${numberText(listed.length)}`;
  byId("previous").disabled = place === 0 || !listed.length;
  byId("next").disabled = place === listed.length - 1 || !listed.length;
  byId("pairs").querySelector("[aria-current]")?.removeAttribute("aria-current");
  const row = rows.get(state.facts);
  if (place < 0) return;
  row.firstChild.setAttribute("aria-current", "true");
  scrollInside(byId("pairs"), row);
}

// Scrolls the list, and not the page, until the row is seen.
function scrollInside(list, row) {
  const [inside, box] = [list.getBoundingClientRect(), row.getBoundingClientRect()];
  if (box.top < inside.top) list.scrollTop -= inside.top - box.top;
  if (box.bottom > inside.bottom) list.scrollTop += box.bottom - inside.bottom;
}

// The next pair of the list, or the one before; the first or the last where the open one is not in it.
function stepPair(by) {
  const place = listed.indexOf(state.facts), next = place < 0 ? (by > 0 ? 0 : listed.length - 1) : place + by;
  if (listed[next]) choosePair(listed[next]);
}

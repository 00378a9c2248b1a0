// The page's address has the open pair and what is asked of the list: #show=different,new&name=TEXT&sort=name&pair=NAME.
// Parts that are as at the beginning are not in it. Two names that are not UTF-8 may look the same: a pair that no list of
// names can have is at=INDEX, its index in the manifest.

function addressOf(pair) {
  const parts = new URLSearchParams();
  if (wanted.show.size < verdicts.length) parts.set("show", [...wanted.show].join());
  if (wanted.text) parts.set("name", wanted.text);
  if (wanted.sort !== "worst") parts.set("sort", wanted.sort);
  if (pair === manifest.pairs[0] && !parts.size) return "#";
  if (pair.not_listed) parts.set("at", manifest.pairs.indexOf(pair));
  else parts.set("pair", pair.name);
  return `#${parts}`;
}

// A browser may refuse when the address changes too often; the page works without.
function setAddress(how, address) {
  if (location.hash === address || (address === "#" && !location.hash)) return;
  try {
    history[how](null, "", address);
  } catch {}
}

const keepAddress = () => setAddress("replaceState", addressOf(state.facts));

// Opens a pair as a new step, which the browser's Back button takes back.
function choosePair(pair) {
  if (pair === state.facts) return;
  setAddress("pushState", addressOf(pair));
  openPair(pair);
}

// Shows what the address asks for.
function followAddress() {
  const parts = new URLSearchParams(location.hash.slice(1));
  const show = parts.get("show")?.split(",");
  wanted.show = new Set(verdicts.filter((verdict) => !show || show.includes(verdict)));
  wanted.text = parts.get("name") ?? "";
  wanted.sort = Object.hasOwn(orders, parts.get("sort") ?? "") ? parts.get("sort") : "worst";
  showList();
  const isMeant = (pair, index) => pair.not_listed ? String(index) === parts.get("at") : pair.name === parts.get("pair");
  const pair = manifest.pairs.find(isMeant) ??
    (parts.has("show") || parts.has("name") || parts.has("sort") ? listed[0] : null) ?? manifest.pairs[0];
  if (pair !== state.facts) openPair(pair);
}

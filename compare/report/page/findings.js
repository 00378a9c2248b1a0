// What is said of a pair in words and numbers, and the list of all pairs.

const verdictNames = {
  different: "Different",
  uncompared: "Not compared",
  missing: "Missing",
  new: "New",
  "within-tolerance": "Within tolerance",
  same: "Same",
};

function showTitle() {
  document.title = byId("title").textContent = manifest.title;
  const counts = Object.keys(verdictNames).map((verdict) => [verdict, numberWith(verdict)]);
  byId("summary").textContent = counts.filter(([, number]) => number > 0)
    .map(([verdict, number]) => `${number.toLocaleString("en")} ${verdictNames[verdict].toLowerCase()}`).join(" · ");
}

const numberWith = (verdict) =>
  manifest.pairs.filter((pair) => pair.verdict === verdict).length + (verdict === "same" ? manifest.same.length : 0);

// The list of pairs; nothing for a single one.
function listPairs() {
  if (manifest.pairs.length + manifest.same.length < 2) return;
  document.body.classList.add("many");
  for (const verdict of Object.keys(verdictNames)) {
    const list = element("ol", {});
    manifest.pairs.forEach((pair, index) => {
      if (pair.verdict === verdict) list.append(element("li", {}, pairButton(pair, index)));
    });
    if (list.children.length) byId("pairs").append(element("h3", {}, verdictNames[verdict]), list);
  }
  if (!manifest.same.length) return;
  byId("pairs").append(element("details", {id: "same"}, element("summary", {}, `${manifest.same.length} the same`),
    element("ul", {}, ...manifest.same.map((name) => element("li", {}, name)))));
}

function pairButton(pair, index) {
  const button = element("button", {type: "button", onclick: () => openPair(index)},
    element("span", {className: "pair-name"}, pair.name), element("small", {}, shortFinding(pair)));
  button.dataset.verdict = pair.verdict;
  return button;
}

function shortFinding({differences, verdict, error, canvas}) {
  if (!differences) return verdict === "different" ? "another kind of picture" : error.cause;
  return `${canvas ? "another size; " : ""}${count(differences.differing_pixels, "pixel")}, largest ${largestText(differences)}`;
}

const errorText = ({file, place, cause, remedy}) =>
  [file, place, cause].filter(Boolean).join(": ") + (remedy ? `; ${remedy}` : "");

function largestText({largest}, unit = "") {
  if (largest === "unbounded") return "∞";
  return (largest < 1e7 ? largest.toLocaleString("en") : largest.toExponential(2).replace("+", "")) + unit;
}

function showFindings(pair) {
  byId("name").textContent = pair.name;
  byId("verdict").textContent = verdictNames[pair.verdict];
  byId("verdict").dataset.verdict = pair.verdict;
  byId("decisive").textContent = pair.error ? errorText(pair.error) : pair.reasons?.[0] ?? "";
  byId("pairs").querySelectorAll("button").forEach((button) => button.removeAttribute("aria-current"));
  pairButtonAt(manifest.pairs.indexOf(pair))?.setAttribute("aria-current", "true");
  byId("details").replaceChildren(...[
    section("Reasons", sentences(pair.reasons?.slice(1))),
    section("Likely causes", sentences(pair.hints)),
    section("Notes", sentences(pair.notes)),
    section("Tolerance", toleranceText(pair)),
    section("Options that would let it pass", sentences(pair.suggestions)),
    section("Metrics", metricsTable(pair.metrics)),
    section("Show how the first differing pixel was made", command(pair.inspect_command)),
    section("Files", factsTable(pair)),
    section("This report", element("p", {className: "quiet"}, manifest.program), command(manifest.command)),
  ].filter(Boolean));
}

// The button of the pair with this index of the manifest.
function pairButtonAt(index) {
  const {verdict} = manifest.pairs[index];
  const place = manifest.pairs.slice(0, index).filter((pair) => pair.verdict === verdict).length;
  return byId("pairs").querySelectorAll(`button[data-verdict="${verdict}"]`)[place];
}

const section = (title, ...content) => content[0] && element("section", {}, element("h3", {}, title), ...content);

const sentences = (texts) =>
  texts?.length ? element("ul", {}, ...texts.map((text) => element("li", {}, text))) : null;

function toleranceText({tolerance, tolerance_reason}) {
  if (!tolerance) return null;
  return element("div", {}, element("code", {}, tolerance), element("p", {}, tolerance_reason ?? ""));
}

function metricsTable(metrics) {
  if (!metrics) return null;
  const row = ({name, value, why_not, limit, passes = true}) => element("tr", {className: passes ? "" : "fails"},
    element("th", {scope: "row"}, name), element("td", {}, metricText(value) ?? why_not),
    element("td", {}, limit ? `${limit.slice(name.length)} ${passes ? "✓" : "✗"}` : ""));
  return element("table", {}, element("tbody", {}, ...metrics.map(row)));
}

function factsTable({reference, test}) {
  const row = (title, {path, width, height, channels, format}) => element("tr", {},
    element("th", {scope: "row"}, title), element("td", {}, path, element("br", {}),
      element("span", {className: "quiet"}, width ? `${width} × ${height}, ${channels}, ${format}` : "")));
  return element("table", {}, element("tbody", {}, row("Reference", reference), row("Test", test)));
}

const metricText = (value) => (typeof value === "number" ? String(Number(value.toPrecision(6))) : value);

// A command line with a button that copies it.
function command(text) {
  if (!text) return null;
  const code = element("code", {}, text);
  const button = element("button", {type: "button"}, "Copy");
  button.onclick = async () => {
    try {
      await navigator.clipboard.writeText(text);
      button.textContent = "Copied";
    } catch {
      getSelection().selectAllChildren(code);
      button.textContent = "Selected: press Ctrl+C";
    }
  };
  return element("div", {className: "command"}, code, button);
}

function listRegions({differences, regions}) {
  byId("regions").hidden = !differences;
  if (!differences) return;
  const unit = unitOf[state.pair.pictures[0]?.type] ?? "";
  byId("regions-note").textContent = `${count(differences.differing_pixels, "pixel")} of ` +
    `${differences.compared_pixels.toLocaleString("en")} in ${count(differences.region_count ?? 0, "region")}` +
    setAsideText(differences) +
    (differences.region_count > regions.length ? `; the worst ${regions.length} are listed` : "");
  byId("region-list").replaceChildren(...regions.map((region, index) => {
    const {x, y, width, height} = region.box;
    return element("li", {}, element("button", {type: "button", onclick: () => goToRegion(index)},
      element("b", {}, largestText(region, unit)), element("span", {}, `${width}×${height} at ${x}, ${y}`),
      element("span", {className: "quiet"}, count(region.pixels, "pixel"))));
  }));
}

function setAsideText({moved_edges, below_threshold}) {
  return (moved_edges ? `; ${count(moved_edges.pixels, "pixel")} at moved edges` : "") +
    (below_threshold ? `; ${count(below_threshold.pixels, "pixel")} below the threshold` : "");
}

function markRegion(index) {
  [...byId("region-list").children].forEach(({firstChild}, i) => {
    firstChild.toggleAttribute("aria-current", i === index);
    if (i === index) firstChild.scrollIntoView({block: "nearest"});
  });
}

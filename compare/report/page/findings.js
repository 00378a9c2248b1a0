// What is said of a pair in words and numbers.

function showTitle() {
  document.title = byId("title").textContent = manifest.title;
  const counts = Object.keys(verdictNames).map((verdict) => [verdict, numberWith(verdict)]);
  byId("summary").textContent = counts.filter(([, number]) => number > 0)
    .map(([verdict, number]) => `${numberText(number)} ${verdictNames[verdict].toLowerCase()}`).join(" · ");
}

const errorText = ({file, place, cause, remedy}) =>
  [file, place, cause].filter(Boolean).join(": ") + (remedy ? `; ${remedy}` : "");

function largestText({largest}, unit = "") {
  if (largest === "unbounded") return "∞";
  return (largest < 1e7 ? numberText(largest) : largest.toExponential(2).replace("+", "")) + unit;
}

function showFindings(pair) {
  byId("name").textContent = pair.name;
  byId("verdict").textContent = verdictNames[pair.verdict];
  byId("verdict").dataset.verdict = pair.verdict;
  byId("decisive").textContent = pair.error ? errorText(pair.error) : pair.reasons?.[0] ?? "";
  showPlaceInList();
  showApproval();
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
  const code = element("code", {}, text), button = element("button", {type: "button"}, "Copy");
  button.onclick = () => copy(text, button, code);
  return element("div", {className: "command"}, code, button);
}

// Copies the text; where the browser does not allow this, selects it where it stands. The button says which.
async function copy(text, button, place) {
  try {
    await navigator.clipboard.writeText(text);
    button.textContent = "Copied";
  } catch {
    getSelection().selectAllChildren(place);
    button.textContent = "Selected: press Ctrl+C";
  }
}

// The exact regions; the boxes on the pictures are fewer where regions lie close together.
function listRegions({differences, regions}) {
  const {differing_pixels, moved_edges, below_threshold} = differences ?? {};
  byId("regions").hidden = !differing_pixels && !moved_edges && !below_threshold;
  if (!differences) return;
  const unit = unitOf[state.pair.pictures[0]?.type] ?? "";
  byId("regions-note").textContent = `${count(differences.differing_pixels, "pixel")} of ` +
    `${numberText(differences.compared_pixels)} in ${count(differences.region_count ?? 0, "region")}` +
    (differences.region_count > regions.length ? `; the worst ${regions.length} are listed` : "");
  byId("set-aside").replaceChildren(...setAsideLines(differences, unit));
  byId("region-list").replaceChildren(...regions.map((region, index) => {
    const {x, y, width, height} = region.box;
    return element("li", {}, element("button", {type: "button", onclick: () => goToRegion(index)},
      element("b", {}, largestText(region, unit)), element("span", {}, `${width}×${height} at ${x}, ${y}`),
      element("span", {className: "quiet"}, count(region.pixels, "pixel"))));
  }));
}

// What is counted apart, each with its colour in the heat map.
function setAsideLines({moved_edges, below_threshold}, unit) {
  const line = (level, {pixels, largest}, what) => element("li", {}, swatch(level),
    `${count(pixels, "pixel")} ${what}${pixels ? `, by up to ${largestText({largest}, unit)}` : ""}: not counted as different`);
  return [moved_edges && line(movedEdge, moved_edges, "at moved edges"),
    below_threshold && line(belowThreshold, below_threshold, "below the threshold")].filter(Boolean);
}

function markRegion(index) {
  [...byId("region-list").children].forEach(({firstChild}, i) => {
    firstChild.toggleAttribute("aria-current", i === index);
    if (i === index) scrollInside(byId("region-list"), firstChild);
  });
}

// The panel on the right: the pixel's fragments, and the chain of the chosen triangle, vertex and
// fragment.

function showPanel() {
  showPixel();
  const run = state.runs[0], fragment = state.fragment === null ? null : fragmentOf(run, state.fragment);
  const other = state.runs[1] && counterpart(state.runs[1], fragment);
  const chain = fragment?.chain ?? (state.triangle === null ? null : chainOf(run, state.triangle));
  const steps = chain ? chainSections(run, chain, fragment, other?.chain) : [];
  byId("chain").replaceChildren(...(chain ? chainHeading(run, chain) : [nothingChosen(fragment)]),
    ...studentSections(run, state.triangle), ...steps,
    ...(fragment ? fragmentSections(run, fragment, other?.fragment) : []), ...recordSections(run, fragment));
}

// Finds the same fragment, and the same triangle, in the second run.
function counterpart(run, fragment) {
  const there = state.fragment !== null && state.fragment < run.fragmentCount ? fragmentOf(run, state.fragment) : null;
  const same = there && fragment && there.x === fragment.x && there.y === fragment.y && there.number === fragment.number;
  const number = fragment?.number ?? state.triangle;
  return {fragment: same ? {...there, name: run.name} : null, chain: number === null ? null : chainOf(run, number)};
}

function nothingChosen(fragment) {
  return element("p", {className: "quiet"}, fragment ? "This fragment comes from a line or a point, not from a triangle." :
    state.cursor ? `No fragment came here so far: the pixel shows the background. ${whyEmpty(eventsAt(state.runs[0], state.cursor.x, state.cursor.y))}` :
      "Click in the picture, or enter the number of a triangle.");
}

function whyEmpty(events) {
  if (!events.length) return "Click on something that is drawn, or enter the number of a triangle.";
  const told = events.slice(0, 3).map((event) => `Triangle ${event.number}: ${eventText(event)}.`), rest = events.length - told.length;
  return [...told, rest ? `The list above has ${rest.toLocaleString("en")} more.` : ""].join(" ");
}

// ---- the pixel ----

function showPixel() {
  const {cursor} = state, run = state.runs[0];
  byId("pixel-fragments").replaceChildren();
  byId("pixel-title").textContent = cursor ? `Pixel (${cursor.x}, ${cursor.y})` : "Pixel";
  if (!cursor) {
    byId("pixel-note").textContent = "No pixel is chosen.";
    return;
  }
  const list = historyOf(run, cursor.x, cursor.y), events = eventsAt(run, cursor.x, cursor.y), at = 4 * (cursor.y * run.width + cursor.x);
  const bytes = Array.from(state.playbacks[0].picture.subarray(at, at + 4));
  byId("pixel-note").textContent = `${count(list.length - events.length, "fragment")}; shows ${bytesText(bytes)}` +
    (events.length ? `; without a fragment: ${eventCounts(events)}` : "");
  const items = list.slice(0, 200).map(({fragment, event}) => element("li", {}, event ? eventButton(event) : fragmentButton(run, fragment)));
  byId("pixel-fragments").append(...items);
  const chosen = items.find((item) => item.querySelector("[aria-current]"));
  if (chosen && items.length > 6) byId("pixel-fragments").scrollTop = chosen.offsetTop - 3 * chosen.offsetHeight;
}
const bytesText = ([r, g, b, a]) => `(${r}, ${g}, ${b})` + (a === 255 ? "" : ` alpha ${a}`);

function fragmentButton(run, i) {
  const number = run.columns["fragment.triangle"][i], fate = fates[run.columns["fragment.fate"][i]];
  const button = element("button", {type: "button", onclick: () => chooseFragment(i)},
    element("span", {}, number === noTriangle ? "line or point" : `triangle ${number}`),
    element("span", {className: `fate fate-${fate}`}, fate),
    element("small", {}, `fragment ${(i + 1).toLocaleString("en")}`));
  if (i === state.fragment) button.setAttribute("aria-current", "true");
  if (i >= state.at) button.classList.add("later");
  return button;
}

// A triangle that would have covered the pixel. A click chooses it, and the pixel stays.
function eventButton(event) {
  const {number, fate} = event, button = element("button", {type: "button", onclick: () => chooseHere(number)},
    element("span", {}, `triangle ${number}`), element("span", {className: `fate fate-${fate}`}, fate), element("small", {}, "no fragment"),
    element("small", {className: "why"}, eventText(event)));
  if (state.fragment === null && state.triangle === number) button.setAttribute("aria-current", "true");
  return button;
}

// ---- the chain ----

function chainHeading(run, chain) {
  const {draw} = chain, mesh = run.facts.meshes[draw.mesh].name;
  return [element("h2", {}, `Triangle ${chain.number}`),
    element("p", {className: "quiet"}, `Face ${chain.face} of mesh ${mesh || draw.mesh}, instance ${draw.instance}` +
      (draw.material ? `, material ${draw.material}` : "")),
    element("p", {id: "verdict"}, verdictOf(run, chain)), vertexChoice(chain)];
}

const vertexName = (vertex) => (vertex < 3 ? "ABC"[vertex] : `V${vertex - 3}`);

// Buttons for the triangle's corners and, if it was cut, for the vertices of the polygon.
function vertexChoice(chain) {
  const names = [0, 1, 2, ...(chain.marks & marks.cut ? chain.polygon.map((_, k) => 3 + k) : [])].map((value) => [value, vertexName(value)]);
  return element("fieldset", {className: "segments", id: "vertices"}, element("legend", {className: "hidden"}, "Vertex"),
    ...names.map(([value, name]) => {
      const input = element("input", {type: "radio", name: "vertex", value, checked: state.vertex === value,
        onchange: () => change({vertex: value}, "vertex")});
      input.setAttribute("aria-label", value < 3 ? `Corner ${name}` : `Vertex ${name} after clipping`);
      return element("label", {}, input, element("span", {}, name));
    }));
}

// A step of the chain. `id` is that of its stop, if it is one.
const step = (id, name, ...content) => element("section", {className: "step", id: `step-${id}`}, element("h3", {}, name), ...content);

function chainSections(run, chain, fragment, other) {
  const {facts} = run, vertexOfCorner = (c, k) => c?.polygon.find(({corner}) => corner === c.corners[k]);
  const isCorner = state.vertex < 3, k = isCorner ? state.vertex : 0;
  const corner = isCorner ? chain.corners[k] : null, otherCorner = isCorner ? other?.corners[k] : null;
  const vertex = isCorner ? vertexOfCorner(chain, k) : chain.polygon[state.vertex - 3];
  const otherVertex = isCorner ? vertexOfCorner(other, k) : other?.polygon[state.vertex - 3];
  const sections = [];
  if (corner) {
    sections.push(
      step("object", `Object (position ${corner.position})`, numbersTable("object", coordinateRows(corner.object, "float", null, otherCorner?.object)),
        modelMatrix(chain.draw)),
      step("world", "World", numbersTable("world", coordinateRows(corner.world, "double", corner.bound.world, otherCorner?.world)), viewMatrix(facts)),
      step("eye", "Eye", numbersTable("eye", coordinateRows(corner.eye, "double", corner.bound.eye, otherCorner?.eye)), projectionMatrix(facts),
        composedMatrix(chain.draw)),
      step("clip", "Clip", numbersTable("clip", coordinateRows(corner.clip, "float", corner.bound.clip, otherCorner?.clip)),
        planesOpened(facts, corner)));
  } else {
    sections.push(step("clip", "Clip, made by clipping", numbersTable("clip", coordinateRows(vertex.clip, "float", null, otherVertex?.clip)),
      numbersTable("weights of the corners", vertex.weights.map((value, i) => ({name: "ABC"[i], value, kind: "double"})))));
  }
  if (chain.marks & marks.cut) sections.push(polygonSection(chain));
  if (!vertex) return sections;
  const {ndc, screen, snapped, bound} = vertex;
  sections.push(
    step("ndc", "NDC: divided by w", numbersTable("NDC", [...coordinateRows(ndc.position, "float", bound?.ndc.position, otherVertex?.ndc.position),
      {name: "1/w", value: ndc.inverseW, kind: "float", bound: bound?.ndc.inverseW, other: otherVertex?.ndc.inverseW}]),
    vertex.condition ? element("p", {className: "quiet"}, `A relative change of the input is magnified by ${vertex.condition.map(shortNumber).join(", ")}.`) :
      element("p", {className: "quiet"}, "There are no bounds for vertices that clipping made."), viewportMatrix(facts)),
    step("screen", "Screen, pixels", numbersTable("screen", coordinateRows(screen.position, "float", bound?.screen, otherVertex?.screen.position))),
    step("snapped", "Snapped, 1/256 pixel", numbersTable("snapped", coordinateRows(snapped, "integer", null, otherVertex?.snapped)),
      bound ? element("p", {className: "quiet"}, snapText(bound.snap)) : null));
  sections.push(...pieceSections(chain, fragment));
  return sections;
}

function snapText(stabilities) {
  return stabilities.map(({toBoundary, stable}, k) => `${letters[k]} is ${shortNumber(toBoundary)} pixels from where it would snap to ` +
    `another position, ${stable ? "beyond" : "within"} its bound`).join("; ") + ".";
}

function planesOpened({planes}, corner) {
  const outside = planes.filter((plane) => signedDistance(plane, corner.clip) < 0).map(({name}) => name);
  return opened(outside.length ? `Outside: ${outside.join(", ")}` : "Inside all planes", "planes",
    numbersTable("distances", planes.map((plane) => ({name: plane.name, value: signedDistance(plane, corner.clip), kind: "double"}))));
}

function polygonSection(chain) {
  return step("clipped", "Clipped polygon", element("ol", {}, ...chain.polygon.map(({clip, weights}, k) =>
    element("li", {}, `V${k} (${clip.map((value) => floatText(value)).join(", ")})`,
      element("small", {}, weights.includes(1) ? ` corner ${"ABC"[weights.indexOf(1)]}` : " made by a plane")))));
}

function pieceSections(chain, fragment) {
  const piece = fragment?.piece ?? chain.pieces[0];
  if (!piece) return [];
  const {setup} = piece, name = chain.pieces.length > 1 ? ` (piece ${chain.pieces.indexOf(piece) + 1} of ${chain.pieces.length})` : "";
  if (!setup) return [step("facing", "Facing" + name, element("p", {}, "It has no area, so it faces nowhere."))];
  return [step("facing", "Facing" + name, element("p", {}, `${setup.clockwise ? "Clockwise" : "Counter-clockwise"} on the screen, ` +
    `${doubleText(setup.doubleArea / 131072)} square pixels: shows its ${piece.front ? "front" : "back"}, ` +
    (piece.culled ? "culled." : "kept."))),
  step("edges", "Edges", numbersTable("edges", setup.edges.flatMap(({a, b, c}, k) =>
    [["a", a], ["b", b], ["c", c]].map(([factor, value]) => ({name: `${factor}${k}`, value, kind: "integer"})))),
  element("p", {className: "quiet"}, "E = a x + b y + c in 1/65536 square pixel; positive inside."))];
}

// ---- the fragment ----

function fragmentSections(run, fragment, other) {
  const sections = [];
  if (fragment.chain) {
    const {bound} = fragment;
    sections.push(
      step("fragment", `Fragment at (${fragment.x}, ${fragment.y})`,
        numbersTable("edge functions at the pixel's centre", fragment.edges.map((value, k) =>
          ({name: `E${k}`, value, kind: "integer", other: other?.edges[k]}))),
        numbersTable("weights on the screen", fragment.lambda.map((value, k) =>
          ({name: `λ${k}`, value, kind: "float", bound: bound?.lambda[k], other: other?.lambda[k]}))),
        numbersTable("weights in space", fragment.weights.map((value, k) =>
          ({name: `weight ${"ABC"[fragment.piece.setup.order[k]] ?? k}`, value, kind: "float", bound: bound?.weights[k], other: other?.weights[k]}))),
        numbersTable("depth and 1/w", [
          {name: "depth", value: fragment.depth, kind: "float", bound: bound?.depth, other: other?.depth},
          {name: "1/w", value: fragment.inverseW, kind: "float", bound: bound?.inverseW, other: other?.inverseW}])));
  }
  sections.push(step("depth", "Depth test", element("p", {}, depthText(run, fragment))), step("colour", "Colour", colourText(fragment), ...(other ? [element("p", {className: "quiet"}, other.name), colourText(other)] : [])));
  return sections;
}

function depthText(run, {code, stored, fate}) {
  const readable = (value) => (value === emptyDepth ? "nothing" : `0x${hexOf(value, 8)}` +
    (run.facts.depth_format === "d32" ? ` = ${floatText(floatOfBits(value))}` : ""));
  return `${readable(code)} against ${readable(stored.code)}` +
    (stored.by >= 0 ? ` of fragment ${(stored.by + 1).toLocaleString("en")}` : " stored") +
    `: ${fate === "hidden" ? "not in front" : "in front"}.`;
}
function floatOfBits(bits) {
  bitStore.setUint32(0, bits);
  return bitStore.getFloat32(0);
}

function colourText({fate, before, after}) {
  const patch = (bytes) => {
    const made = element("i", {className: "patch"});
    made.style.background = `rgb(${bytes.slice(0, 3)})`;
    return made;
  };
  if (fate === "hidden" || fate === "discarded") return element("p", {}, `${fate === "hidden" ? "Hidden" : "Discarded by the alpha mask"}: the pixel keeps `, patch(before), bytesText(before));
  return element("p", {}, `${fate === "blended" ? "Blended" : "Written"}: `, patch(before), bytesText(before), " → ", patch(after), bytesText(after));
}

// ---- all records, where the page has them ----

function recordSections(run, fragment) {
  const at = fragment && recordOf(run, fragment);
  if (at === undefined || at === null || at < 0) return [];
  const row = (name, size, names = letters) => Array.from(run.columns[`record.${name}`].subarray(size * at, size * (at + 1)),
    (value, k) => ({name: names[k], value, kind: "float"}));
  if (fragment.fate === "hidden") return [];
  const colour = ["r", "g", "b", "a"];
  return [step("attributes", "Attributes", ...[["normal", 3], ["position", 3], ["color", 4, colour], ["texcoord", 2, ["u", "v"]]].flatMap(([name, size, names]) =>
    [element("h4", {}, {normal: "normal, eye space", position: "position, eye space", color: "vertex colour", texcoord: "texture coordinates"}[name]),
      numbersTable(name, row(name, size, names))])),
  step("surface", "Surface: material · vertex colour · texture", numbersTable("surface", row("surface", 4, colour))),
  step("light", "Light: linear", numbersTable("light", row("light", 4, colour)))];
}

// The index of a fragment's records, which exist for the recorded pixels only, in order; -1 if the
// page does not have them.
function recordOf(run, {index}) {
  if (!run.facts.records_complete) return -1;
  run.recorded ??= new Map(recordedFragments(run).map((each, at) => [each, at]));
  return run.recorded.get(index) ?? -1;
}
function recordedFragments(run) {
  const [x0, y0, x1, y1] = run.facts.recorded, found = [];
  const x = run.columns["fragment.x"], y = run.columns["fragment.y"];
  for (let i = 0; i < run.fragmentCount; i++) {
    if (x[i] >= x0 && x[i] < x1 && y[i] >= y0 && y[i] < y1) found.push(i);
  }
  return found;
}

// Follows a triangle, and a fragment, through all stages: computes every number again from the
// positions.

const corners = ["a", "b", "c"];

function positionOf(run, draw, index) {
  const at = run.facts.meshes[draw.mesh].firstPosition + index, c = run.columns;
  return {index: c["position.index"][at], object: [c["position.x"][at], c["position.y"][at], c["position.z"][at]]};
}

const anchoredFrom = (draw, object) => object.map((value, k) => f32(value - draw.anchor[k]));

function cornerOf(run, draw, index) {
  const {view, planes} = run.facts, {index: position, object} = positionOf(run, draw, index);
  const anchored = anchoredFrom(draw, object);
  const world = affineDouble(draw.world_from_object, object), eye = affineDouble(view.eye_from_world, world);
  const clip = clipFrom(draw.clip_from_anchored, anchored);
  const bound = {world: affineBound(draw.world_from_object, object, [0, 0, 0])};
  bound.eye = affineBound(view.eye_from_world, world, bound.world);
  const lost = object.map((value, k) => Math.abs(value - draw.anchor[k] - anchored[k]));
  bound.clip = transformBound(draw.clip_from_anchored, [...anchored, 1], [...lost, 0], draw.clip_bound);
  const magnitude = [0, 1, 2, 3].map((row) => magnitudeOfRow(draw.clip_from_anchored, row, [...anchored, 1]));
  return {position, object, anchored, world, eye, clip, outcode: outcodeOf(clip, planes), bound, magnitude};
}

// A vertex of the polygon on the screen. `corner` is given if clipping left it unchanged; its
// bounds are then continued.
function vertexOf(run, clip, weights, corner) {
  const {viewport} = run.facts.view, ndc = divide(clip), screen = toScreen(ndc, viewport), snapped = snapVertex(screen);
  const vertex = {clip, weights, corner, ndc, screen, snapped};
  if (!corner) return vertex;
  const ndcBound = divideBound(clip, corner.bound.clip);
  const bound = {clip: corner.bound.clip, ndc: ndcBound, screen: screenBound(ndc.position, ndcBound.position, viewport)};
  bound.snap = [0, 1].map((k) => snapStability(screen.position[k], bound.screen[k]));
  return {...vertex, bound, condition: divideCondition(clip, corner.magnitude)};
}

function isCulled({cull}, draw, front) {
  return {material: !front && !draw.double_sided, back: !front, front, none: false}[cull];
}

function pieceOf(run, draw, polygon, indexes) {
  const vertices = indexes.map((i) => polygon[i]);
  const setup = setUpTriangle(vertices.map(({screen}) => screen), vertices.map(({snapped}) => snapped));
  if (!setup) return {indexes, vertices, setup: null};
  const front = setup.clockwise === draw.mirrored;
  return {indexes, vertices, setup, front, culled: isCulled(run.facts, draw, front)};
}

// All numbers of a triangle with this number in the scene; null if the page does not have it.
function chainOf(run, number) {
  const row = run.rowOf.get(number);
  if (row === undefined) return null;
  const c = run.columns, draw = drawOfRow(run, row);
  const made = corners.map((corner) => cornerOf(run, draw, c[`triangle.${corner}`][row]));
  const fate = c["triangle.marks"][row];
  let polygon = [];
  if (fate & marks.cut) {
    polygon = (run.cut.get(number) ?? []).map(({clip, weights}) =>
      vertexOf(run, clip, weights, made[weights.indexOf(1)]));
  } else if (!(fate & (marks.rejected | marks.clippedAway))) {
    polygon = made.map((corner, k) => vertexOf(run, corner.clip, [0, 1, 2].map((i) => Number(i === k)), corner));
  }
  const apex = polygon.length > 3 ? fanApex(polygon.map(({snapped}) => snapped)) : 0;
  const pieces = Array.from({length: Math.max(0, polygon.length - 2)}, (_, i) =>
    pieceOf(run, draw, polygon, [apex, (apex + i + 1) % polygon.length, (apex + i + 2) % polygon.length]));
  return {number, row, draw, face: c["triangle.face"][row], marks: fate, corners: made, polygon, pieces};
}

// Keeps the chain of the last triangle, because fragments of one triangle usually follow each
// other.
function cachedChain(run, number) {
  if (run.lastChain?.number !== number) run.lastChain = chainOf(run, number);
  return run.lastChain;
}

function codeOf(run, i) {
  if (run.columns["fragment.triangle"][i] === noTriangle) return run.lineCode.get(i);
  return depthCode(run.facts.depth_format, depthOf(run, i));
}

function depthOf(run, i) {
  const c = run.columns, piece = cachedChain(run, c["fragment.triangle"][i])?.pieces[c["fragment.piece"][i]];
  if (!piece?.setup) return NaN;
  const {setup} = piece, x = c["fragment.x"][i], y = c["fragment.y"][i];
  return interpolateDepth(setup, f32(f32(edgeAt(setup.edges[1], x, y)) * setup.inverseArea),
    f32(f32(edgeAt(setup.edges[2], x, y)) * setup.inverseArea));
}

// The contents of the depth buffer when fragment i arrived: the last fragment there that was
// written, not blended.
function storedBefore(run, i) {
  for (let at = run.before[i]; at >= 0; at = run.before[at]) {
    if (run.columns["fragment.fate"][at] === 2) return {code: codeOf(run, at), by: at};
  }
  return {code: emptyDepth, by: -1};
}

function fragmentOf(run, i) {
  const c = run.columns, number = c["fragment.triangle"][i];
  const fragment = {index: i, x: c["fragment.x"][i], y: c["fragment.y"][i], fate: fates[c["fragment.fate"][i]],
    stored: storedBefore(run, i), ...bytesAround(run, i), number: number === noTriangle ? null : number};
  if (fragment.number === null) return {...fragment, code: codeOf(run, i)};
  const chain = chainOf(run, number), piece = chain?.pieces[c["fragment.piece"][i]];
  // A student's function took part in the run and drew what the page's arithmetic does not.
  if (!piece?.setup) return {...fragment, code: NaN};
  const {setup} = piece;
  const edges = setup.edges.map((edge) => edgeAt(edge, fragment.x, fragment.y));
  const numbers = interpolateFragment(setup, edges);
  const known = piece.vertices.every(({bound}) => bound);
  const vertex = (k) => piece.vertices[setup.order[k]].bound;
  const bound = known ? fragmentBounds(setup, numbers, {
    depth: [0, 1, 2].map((k) => vertex(k).screen[2]), inverseW: [0, 1, 2].map((k) => vertex(k).ndc.inverseW)}) : null;
  return {...fragment, chain, piece, pieceIndex: c["fragment.piece"][i], edges, ...numbers, bound,
    code: depthCode(run.facts.depth_format, numbers.depth)};
}

// The reason why nothing of a triangle is visible, or only a part.
function verdictOf(run, chain) {
  const {planes} = run.facts, {marks: m} = chain;
  if (m & marks.rejected) {
    const codes = chain.corners.map(({outcode}) => outcode), common = codes.reduce((a, b) => a & b, -1);
    if (codes.includes(notFinite)) return "Removed: a corner is not a finite point of clip space.";
    const plane = planes.findIndex((_, i) => (common >> i) & 1);
    const nearest = Math.max(...chain.corners.map(({clip}) => signedDistance(planes[plane], clip)));
    return `Removed: all corners lie outside the ${planes[plane].name} plane, the nearest by ${shortNumber(-nearest)} in clip space.`;
  }
  if (m & marks.clippedAway) return "Removed: clipping left no part of it.";
  const parts = [];
  if (m & marks.cut) parts.push(`Clipping made it a polygon of ${chain.polygon.length} vertices.`);
  if (m & marks.zeroArea) parts.push(m & (marks.setUp | marks.culled) ? "A piece of it has no area on the screen." :
    "Removed: it has no area on the screen after the snap.");
  if (m & marks.culled) {
    const area = Math.max(...chain.pieces.filter(({culled}) => culled).map(({setup}) => setup.doubleArea)) / 131072;
    parts.push(`Culled: it faces away, with ${shortNumber(area)} square pixels.`);
  }
  if (m & marks.setUp) parts.push(fateOfFragments(run, chain.number));
  return parts.join(" ");
}

function fateOfFragments(run, number) {
  const fate = run.columns["fragment.fate"], counts = [0, 0, 0, 0], [from, to] = fragmentsOfTriangle(run, number);
  for (let i = from; i < to; i++) counts[fate[i]]++;
  const total = counts.reduce((a, b) => a + b);
  if (!total) return run.facts.rectangle ? "It covers no pixel's centre in the recorded rectangle." :
    "It covers no pixel's centre.";
  return `${count(total, "fragment")}: ` +
    counts.map((each, k) => each && `${each.toLocaleString("en")} ${fates[k]}`).filter(Boolean).join(", ") + ".";
}

function firstFragmentOf(run, number) {
  const [from, to] = fragmentsOfTriangle(run, number);
  return from < to ? from : -1;
}
const shortNumber = (value) => String(Number(value.toPrecision(4))).replace("-", "−");

// Draws the run's geometry in one space in 3D, with the frustum or the unit cube. The chosen
// triangle and the axes are drawn over it (space_marks.js), so that another choice does not draw
// the geometry again.

const spaceCanvas = byId("space"), gl = spaceCanvas.getContext("webgl2", {antialias: true, preserveDrawingBuffer: true});
const turn = {yaw: 0.6, pitch: 0.35, zoom: 1, pivot: [0, 0, 0]}; // the pivot in the shader's coordinates, where 0 is the middle

const lit = {not: 0, asSeen: 1, asShaped: 2};
const vertexShader = `#version 300 es
in vec3 position;
in vec3 shape; // in eye space
uniform int lit;
uniform mat3 turned; // to x right, y up, z away
uniform vec3 pivot;
uniform vec2 scale;
out vec3 place, form;
void main() {
  place = position;
  vec3 at = turned * (position - pivot);
  form = lit == ${lit.asShaped} ? shape : at;
  gl_Position = vec4(at.xy * scale, at.z * 0.4, 1.0 + 0.25 * at.z);
}`;
const fragmentShader = `#version 300 es
precision highp float;
precision highp int;
in vec3 place, form;
uniform vec3 reach; // what lies farther out is left away
uniform vec4 colour;
uniform int lit;
out vec4 pixel;
void main() {
  if (any(greaterThan(abs(place), reach))) discard;
  vec3 n = normalize(cross(dFdx(form), dFdy(form)));
  if (dot(n, form) > 0.0) n = -n; // towards the camera, in eye space
  float light = lit == ${lit.not} ? 1.0 : lit == ${lit.asSeen} ? 0.35 + 0.65 * abs(n.z) : 0.65 + 0.35 * dot(n, vec3(0.45, 0.72, 0.53));
  pixel = vec4(colour.rgb * light, colour.a);
}`;

let program = null;
function startWebGl() {
  if (!gl) return false;
  const compile = (type, source) => {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    return shader;
  };
  program = gl.createProgram();
  gl.attachShader(program, compile(gl.VERTEX_SHADER, vertexShader));
  gl.attachShader(program, compile(gl.FRAGMENT_SHADER, fragmentShader));
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return false;
  gl.useProgram(program);
  gl.enable(gl.DEPTH_TEST);
  gl.depthFunc(gl.LEQUAL);
  gl.polygonOffset(1, 1);
  gl.enable(gl.BLEND);
  gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA); // the canvas stays opaque
  return true;
}
const hasWebGl = startWebGl();

// ---- the spaces ----

// The position of a corner in each space; null if it has none there. In screen space depth is
// scaled, so that its range is as long as the picture's shorter side. The division by w leaves
// little depth, so the divided spaces are lit by the shape that faces had before it.
const spaces = {
  object: {name: "Object", place: (corner) => corner.object, frame: () => []},
  world: {name: "World", place: (corner) => corner.world, camera: (run) => run.facts.camera.eye, frame: (run) => frustumLines(run).map(worldFromEye(run))},
  eye: {name: "Eye", place: (corner) => corner.eye, camera: () => [0, 0, 0], frame: frustumLines},
  clip: {name: "Clip (x, y, w)", place: ({clip: [x, y, , w]}) => [x, y, w], frame: clipLines, fixed: true, mirrored: true,
    axes: ["x", "y", "w"]},
  ndc: {name: "NDC", place: ({clip}) => (clip[3] > 0 ? clip.slice(0, 3).map((value) => value / clip[3]) : null),
    frame: () => boxLines([-1, -1, 0], [1, 1, 1]), fixed: true, flip: true, divided: true},
  screen: {name: "Screen", place: ({clip}, run) => (clip[3] > 0 ? screenPlace(divide(clip), run) : null),
    frame: (run) => boxLines([0, 0, 0], [run.width, run.height, screenDepth(run)]), fixed: true, flip: true, down: true, divided: true},
};
const screenDepth = (run) => Math.min(run.width, run.height); // the length in pixels that the depth range 0 .. 1 is drawn with
function screenPlace(ndc, run) {
  const [x, y, z] = toScreen(ndc, run.facts.view.viewport).position;
  return [x, y, z * screenDepth(run)];
}

// The twelve edges of a box, as pairs of points. `place` gives the position of each corner.
function edgesOf(place) {
  const points = [];
  for (let i = 0; i < 8; i++) {
    for (const bit of [1, 2, 4]) if (!(i & bit)) points.push(place(i), place(i | bit));
  }
  return points;
}
const boxLines = (low, high) => edgesOf((i) => [0, 1, 2].map((k) => (i & (1 << k) ? high[k] : low[k])));

// The distance up to which the frustum is drawn: its far plane, or a little beyond the farthest
// geometry.
function farOf(run) {
  const {near, far} = run.facts.view;
  if (run.reachesTo === undefined) {
    run.reachesTo = near;
    for (const draw of run.facts.draws) {
      for (let i = 0; i < run.facts.meshes[draw.mesh].positions; i++) {
        run.reachesTo = Math.max(run.reachesTo, -new Corner(run, draw, i).eye[2]);
      }
    }
  }
  return Math.min(far === "inf" ? Infinity : far, near + 1.2 * (run.reachesTo - near) + 0.1 * Math.abs(near));
}
// Computes x and y at a distance along the gaze from NDC. The projection has no shear except that
// of an off-centre window.
function frustumLines(run) {
  const {clip_from_eye: m, near, perspective} = run.facts.view;
  return edgesOf((i) => {
    const distance = i & 4 ? farOf(run) : near, w = perspective ? distance : 1;
    const x = (i & 1 ? 1 : -1) * w, y = (i & 2 ? 1 : -1) * w;
    return [(x + m[2] * distance - m[3]) / m[0], (y + m[6] * distance - m[7]) / m[5], -distance];
  });
}
function worldFromEye(run) {
  const m = run.facts.camera.world_from_eye;
  return (p) => affineDouble(m, p);
}
// The volume |x| <= w, |y| <= w between the planes, which is a pyramid.
function clipLines(run) {
  const {near, perspective} = run.facts.view;
  if (!perspective) return boxLines([-1, -1, 1], [1, 1, 1]);
  return edgesOf((i) => {
    const w = i & 4 ? farOf(run) : near;
    return [(i & 1 ? 1 : -1) * w, (i & 2 ? 1 : -1) * w, w];
  });
}

// ---- what is drawn ----

// A corner's positions without their bounds. Each is computed when it is needed.
class Corner {
  constructor(run, draw, index) {
    Object.assign(this, {run, draw});
    this.object = positionOf(run, draw, index).object;
  }
  get world() { return affineDouble(this.draw.world_from_object, this.object); }
  get eye() { return affineDouble(this.run.facts.view.eye_from_world, this.world); }
  get clip() { return clipFrom(this.draw.clip_from_anchored, anchoredFrom(this.draw, this.object)); }
}

const chosenDrawOf = (run) => {
  const row = run.rowOf.get(state.triangle ?? -1);
  return row === undefined ? run.facts.draws[0] : drawOfRow(run, row);
};

// The geometry in a space. In object space it is that of the chosen triangle's draw; only the last
// one is kept.
function meshIn(run, name) {
  run.spaces ??= {};
  const draw = name === "object" ? chosenDrawOf(run) : null, kept = run.spaces[name];
  if (kept && kept.draw === draw) return kept;
  if (kept) {
    releaseMesh(kept);
    lookAtAll();
  }
  return (run.spaces[name] = {draw, ...makeMesh(run, spaces[name], draw ? [draw] : run.facts.draws)});
}

// The positions of all corners, and the indices of each triangle's corners. `triangles` first has
// those that are visible from both sides, then, from `oneSided` on, those that are
// counter-clockwise on their visible side. Lines have two points each. In divided spaces `shapes`
// has the corners' positions in eye space.
function makeMesh(run, space, draws) {
  const places = [], shapes = [], bothSides = [], oneSide = [], c = run.columns, numbers = c["triangle.number"];
  const add = (vertex, eye) => {
    if (space.divided) shapes.push(...eye());
    return places.push(...(space.place(vertex, run) ?? [NaN, NaN, NaN])) / 3 - 1;
  };
  for (const draw of draws) {
    const first = places.length / 3, {positions} = run.facts.meshes[draw.mesh];
    const [front, back] = [true, false].map((side) => !isCulled(run.facts, draw, side));
    const triangles = front && back ? bothSides : oneSide, turned = back !== (draw.mirrored && space !== spaces.object);
    const made = Array.from({length: positions}, (_, i) => new Corner(run, draw, i));
    for (const corner of made) add(corner, () => corner.eye);
    for (let row = draw.firstRow; row < draw.firstRow + draw.triangles; row++) {
      const cut = space.divided ? run.cut.get(numbers[row]) : undefined, three = corners.map((corner) => c[`triangle.${corner}`][row]);
      const polygon = cut ? cut.map((vertex) => add(vertex, () => weighted(vertex.weights, three.map((i) => made[i].eye)))) : three.map((i) => first + i);
      if (polygon.some((at) => Number.isNaN(places[3 * at]))) continue; // behind the eye
      for (let k = 2; k < polygon.length; k++) triangles.push(polygon[0], polygon[turned ? k : k - 1], polygon[turned ? k - 1 : k]);
    }
  }
  const frame = space.frame(run).flat(), triangles = bothSides.concat(oneSide);
  return {places, shapes, triangles, oneSided: bothSides.length, frame, ...centreOf(space.fixed || !triangles.length ? frame : places)};
}

const weighted = (weights, places) => [0, 1, 2].map((k) => places.reduce((sum, place, i) => sum + weights[i] * place[k], 0));

function centreOf(places) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < places.length; i++) {
    if (places[i] < low[i % 3]) low[i % 3] = places[i];
    if (places[i] > high[i % 3]) high[i % 3] = places[i];
  }
  const size = Math.max(...[0, 1, 2].map((k) => high[k] - low[k]), 1e-30);
  return {low, high, size, centre: low.map((value, k) => (value + high[k]) / 2), scale: 1.25 / size};
}

function bufferOf(places, {centre, scale} = {centre: [0, 0, 0], scale: 1}) {
  const numbers = Float32Array.from(places, (value, i) => (value - centre[i % 3]) * scale), buffer = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
  return buffer;
}
function indexBufferOf(indexes) {
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, Uint32Array.from(indexes), gl.STATIC_DRAW);
  return buffer;
}

function edgesOfTriangles(triangles) {
  const edges = [];
  for (let i = 0; i < triangles.length; i += 3) {
    edges.push(triangles[i], triangles[i + 1], triangles[i + 1], triangles[i + 2], triangles[i + 2], triangles[i]);
  }
  return edges;
}

function releaseMesh({buffers}) {
  for (const buffer of Object.values(buffers ?? {})) gl.deleteBuffer(buffer);
}

// A matrix column by column, as WebGL needs it. It first maps to x right, y up, z away (in NDC and
// screen space z points into the picture, in screen space y points down), then turns by yaw about y
// and by pitch about x.
function turnMatrix({flip, down}) {
  const [cy, sy, cp, sp] = [Math.cos(turn.yaw), Math.sin(turn.yaw), Math.cos(turn.pitch), Math.sin(turn.pitch)];
  const y = down ? -1 : 1, z = flip ? 1 : -1;
  return new Float32Array([cy, -sy * sp, -sy * cp, 0, y * cp, -y * sp, z * sy, z * cy * sp, z * cy * cp]);
}
function turnScale() {
  const aspect = spaceCanvas.width / spaceCanvas.height;
  return [turn.zoom / Math.max(aspect, 1), turn.zoom * Math.min(aspect, 1)];
}

// Draws buffers: `places`, and for faces lit by their shape `shapes`, at the indices if there are
// any.
function drawThings({places, shapes, indexes}, mode, colour, light, from, count) {
  for (const [name, buffer] of [["position", places], ["shape", shapes]]) {
    const attribute = gl.getAttribLocation(program, name);
    if (!buffer) {
      gl.disableVertexAttribArray(attribute);
      continue;
    }
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(attribute);
    gl.vertexAttribPointer(attribute, 3, gl.FLOAT, false, 0, 0);
  }
  gl.uniform4fv(gl.getUniformLocation(program, "colour"), colour);
  gl.uniform1i(gl.getUniformLocation(program, "lit"), light);
  if (!indexes) {
    gl.drawArrays(mode, from, count);
    return;
  }
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indexes);
  gl.drawElements(mode, count, gl.UNSIGNED_INT, 4 * from);
}

const packedColour = (text) => {
  const digits = text.trim().replace("#", ""), all = digits.length === 3 ? [...digits].map((d) => d + d).join("") : digits;
  return [0, 2, 4].map((at) => parseInt(all.slice(at, at + 2), 16));
};

// How far from the middle something is drawn, in the shader's coordinates: `inside` up to the unit
// cube or the picture, `around` a little farther.
function reachesOf({divided}, {low, high, scale}) {
  const all = [1e30, 1e30, 1e30];
  return divided ? {inside: high.map((value, k) => (value - low[k]) * scale * 0.5001), around: [1, 1, 1]} : {inside: all, around: all};
}

function drawGeometry(space, mesh, edgesOnly) {
  const buffers = (mesh.buffers ??= {places: bufferOf(mesh.places, mesh), lines: bufferOf(mesh.frame, mesh),
    ...(space.divided ? {shapes: bufferOf(mesh.shapes)} : {})});
  const {inside, around} = reachesOf(space, mesh), reach = (far) => gl.uniform3fv(gl.getUniformLocation(program, "reach"), far);
  const colour = (name, opacity = 1) => [...packedColour(colourVariable(name)).map((byte) => byte / 255), opacity];
  gl.viewport(0, 0, spaceCanvas.width, spaceCanvas.height);
  gl.clearColor(...colour("--stage"));
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  gl.uniformMatrix3fv(gl.getUniformLocation(program, "turned"), false, turnMatrix(space));
  gl.uniform3fv(gl.getUniformLocation(program, "pivot"), turn.pivot);
  gl.uniform2fv(gl.getUniformLocation(program, "scale"), turnScale());
  reach(inside);
  if (!edgesOnly) {
    buffers.triangles ??= indexBufferOf(mesh.triangles);
    drawFaces({...buffers, indexes: buffers.triangles}, space, mesh, colour("--mesh"));
  }
  buffers.edges ??= indexBufferOf(edgesOfTriangles(mesh.triangles));
  const edges = (ink) => drawThings({places: buffers.places, indexes: buffers.edges}, gl.LINES, ink, lit.not, 0, 2 * mesh.triangles.length);
  const opacity = edgesOnly ? 1 : edgeOpacity(mesh);
  edges(colour(edgesOnly ? "--mesh" : "--text", opacity));
  reach(around);
  if (space.divided) edges(colour("--text", 0.3 * opacity)); // what the picture does not have
  const frame = (shade) => drawThings({places: buffers.lines}, gl.LINES, colour("--other", shade), lit.not, 0, mesh.frame.length / 3);
  frame(1);
  gl.disable(gl.DEPTH_TEST); // the frustum shows through walls
  frame(0.5);
  gl.enable(gl.DEPTH_TEST);
}

function drawFaces(buffers, space, mesh, colour) {
  const draw = (from, to) => drawThings(buffers, gl.TRIANGLES, colour, space.divided ? lit.asShaped : lit.asSeen, from, to - from);
  gl.enable(gl.POLYGON_OFFSET_FILL); // behind their edges
  draw(0, mesh.oneSided);
  gl.enable(gl.CULL_FACE); // culls as the run does, but from this viewpoint, so that one can look into rooms
  gl.frontFace(space.mirrored ? gl.CW : gl.CCW);
  draw(mesh.oneSided, mesh.triangles.length);
  gl.disable(gl.CULL_FACE);
  gl.disable(gl.POLYGON_OFFSET_FILL);
}

// The edges of many triangles are fainter, so that they do not cover the faces.
const edgeOpacity = ({triangles}) => clamp(2000 / triangles.length, 0.04, 0.4);

let lastLook = "";  // describes how the geometry was drawn last
let lastMesh = null;
function drawSpace() {
  if (!hasWebGl || byId("space-panel").hidden) return;
  const run = state.runs[0], space = spaces[state.space], mesh = meshIn(run, state.space), edgesOnly = byId("edges-only").checked;
  const look = [turn.yaw, turn.pitch, turn.zoom, ...turn.pivot, spaceCanvas.width, spaceCanvas.height, edgesOnly, colourVariable("--mesh")].join();
  if (mesh !== lastMesh || look !== lastLook) drawGeometry(space, mesh, edgesOnly);
  [lastMesh, lastLook] = [mesh, look];
  drawMarks(run, space, mesh);
}

// Sets the canvas to its size on the page in device pixels, which clears it.
function sizeSpace() {
  const box = spaceCanvas.getBoundingClientRect();
  for (const canvas of [spaceCanvas, marksCanvas]) {
    canvas.width = Math.max(1, Math.round(box.width * devicePixelRatio));
    canvas.height = Math.max(1, Math.round(box.height * devicePixelRatio));
  }
  lastMesh = null;
  drawSpace();
}

// ---- turning ----

// Moves the chosen triangle to the middle, large enough to see its shape. Holds for this space
// until the view is changed.
function goToTriangle() {
  const run = state.runs[0], space = spaces[state.space], chain = state.triangle === null ? null : cachedChain(run, state.triangle);
  const three = chain?.corners.map((corner) => space.place(corner, run)).filter(Boolean) ?? [];
  if (!three.length) return say("No triangle is chosen that lies in this space.");
  const {centre, size} = centreOf(three.flat()), mesh = meshIn(run, state.space);
  turn.pivot = centre.map((value, k) => (value - mesh.centre[k]) * mesh.scale);
  turn.zoom = clamp(0.4 / (size * mesh.scale), 1, largestZoom);
  drawSpace();
}
const lookAtAll = () => Object.assign(turn, {zoom: 1, pivot: [0, 0, 0]});
// Shows all of another space (its triangles are elsewhere). The divided spaces open as the picture
// is seen, turned a little; between spaces of one kind the turn stays.
function enterSpace(from, to) {
  lookAtAll();
  if (Boolean(from.divided) !== Boolean(to.divided)) Object.assign(turn, to.divided ? {yaw: 0.3, pitch: 0.2} : {yaw: 0.6, pitch: 0.35});
}
function seeAll() {
  lookAtAll();
  drawSpace();
}

function turnBy(yaw, pitch) {
  turn.yaw += yaw;
  turn.pitch = clamp(turn.pitch + pitch, -Math.PI / 2, Math.PI / 2);
  drawSpace();
}
const largestZoom = 1000;
function zoomSpace(factor) {
  turn.zoom = clamp(turn.zoom * factor, 0.2, largestZoom);
  drawSpace();
}

function listenToSpace() {
  byId("no-webgl").hidden = hasWebGl;
  spaceCanvas.hidden = !hasWebGl;
  for (const [name, {name: label}] of Object.entries(spaces)) {
    byId("space-name").append(element("option", {value: name, textContent: label}));
  }
  byId("edges-only").addEventListener("change", drawSpace);
  byId("space-name").addEventListener("change", ({target}) => change({space: target.value}));
  byId("to-triangle").addEventListener("click", goToTriangle);
  byId("to-all").addEventListener("click", seeAll);
  let held = null;
  spaceCanvas.addEventListener("pointerdown", (event) => {
    held = [event.clientX, event.clientY];
    spaceCanvas.setPointerCapture(event.pointerId);
  });
  spaceCanvas.addEventListener("pointermove", (event) => {
    if (!held) return;
    turnBy((event.clientX - held[0]) * 0.01, (event.clientY - held[1]) * 0.01);
    held = [event.clientX, event.clientY];
  });
  for (const end of ["pointerup", "pointercancel"]) spaceCanvas.addEventListener(end, () => { held = null; });
  spaceCanvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoomSpace(event.deltaY < 0 ? 1.15 : 1 / 1.15);
  }, {passive: false});
  spaceCanvas.addEventListener("keydown", (event) => {
    const keys = {ArrowLeft: () => turnBy(-0.1, 0), ArrowRight: () => turnBy(0.1, 0), ArrowUp: () => turnBy(0, -0.1),
      ArrowDown: () => turnBy(0, 0.1), "+": () => zoomSpace(1.15), "-": () => zoomSpace(1 / 1.15), 0: seeAll,
      Enter: goToTriangle};
    if (event.ctrlKey || event.altKey || event.metaKey || !keys[event.key]) return;
    event.preventDefault();
    event.stopPropagation();
    keys[event.key]();
  });
}

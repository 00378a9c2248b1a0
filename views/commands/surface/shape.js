// Draws the surface from any side: rasterizes triangles with a depth and a polygon number for each
// pixel, then computes the colours.

let places = new Float32Array(0), colors = new Uint8Array(0), views = new Uint8Array(0), seen = new Uint8Array(0);
let middle = [0, 0, 0], radius = 1, pictures = [], idAt = new Int32Array(0), picked = -1;

const polygonCount = () => places.length / 9;
const sees = (view, polygon) => { const bit = view * polygonCount() + polygon; return (seen[bit >> 3] >> (bit & 7) & 1) === 1; };
const shade = () => document.querySelector("#shades :checked").value;

function measure() {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < places.length; i++) {
    low[i % 3] = Math.min(low[i % 3], places[i]);
    high[i % 3] = Math.max(high[i % 3], places[i]);
  }
  middle = textures ? textures.middle : low.map((x, k) => (x + high[k]) / 2);
  radius = Math.hypot(...low.map((x, k) => high[k] - x)) / 2;
}

// Colours from blue (few pictures) to yellow (many).
const mostViews = () => Math.max(1, views.reduce((a, b) => Math.max(a, b), 0));
const viewsColour = (count, most) => { const share = count / most; return [40 + 210 * share, 80 + 140 * share, 200 - 150 * share]; };

// The eye's position, and its axes as rows: to the right, up, towards it.
function camera() {
  const rows = turnedWorld(), away = 2.6 * radius / turn.nearer;
  return {rows, eye: middle.map((x, k) => x + away * rows[2][k])};
}

// The colour of a world point in a picture, interpolated bilinearly without the background's
// pixels.
function sampled(picture, p) {
  const m = picture.matrix, w = m[8] * p[0] + m[9] * p[1] + m[10] * p[2] + m[11];
  const x = (m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3]) / w - .5, y = (m[4] * p[0] + m[5] * p[1] + m[6] * p[2] + m[7]) / w - .5;
  if (!(w > 0) || !(x >= -.5 && y >= -.5 && x <= picture.width - .5 && y <= picture.height - .5)) return null;
  const left = Math.floor(x), top = Math.floor(y), sum = [0, 0, 0];
  let all = 0;
  for (let k = 0; k < 4; k++) {
    const weight = (k & 1 ? x - left : 1 - x + left) * (k >> 1 ? y - top : 1 - y + top);
    const at = 4 * (clamp(top + (k >> 1), 0, picture.height - 1) * picture.width + clamp(left + (k & 1), 0, picture.width - 1));
    if (picture.data[at + 3] === 0) continue;
    for (let c = 0; c < 3; c++) sum[c] += weight * picture.data[at + c];
    all += weight;
  }
  return all > 1e-6 ? sum.map((x) => x / all) : null;
}

function drawShape() {
  const isTextured = shade() === "textured", ratio = Math.min(devicePixelRatio, isTextured ? 1 : 2);
  const width = Math.max(1, Math.round(shape.clientWidth * ratio)), height = Math.max(1, Math.round(width * 3 / 4));
  shape.width = width;
  shape.height = height;
  const {rows, eye} = camera(), focal = 1.5 * Math.min(width, height);
  const depth = new Float32Array(width * height).fill(0);
  idAt = new Int32Array(width * height).fill(-1);
  const px = new Float64Array(3), py = new Float64Array(3), near = new Float64Array(3);
  for (let i = 0; i < polygonCount(); i++) {
    let isBefore = true;
    for (let k = 0; k < 3; k++) {
      const at = 9 * i + 3 * k, x = places[at] - eye[0], y = places[at + 1] - eye[1], z = places[at + 2] - eye[2];
      const along = (row) => row[0] * x + row[1] * y + row[2] * z, away = -along(rows[2]);
      isBefore = isBefore && away > radius / 1000;
      near[k] = 1 / away;
      px[k] = width / 2 + focal * along(rows[0]) / away;
      py[k] = height / 2 - focal * along(rows[1]) / away;
    }
    const area = (px[1] - px[0]) * (py[2] - py[0]) - (px[2] - px[0]) * (py[1] - py[0]);
    if (!isBefore || !(area < 0)) continue; // turned away
    const top = Math.max(0, Math.ceil(Math.min(py[0], py[1], py[2]) - .5)), bottom = Math.min(height - 1, Math.floor(Math.max(py[0], py[1], py[2]) - .5));
    const left = Math.max(0, Math.ceil(Math.min(px[0], px[1], px[2]) - .5)), right = Math.min(width - 1, Math.floor(Math.max(px[0], px[1], px[2]) - .5));
    for (let y = top; y <= bottom; y++) {
      for (let x = left; x <= right; x++) {
        const cx = x + .5, cy = y + .5;
        const a = ((px[1] - cx) * (py[2] - cy) - (px[2] - cx) * (py[1] - cy)) / area, b = ((px[2] - cx) * (py[0] - cy) - (px[0] - cx) * (py[2] - cy)) / area, c = 1 - a - b;
        if (a < 0 || b < 0 || c < 0) continue;
        const nearness = a * near[0] + b * near[1] + c * near[2], at = y * width + x;
        if (nearness <= depth[at]) continue;
        depth[at] = nearness;
        idAt[at] = i;
      }
    }
  }
  colour({width, height, depth, rows, eye, focal});
}

// A colour for each number, so that neighbours differ.
function numberColour(i) {
  const hash = Math.imul(i + 1, 0x9e3779b1) >>> 0;
  return [80 + (hash & 127), 80 + (hash >> 8 & 127), 80 + (hash >> 16 & 127)];
}

function colour({width, height, depth, rows, eye, focal}) {
  const picture = shapeContext.createImageData(width, height), kind = shade(), most = mostViews();
  const direction = rows[2], around = textures ? weightsAround(direction) : [];
  const weights = new Map();
  for (let at = 0; at < idAt.length; at++) {
    const id = idAt[at];
    if (id < 0) continue;
    let c = [colors[3 * id], colors[3 * id + 1], colors[3 * id + 2]];
    if (kind === "views") c = viewsColour(views[id], most);
    if (kind === "polygons") c = numberColour(id);
    if (kind === "textured") {
      if (!weights.has(id)) weights.set(id, weightsOf(around, direction, id));
      const x = (at % width + .5 - width / 2) / focal / depth[at], y = (height / 2 - Math.floor(at / width) - .5) / focal / depth[at], z = -1 / depth[at];
      const p = eye.map((e, k) => e + x * rows[0][k] + y * rows[1][k] + z * rows[2][k]), sum = [0, 0, 0];
      let all = 0;
      for (const {view, weight} of weights.get(id)) {
        const found = sampled(pictures[view], p);
        if (!found) continue;
        for (let k = 0; k < 3; k++) sum[k] += weight * found[k];
        all += weight;
      }
      if (all > 0) c = sum.map((s) => s / all);
    }
    if (id === picked) c = [255, 220, 40];
    picture.data.set([c[0], c[1], c[2], 255], 4 * at);
  }
  shapeContext.putImageData(picture, 0, 0);
  if (textures) showWeights(direction);
}

function explain(polygon) {
  picked = polygon;
  const corner = (k) => `(${[0, 1, 2].map((axis) => places[9 * polygon + 3 * k + axis].toFixed(3)).join(", ")})`;
  let text = `Polygon ${polygon}: ${count(views[polygon], "picture")} ${views[polygon] === 1 ? "sees" : "see"} it. Corners ${[0, 1, 2].map(corner).join(", ")}.`;
  if (textures) {
    const direction = camera().rows[2], weights = weightsOf(weightsAround(direction), direction, polygon);
    text += weights.length === 0 ? " It has the mesh's own colour." : ` From here: ${weights.map(({view, weight}) => `${textures.views[view].name} ${weight.toFixed(2)}`).join(", ")}.`;
  }
  byId("readout").textContent = text;
  redrawShape();
}

let redrawShape = () => {};
function setUpShape() {
  redrawShape = setUpTurning({draw: drawShape, mostNear: 3, pickAt: (at) => { if (idAt[at] >= 0) explain(idAt[at]); }});
  byId("shades").addEventListener("change", redrawShape);
}

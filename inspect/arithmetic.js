// Repeats the stages' arithmetic operation by operation, so that every number is the run's to the
// bit.
//
// Math.fround after each operation on floats gives the result of a float operation: the product of
// two floats is exact in a double, and for +, - and / the double's 53 bits are enough for two
// roundings to give the correctly rounded result (2 * 24 + 2 <= 53). After the snap all numbers are
// integers below 2^53, which doubles represent exactly. Matrices are arrays of 16 numbers, row by
// row.

const f32 = Math.fround;

const bitStore = new DataView(new ArrayBuffer(8));
function bitsOfFloat(value) {
  bitStore.setFloat32(0, value);
  return bitStore.getUint32(0);
}

// As transform_row of the pipeline, in float and in double.
function transformRow(m, row, [x, y, z]) {
  const at = 4 * row;
  return f32(f32(f32(f32(m[at] * x) + f32(m[at + 1] * y)) + f32(m[at + 2] * z)) + m[at + 3]);
}
function transformRowDouble(m, row, [x, y, z]) {
  const at = 4 * row;
  return m[at] * x + m[at + 1] * y + m[at + 2] * z + m[at + 3];
}
const clipFrom = (m, p) => [0, 1, 2, 3].map((row) => transformRow(m, row, p));
const affineDouble = (m, p) => [0, 1, 2].map((row) => transformRowDouble(m, row, p));

// As in clip.h: a x + b y + c z + d w + e. The planes of a run have at most two terms, each exact
// in a double, so the sign is exact.
function signedDistance({factors: [a, b, c, d, e]}, [x, y, z, w]) {
  return a * x + b * y + c * z + d * w + e;
}
const notFinite = 0xffffffff;
function outcodeOf(clip, planes) {
  if (!clip.every(Number.isFinite)) return notFinite;
  return planes.reduce((code, plane, i) => (signedDistance(plane, clip) < 0 ? code | (1 << i) : code), 0);
}

// divide.h
function divide([x, y, z, w]) {
  if (w === 1) return {position: [x, y, z], inverseW: 1};
  return {position: [f32(x / w), f32(y / w), f32(z / w)], inverseW: f32(1 / w)};
}

// viewport.h
function toScreen({position: [x, y, z], inverseW}, [left, top, right, bottom]) {
  const scale = (from, to) => f32(f32(to - from) * 0.5), centre = (from, to) => f32(f32(to + from) * 0.5);
  return {
    position: [f32(f32(x * scale(left, right)) + centre(left, right)),
      f32(f32(y * scale(bottom, top)) + centre(bottom, top)), z],
    inverseW,
  };
}

// As in snap.h: rounds to 1/256 pixel, halves up.
function snap(pixels) {
  const subpixels = f32(pixels * 256), below = Math.floor(subpixels);
  return below + (subpixels - below >= 0.5 ? 1 : 0);
}
const snapVertex = ({position: [x, y]}) => [snap(x), snap(y)];

// fan.h
const doubleArea = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
function fanApex(polygon) {
  const vertex = (i) => polygon[i % polygon.length];
  for (let apex = 0; apex < polygon.length; apex++) {
    let clockwise = false, counterClockwise = false;
    for (let i = 1; i + 1 < polygon.length; i++) {
      const area = doubleArea(vertex(apex), vertex(apex + i), vertex(apex + i + 1));
      clockwise ||= area > 0;
      counterClockwise ||= area < 0;
    }
    if (!(clockwise && counterClockwise)) return apex;
  }
  return 0;
}

// As in triangle_setup.cpp: the edge function of the edge from `from` to `to`; null for a triangle
// without area.
function edgeFunction(from, to) {
  const a = from[1] - to[1], b = to[0] - from[0];
  return {a, b, c: -(a * from[0] + b * from[1]) + 0, ownsZero: (a === 0 && b > 0) || a > 0};
}
const firstPixel = (low) => (low + 127) >> 8;
const endPixel = (high) => ((high - 128) >> 8) + 1;

function setUpTriangle(vertices, snapped = vertices.map(snapVertex)) {
  const area = doubleArea(...snapped);
  if (area === 0) return null;
  const clockwise = area > 0;
  let order = clockwise ? [0, 1, 2] : [0, 2, 1];
  const depthOf = (k) => vertices[order[k]].position[2];
  let nearest = 0;
  for (let k = 1; k < 3; k++) if (depthOf(k) < depthOf(nearest)) nearest = k;
  order = [0, 1, 2].map((k) => order[(k + nearest) % 3]);
  const inverseW = order.map((k) => vertices[k].inverseW);
  const xs = snapped.map(([x]) => x), ys = snapped.map(([, y]) => y), size = Math.abs(area);
  return {
    clockwise, order, doubleArea: size,
    edges: [0, 1, 2].map((k) => edgeFunction(snapped[order[(k + 1) % 3]], snapped[order[(k + 2) % 3]])),
    depth: order.map((k) => vertices[k].position[2]),
    inverseW,
    affine: inverseW[0] === inverseW[1] && inverseW[1] === inverseW[2],
    inverseArea: f32(1 / f32(size)),
    bounds: [firstPixel(Math.min(...xs)), firstPixel(Math.min(...ys)), endPixel(Math.max(...xs)), endPixel(Math.max(...ys))],
  };
}

const edgeAt = ({a, b, c}, x, y) => a * (256 * x + 128) + b * (256 * y + 128) + c;
const covers = ({ownsZero}, value) => value > 0 || (value === 0 && ownsZero);

// interpolate.h
function interpolateDepth(setup, lambda1, lambda2) {
  const [d0, d1, d2] = setup.depth;
  return f32(d0 + f32(f32(lambda1 * f32(d1 - d0)) + f32(lambda2 * f32(d2 - d0))));
}
function interpolateFragment(setup, edges) {
  const lambda = edges.map((edge) => f32(f32(edge) * setup.inverseArea));
  const fragment = {lambda, depth: interpolateDepth(setup, lambda[1], lambda[2])};
  if (setup.affine) return {...fragment, inverseW: setup.inverseW[0], weights: lambda};
  const share = lambda.map((each, k) => f32(each * setup.inverseW[k]));
  const inverseW = f32(f32(share[0] + share[1]) + share[2]), w = f32(1 / inverseW);
  return {...fragment, inverseW, weights: share.map((each) => f32(each * w))};
}

// depth.h
const emptyDepth = 0xffffffff;
function depthCode(format, depth) {
  const z = depth > 0 ? (depth < 1 ? depth : 1) : 0;
  if (format === "d32") return bitsOfFloat(z);
  if (format === "d32r") return bitsOfFloat(1) - bitsOfFloat(z);
  return Math.floor(z * (format === "d24" ? 2 ** 24 - 1 : 2 ** 16 - 1) + 0.5);
}

// Running error bounds (SPEC C, generic bounds 1 to 5), computed as in pipeline/bounds.cpp and
// raster/bounds.cpp. Each is absolute, in the unit of its number.

const unitFloat = 2 ** -24, unitDouble = 2 ** -53, halfSubnormal = 2 ** -150, roundUp = 1 + 2 ** -40;
const gammaOf = (unit, k) => (k * unit) / (1 - k * unit);
const timesOrZero = (a, b) => (a === 0 || b === 0 ? 0 : a * b);

// One entry of |M||x|, for a row of M.
function magnitudeOfRow(m, row, x) {
  let sum = 0;
  for (let k = 0; k < 4; k++) sum += Math.abs(timesOrZero(m[4 * row + k], x[k]));
  return sum * roundUp;
}

// The bound for matrices with the last row 0 0 0 1, in double. A row with a single product by a
// power of two has no rounding error.
function affineBound(m, point, pointBound) {
  const x = [...point, 1];
  return [0, 1, 2].map((row) => {
    const factors = [0, 1, 2, 3].filter((k) => m[4 * row + k] !== 0 && x[k] !== 0).map((k) => m[4 * row + k]);
    const exact = !factors.length || (factors.length === 1 && isPowerOfTwo(factors[0]));
    return ((exact ? 0 : gammaOf(unitDouble, factors.length) * magnitudeOfRow(m, row, x)) +
      magnitudeOfRow(m, row, [...pointBound, 0])) * roundUp;
  });
}
function isPowerOfTwo(value) {
  bitStore.setFloat64(0, value);
  return (bitStore.getUint32(0) & 0xfffff) === 0 && bitStore.getUint32(4) === 0;
}

function transformBound(m, x, xBound, mBound) {
  return [0, 1, 2, 3].map((row) => {
    let products = 0, last = 0, size = 0, inherited = 0;
    for (let k = 0; k < 4; k++) {
      const entry = Math.abs(m[4 * row + k]), coordinate = Math.abs(x[k]);
      if (entry !== 0 && coordinate !== 0) {
        products++;
        last = k;
        size += entry * coordinate;
      }
      inherited += timesOrZero(entry, xBound[k]);
      inherited += timesOrZero(mBound[4 * row + k], coordinate + xBound[k]);
    }
    const product = m[4 * row + last] * x[last];
    const own = products === 1 ? Math.abs(product - f32(product)) :
      gammaOf(unitFloat, products) * size + products * halfSubnormal;
    return (own + inherited) * roundUp;
  });
}

function divideBound(clip, clipBound) {
  const w = Math.abs(clip[3]), smallest = w - clipBound[3];
  if (!(smallest > 0)) return {position: [Infinity, Infinity, Infinity], inverseW: Infinity};
  const rounding = clip[3] === 1 ? 0 : unitFloat, underflow = clip[3] === 1 ? 0 : halfSubnormal;
  const bound = (coordinate, coordinateBound) => {
    const quotient = Math.abs(coordinate) / w;
    return ((coordinateBound + timesOrZero(quotient, clipBound[3])) / smallest + rounding * quotient + underflow) * roundUp;
  };
  return {position: [0, 1, 2].map((k) => bound(clip[k], clipBound[k])), inverseW: bound(1, 0)};
}

// The factors by which the divide magnifies a relative error of its input.
function divideCondition(clip, magnitude) {
  const w = Math.abs(clip[3]);
  if (!(w > 0)) return [Infinity, Infinity, Infinity];
  return [0, 1, 2].map((k) => (magnitude[k] + (Math.abs(clip[k]) / w) * magnitude[3]) / w);
}

function screenBound(ndc, ndcBound, [left, top, right, bottom]) {
  const bound = (coordinate, coordinateBound, from, to) => {
    const scale = f32(f32(to - from) * 0.5), centre = f32(f32(to + from) * 0.5);
    const scaleBound = Math.abs(scale - (to - from) / 2), centreBound = Math.abs(centre - (to + from) / 2);
    const x = Math.abs(coordinate);
    return (Math.abs(scale) * coordinateBound + timesOrZero(scaleBound, x + coordinateBound) + centreBound +
      2 * unitFloat * (Math.abs(scale) * x * (1 + unitFloat) + Math.abs(centre)) + halfSubnormal) * roundUp;
  };
  return [bound(ndc[0], ndcBound[0], left, right), bound(ndc[1], ndcBound[1], bottom, top), ndcBound[2]];
}

// The distance in pixels of a position from the nearest value at which the snap changes its result.
// If it is larger than the bound, the snapped result is certain.
function snapStability(pixels, bound) {
  const scaled = pixels * 256 + 0.5, below = Math.floor(scaled);
  const toBoundary = Math.min(scaled - below, below + 1 - scaled) / 256;
  return {toBoundary, stable: toBoundary > bound};
}

// Computes a fragment's bounds from those of depth and 1/w at the vertices, in the order of the
// setup.
function fragmentBounds(setup, fragment, vertices) {
  const round = 1 + 2 ** -18;
  const r = Math.max(...setup.inverseW.map((each, k) => vertices.inverseW[k] / Math.abs(each)));
  const share = r < 1 ? (2 * r) / (1 - r) : Infinity;
  const sum = (bounds) => bounds.reduce((total, each, k) => total + timesOrZero(Math.abs(fragment.lambda[k]), each), 0);
  return {
    lambda: fragment.lambda.map((each) => 4 * unitFloat * Math.abs(each) * round),
    weights: fragment.weights.map((each) =>
      ((setup.affine ? 4 : 10) * unitFloat * Math.abs(each) + timesOrZero(Math.abs(each), share)) * round),
    depth: (8 * unitFloat * Math.abs(fragment.depth) + sum(vertices.depth)) * round,
    inverseW: ((setup.affine ? 0 : 7 * unitFloat * Math.abs(fragment.inverseW)) + sum(vertices.inverseW)) * round,
  };
}

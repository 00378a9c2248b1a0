// The layers as typed arrays, and the warp (views/layers/draw_layers.cpp): it moves a sample to C2
// C1^-1 (x, y, z, 1), and of several samples in a pixel keeps the nearest. Matrices are 16 numbers,
// row by row.

const {width, height} = manifest;
const largestSplat = 64, nearestDepth = 1 + 2 ** -20;

async function readLayers() {
  const bytes = async (id) => (await inflate(bytesOfBase64(byId(id).textContent))).buffer;
  const counts = new Uint16Array(await bytes("counts")), first = new Uint32Array(counts.length + 1);
  for (let i = 0; i < counts.length; i++) first[i + 1] = first[i] + counts[i];
  const layers = {counts, first, depth: new Float32Array(await bytes("depths")), colour: new Uint32Array(await bytes("colours")),
    normal: new Int8Array(await bytes("normals"))};
  return Object.assign(layers, slopesOf(layers));
}

// The change of a sample's depth per pixel to the right and per pixel down: to the nearest depth in
// the neighbouring pixel, on the side where it changes less. If the normal is stored, the slopes
// are those of its plane: -p / r and -q / r for p x + q y + r z + s = 0 in the picture.
function slopesOf({first, depth, normal}) {
  const across = new Float32Array(depth.length), down = new Float32Array(depth.length);
  const gain = (from, x, y) => {
    let least = NaN;
    if (x < 0 || y < 0 || x >= width || y >= height) return least;
    const place = (height - 1 - y) * width + x;
    for (let i = first[place]; i < first[place + 1]; i++) {
      const step = Math.fround(depth[i] - from);
      if (Math.abs(step) <= from / 16 && !(Math.abs(step) >= Math.abs(least))) least = step;
    }
    return least;
  };
  const worldFromScreen = product(Float64Array.from(manifest.world_from_eye), inverse(Float64Array.from(manifest.screen_from_eye)));
  const setByNormal = (i, x, y) => {
    const [a, b, c] = normal.subarray(3 * i, 3 * i + 3), m = worldFromScreen, z = depth[i];
    if (!(a || b || c)) return false;
    const at = [0, 4, 8, 12].map((row) => m[row] * (x + .5) + m[row + 1] * (y + .5) + m[row + 2] * z + m[row + 3]);
    const d = -(a * at[0] + b * at[1] + c * at[2]) / at[3];
    const [p, q, r] = [0, 1, 2].map((column) => a * m[column] + b * m[4 + column] + c * m[8 + column] + d * m[12 + column]);
    const limited = (exact) => Number.isFinite(exact) ? clamp(exact, -z / 16, z / 16) : 0;
    across[i] = limited(-p / r);
    down[i] = limited(-q / r);
    return true;
  };
  const slope = (before, after) => {
    if (Number.isNaN(before) || Number.isNaN(after)) return Number.isNaN(after) ? -before || 0 : after;
    return Math.abs(before) < Math.abs(after) ? -before : after;
  };
  for (let place = 0, y = height - 1; y >= 0; y--) {
    for (let x = 0; x < width; x++, place++) {
      for (let i = first[place]; i < first[place + 1]; i++) {
        if (normal.length && setByNormal(i, x, y)) continue;
        across[i] = slope(gain(depth[i], x - 1, y), gain(depth[i], x + 1, y));
        down[i] = slope(gain(depth[i], x, y - 1), gain(depth[i], x, y + 1));
      }
    }
  }
  return {across, down};
}

function product(a, b) {
  const made = new Float64Array(16);
  for (let i = 0; i < 4; i++) {
    for (let k = 0; k < 4; k++) {
      for (let j = 0; j < 4; j++) made[4 * i + k] += a[4 * i + j] * b[4 * j + k];
    }
  }
  return made;
}

// The inverse by Gauss-Jordan elimination with partial pivoting.
function inverse(matrix) {
  const a = Float64Array.from(matrix), b = identity();
  const swap = (m, i, k) => { for (let j = 0; j < 4; j++) [m[4 * i + j], m[4 * k + j]] = [m[4 * k + j], m[4 * i + j]]; };
  for (let column = 0; column < 4; column++) {
    let pivot = column;
    for (let i = column + 1; i < 4; i++) if (Math.abs(a[4 * i + column]) > Math.abs(a[4 * pivot + column])) pivot = i;
    swap(a, pivot, column);
    swap(b, pivot, column);
    const scale = 1 / a[5 * column];
    for (let j = 0; j < 4; j++) { a[4 * column + j] *= scale; b[4 * column + j] *= scale; }
    for (let i = 0; i < 4; i++) {
      const factor = a[4 * i + column];
      if (i === column) continue;
      for (let j = 0; j < 4; j++) { a[4 * i + j] -= factor * a[4 * column + j]; b[4 * i + j] -= factor * b[4 * column + j]; }
    }
  }
  return b;
}

const identity = () => Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);

// Draws the layers. `only` is the surface to draw, counted from 1 in front; 0 means all. Holes have
// the colour `background`. Fills the pixels and returns what became of the samples.
function warpLayers(layers, matrix, {splat, only, background}, pixels, depths) {
  const {first, depth, colour, across, down} = layers, m = matrix;
  const counts = {drawn: 0, beside: 0, behind: 0};
  pixels.fill(background);
  depths.fill(0);
  const fixed = {point: 1, three: 3, projected: 0}[splat];
  for (let place = 0, y = height - 1; y >= 0; y--) {
    for (let x = 0; x < width; x++, place++) {
      const u = x + .5, v = y + .5, end = first[place + 1];
      const startX = m[0] * u + m[1] * v + m[3], startY = m[4] * u + m[5] * v + m[7];
      const startZ = m[8] * u + m[9] * v + m[11], startW = m[12] * u + m[13] * v + m[15];
      for (let i = first[place]; i < end; i++) {
        if (only && end - i !== only) continue;
        const z = depth[i], w = startW + z * m[14];
        if (!(w > 0)) { counts.behind++; continue; }
        const over = 1 / w, atX = (startX + z * m[2]) * over, atY = (startY + z * m[6]) * over, atZ = (startZ + z * m[10]) * over;
        const s = across[i], t = down[i], wRight = m[12] + s * m[14], wDown = m[13] + t * m[14];
        const side = (at, row) => (Math.abs(m[row] + s * m[row + 2] - at * wRight) + Math.abs(m[row + 1] + t * m[row + 2] - at * wDown)) * over;
        const halfOf = (at, row) => (fixed || Math.min(Math.max(side(at, row), 1), largestSplat)) / 2;
        const halfX = halfOf(atX, 0), halfY = halfOf(atY, 4);
        const left = Math.max(Math.floor(atX - halfX + .5), 0), right = Math.min(Math.floor(atX + halfX + .5), width);
        const top = Math.max(Math.floor(atY - halfY + .5), 0), bottom = Math.min(Math.floor(atY + halfY + .5), height);
        if (!(left < right && top < bottom && atZ > 0 && atZ <= nearestDepth)) { counts.beside++; continue; }
        counts.drawn++;
        for (let row = top; row < bottom; row++) {
          for (let to = row * width + left; to < row * width + right; to++) {
            if (atZ <= depths[to]) continue;
            depths[to] = atZ;
            pixels[to] = colour[i];
          }
        }
      }
    }
  }
  counts.holes = depths.reduce((sum, one) => sum + (one === 0), 0);
  return counts;
}

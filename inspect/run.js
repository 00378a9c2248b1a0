// A run: the data of the page about it, and the tables by which its fragments are found quickly.

const fates = ["hidden", "discarded", "written", "blended"];
const marks = {rejected: 1, clippedAway: 2, cut: 4, zeroArea: 8, culled: 16, setUp: 32};
const noTriangle = 0xffffffff;

// Loads a run from a page of `glassbox inspect`: this one, or another that was read as a document.
async function loadRun(page, name) {
  const text = (id) => page.getElementById(id)?.textContent;
  const facts = JSON.parse(text("manifest") ?? "{}");
  if (facts.format !== "glassbox inspect") throw new Error("it is not a page of glassbox inspect");
  if (facts.version !== 1) throw new Error("it was made by another version of glassbox");
  const bytes = await inflate(bytesOfBase64(text("columns")));
  const run = {name, facts, columns: unpackColumns(bytes, facts.columns), ...sizes(facts)};
  checkColumns(run);
  indexTriangles(run);
  indexFragments(run);
  groupFragments(run);
  run.normals = text("normals");
  run.others = {};
  run.start = await startPicture(run, text("picture"));
  return run;
}

function sizes({width, height}) {
  const legal = (side) => Number.isInteger(side) && side >= 1 && side <= 16384;
  if (!legal(width) || !legal(height)) throw new Error("its picture has no legal size");
  return {width, height};
}

// Checks what the rest of the script assumes.
function checkColumns({columns: c, facts, width, height}) {
  const need = (fine) => { if (!fine) throw new Error("its data contradict themselves"); };
  const same = (count, ...names) => need(names.every((name) => c[name]?.length === count));
  same(c["triangle.number"].length, "triangle.face", "triangle.a", "triangle.b", "triangle.c", "triangle.marks");
  same(c["fragment.triangle"].length, "fragment.piece", "fragment.x", "fragment.y", "fragment.fate");
  same(c["position.index"].length, "position.x", "position.y", "position.z");
  need(c["fragment.x"].every((x) => x < width) && c["fragment.y"].every((y) => y < height));
  need(facts.draws.reduce((sum, draw) => sum + draw.triangles, 0) === c["triangle.number"].length);
  const written = c["fragment.fate"].reduce((sum, fate) => sum + (fate >= 2), 0);
  same(written, "written.r", "written.g", "written.b", "written.a");
  let row = 0;
  for (const draw of facts.draws) {
    const {positions} = facts.meshes[draw.mesh];
    for (const end = row + draw.triangles; row < end; row++) {
      need(["a", "b", "c"].every((corner) => c[`triangle.${corner}`][row] < positions));
    }
  }
}

// The rows of the triangle columns by triangle number, the draw of each row, and the polygons of
// cut triangles.
function indexTriangles(run) {
  const {columns: c, facts} = run, number = c["triangle.number"];
  run.triangleCount = number.length;
  run.rowOf = new Map();
  number.forEach((each, row) => run.rowOf.set(each, row));
  let firstPosition = 0;
  for (const mesh of facts.meshes) {
    mesh.firstPosition = firstPosition;
    firstPosition += mesh.positions;
  }
  let firstRow = 0;
  for (const draw of facts.draws) {
    draw.firstRow = firstRow;
    firstRow += draw.triangles;
  }
  run.cut = new Map();
  let vertex = 0;
  c["cut.number"].forEach((each, i) => {
    const count = c["cut.count"][i];
    run.cut.set(each, Array.from({length: count}, (_, k) => ({
      clip: Array.from(c["cut.clip"].subarray(4 * (vertex + k), 4 * (vertex + k + 1))),
      weights: Array.from(c["cut.weights"].subarray(3 * (vertex + k), 3 * (vertex + k + 1))),
    })));
    vertex += count;
  });
}

const drawOfRow = (run, row) => run.facts.draws.findLast((draw) => draw.firstRow <= row && draw.triangles > 0);

// The fragments of each pixel, in order, are ofPixel[startOf[pixel]] .. ofPixel[startOf[pixel + 1]
// - 1]. For each fragment, place is the index of its bytes among the written ones, and before is
// the fragment that last wrote the pixel (-1: none).
function indexFragments(run) {
  const {columns: c, width, height} = run;
  const x = c["fragment.x"], y = c["fragment.y"], fate = c["fragment.fate"], triangle = c["fragment.triangle"];
  const count = run.fragmentCount = x.length, pixels = width * height;
  run.startOf = new Uint32Array(pixels + 1);
  for (let i = 0; i < count; i++) run.startOf[y[i] * width + x[i] + 1]++;
  for (let i = 0; i < pixels; i++) run.startOf[i + 1] += run.startOf[i];
  const next = run.startOf.slice(0, pixels), last = new Int32Array(pixels).fill(-1);
  run.ofPixel = new Uint32Array(count);
  run.place = new Int32Array(count);
  run.before = new Int32Array(count);
  run.lineCode = new Map();
  let written = 0;
  for (let i = 0; i < count; i++) {
    const pixel = y[i] * width + x[i];
    run.ofPixel[next[pixel]++] = i;
    run.before[i] = last[pixel];
    run.place[i] = fate[i] >= 2 ? written++ : -1;
    if (fate[i] >= 2) last[pixel] = i;
    if (triangle[i] === noTriangle) run.lineCode.set(i, c["fragment.code"][run.lineCode.size]);
  }
}

// The fragments in groups, in the order of their arrival. The fragments of a triangle follow each
// other and form one group; each fragment of a line or point is a group of its own. Group g is
// groupStart[g] .. groupStart[g + 1] - 1. groupOf maps a triangle's number to its first group.
function groupFragments(run) {
  const triangle = run.columns["fragment.triangle"], starts = [];
  run.groupOf = new Map();
  for (let i = 0; i < run.fragmentCount; i++) {
    const number = triangle[i];
    if (i > 0 && number !== noTriangle && number === triangle[i - 1]) continue;
    if (number !== noTriangle && !run.groupOf.has(number)) run.groupOf.set(number, starts.length);
    starts.push(i);
  }
  run.groupCount = starts.length;
  run.groupStart = Uint32Array.from([...starts, run.fragmentCount]);
}

// The range of a triangle's fragments, [from, to) with `to` excluded; both are equal if there are
// none.
function fragmentsOfTriangle(run, number) {
  const group = run.groupOf.get(number);
  return group === undefined ? [0, 0] : [run.groupStart[group], run.groupStart[group + 1]];
}

function fragmentsAt(run, x, y) {
  const pixel = y * run.width + x;
  return run.ofPixel.subarray(run.startOf[pixel], run.startOf[pixel + 1]);
}

// The picture before the first fragment: the background, or around a recorded rectangle the
// finished picture.
async function startPicture({width, height, facts}, packed) {
  const picture = new Uint8ClampedArray(4 * width * height);
  new Uint32Array(picture.buffer).fill(new Uint32Array(Uint8Array.from(facts.background).buffer)[0]);
  if (!packed || !facts.rectangle) return picture;
  const [x0, y0, x1, y1] = facts.rectangle, finished = await unpackPicture(packed, width, height);
  for (let y = y0; y < y1; y++) {
    const from = 4 * (y * width + x0), to = 4 * (y * width + x1);
    finished.set(picture.subarray(from, to), from);
  }
  return finished;
}

async function unpackPicture(packed, width, height) {
  const bytes = await inflate(bytesOfBase64(packed));
  if (bytes.length !== 4 * width * height) throw new Error("its picture has another size than it says");
  undoRowDifferences(bytes, 4 * width);
  return new Uint8ClampedArray(bytes.buffer);
}

// The picture after a given number of fragments, and the fragment that each pixel shows (-1: none).
// To change the number, only the fragments in between are applied or undone.
class Playback {
  constructor(run) {
    this.run = run;
    this.at = 0;
    this.picture = run.start.slice();
    this.owner = new Int32Array(run.width * run.height).fill(-1);
    this.changed = [0, 0, run.width, run.height]; // x0, y0, x1, y1 of the changes since the last takeChanged()
  }

  // The box of the pixels that changed since the last call: x, y, width, height.
  takeChanged() {
    const [x0, y0, x1, y1] = this.changed;
    this.changed = [Infinity, Infinity, -Infinity, -Infinity];
    return x0 < x1 ? [x0, y0, x1 - x0, y1 - y0] : [0, 0, 0, 0];
  }

  moveTo(at) {
    at = clamp(at, 0, this.run.fragmentCount);
    const {place, before} = this.run;
    for (; this.at < at; this.at++) if (place[this.at] >= 0) this.show(this.at, this.at);
    for (; this.at > at; this.at--) if (place[this.at - 1] >= 0) this.show(this.at - 1, before[this.at - 1]);
  }

  // Lets the pixel of fragment i show fragment `shown`.
  show(i, shown) {
    const {columns: c, width, start, place} = this.run, {picture} = this;
    const x = c["fragment.x"][i], y = c["fragment.y"][i], pixel = y * width + x, at = 4 * pixel, box = this.changed;
    this.owner[pixel] = shown;
    if (x < box[0]) box[0] = x;
    if (y < box[1]) box[1] = y;
    if (x >= box[2]) box[2] = x + 1;
    if (y >= box[3]) box[3] = y + 1;
    if (shown < 0) {
      for (let k = 0; k < 4; k++) picture[at + k] = start[at + k];
      return;
    }
    const from = place[shown];
    picture[at] = c["written.r"][from];
    picture[at + 1] = c["written.g"][from];
    picture[at + 2] = c["written.b"][from];
    picture[at + 3] = c["written.a"][from];
  }
}

// The bytes r, g, b, a of fragment i's pixel before it, and after it.
function bytesAround(run, i) {
  const {columns: c, place, before, width, start} = run;
  const written = (at) => ["r", "g", "b", "a"].map((channel) => c[`written.${channel}`][at]);
  const pixel = 4 * (c["fragment.y"][i] * width + c["fragment.x"][i]);
  const held = before[i] < 0 ? Array.from(start.subarray(pixel, pixel + 4)) : written(place[before[i]]);
  return {before: held, after: place[i] < 0 ? held : written(place[i])};
}

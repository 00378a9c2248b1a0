// Quantities that are drawn over the picture or instead of it.

const overlays = {
  none: {name: "Picture", paint: null, note: () => ""},
  overdraw: {name: "Overdraw", paint: paintOverdraw, note: (run, {most}) =>
    most > 1 ? `Fragments of a pixel, hidden ones too: 1 dark, ${most} white.` : "No pixel has more than one fragment so far, hidden ones too."},
  hidden: {name: "Depth-failed", paint: paintHidden, note: (run, {total, pixels}) =>
    total ? `${count(total, "fragment")} lost the depth test, in ${count(pixels, "pixel")}.` : "No fragment lost the depth test so far."},
  culled: {name: "Culled", paint: paintCulled, note: (run, {triangles, pixels}) =>
    triangles ? `${count(triangles, "triangle")} facing away would have covered ${count(pixels, "pixel")}.` : "No triangle was culled."},
  clipped: {name: "Clipped", paint: paintClipped, note: (run, {pixels}) =>
    run.cut.size ? `${count(run.cut.size, "triangle")} cut by a plane, with fragments in ${count(pixels, "pixel")}.` : "No triangle was cut by a plane."},
  id: {name: "Triangle id", paint: paintId, note: () => "One colour for each triangle."},
  depth: {name: "Depth", paint: paintDepth, note: (run, {least, greatest}) =>
    greatest >= least ? `Depth ${shortNumber(least)} white to ${shortNumber(greatest)} dark.` : "Nothing is drawn yet."},
  ...(manifest.pictures.includes("made") ? {made: {name: "Yours", paint: paintOther("made"), note: () => "The picture as your functions draw it."}} : {}),
  ...(manifest.student ? {
    reference: {name: "Reference", paint: paintOther("reference"), note: () => "The picture as the reference draws it."},
    parts: {name: "Differences", paint: paintParts, note: (run, {pixels}) =>
      pixels ? `${count(pixels, "pixel")} differ from the reference.` : "Every pixel is equal to the reference."},
  } : {}),
  ...(manifest.pictures.includes("truth") ? {truth: {name: "What is there", paint: paintOther("truth"), note: () => "The scene itself, drawn from there."}} : {}),
  normals: {name: "Normals", paint: paintNormals, note: () => "Eye-space normals of the finished picture: x red, y green, z blue."},
};

const overlayHeat = [[24, 30, 60], [38, 70, 140], [36, 120, 170], [50, 160, 130], [120, 190, 80], [220, 200, 60], [245, 150, 50], [255, 255, 255]];
const heatOf = (level, most) => overlayHeat[most <= 1 ? 1 : Math.min(7, Math.round(((level - 1) / Math.max(most - 1, 1)) * 7))];

function setPixel(data, pixel, [r, g, b]) {
  const at = 4 * pixel;
  data[at] = r;
  data[at + 1] = g;
  data[at + 2] = b;
  data[at + 3] = 255;
}

// Darkens the picture, so that the overlay stands out.
function darken(data) {
  for (let at = 0; at < data.length; at += 4) {
    const grey = (data[at] * 3 + data[at + 1] * 6 + data[at + 2]) / 30;
    data[at] = data[at + 1] = data[at + 2] = grey;
    data[at + 3] = 255;
  }
}

function paintCounts(data, counts) {
  let most = 0, total = 0, pixels = 0;
  for (const each of counts) {
    if (each > most) most = each;
    total += each;
    if (each) pixels++;
  }
  for (let pixel = 0; pixel < counts.length; pixel++) if (counts[pixel]) setPixel(data, pixel, heatOf(counts[pixel], most));
  return {most, total, pixels};
}

// For each pixel, the number of fragments so far for which a test holds. The counts are updated,
// forwards or backwards, from the moment of the previous call.
function countFragments(playback, overlay, test) {
  const {run, at} = playback, x = run.columns["fragment.x"], y = run.columns["fragment.y"];
  playback.counted ??= {};
  const counted = (playback.counted[overlay] ??= {at: 0, counts: new Uint16Array(run.width * run.height)}), {counts} = counted;
  for (; counted.at < at; counted.at++) if (test(counted.at)) counts[y[counted.at] * run.width + x[counted.at]]++;
  for (; counted.at > at; counted.at--) if (test(counted.at - 1)) counts[y[counted.at - 1] * run.width + x[counted.at - 1]]--;
  return counts;
}

function paintOverdraw(playback, data) {
  darken(data);
  return paintCounts(data, countFragments(playback, "overdraw", () => true));
}

function paintHidden(playback, data) {
  const fate = playback.run.columns["fragment.fate"];
  darken(data);
  return paintCounts(data, countFragments(playback, "hidden", (i) => fate[i] === 0));
}

function paintClipped(playback, data) {
  const {cut} = playback.run, triangle = playback.run.columns["fragment.triangle"];
  darken(data);
  return paintCounts(data, countFragments(playback, "clipped", (i) => cut.has(triangle[i])));
}

// The pixels that the culled pieces would have covered.
function culledCounts(run) {
  if (run.culledCounts) return run.culledCounts;
  const counts = new Uint16Array(run.width * run.height), {"triangle.marks": mark, "triangle.number": number} = run.columns;
  let triangles = 0;
  for (let row = 0; row < mark.length; row++) {
    if (!(mark[row] & marks.culled)) continue;
    triangles++;
    for (const {setup, culled} of chainOf(run, number[row]).pieces) {
      if (culled) forEachCovered(setup, run.width, run.height, (x, y) => counts[y * run.width + x]++);
    }
  }
  return (run.culledCounts = {counts, triangles});
}

function forEachCovered({bounds: [x0, y0, x1, y1], edges}, width, height, visit) {
  for (let y = Math.max(y0, 0); y < Math.min(y1, height); y++) {
    for (let x = Math.max(x0, 0); x < Math.min(x1, width); x++) {
      if (edges.every((edge) => covers(edge, edgeAt(edge, x, y)))) visit(x, y);
    }
  }
}

function paintCulled(playback, data) {
  const {counts, triangles} = culledCounts(playback.run);
  darken(data);
  return {...paintCounts(data, counts), triangles};
}

function paintId({run, owner}, data) {
  const triangle = run.columns["fragment.triangle"];
  owner.forEach((fragment, pixel) => {
    if (fragment < 0 || triangle[fragment] === noTriangle) return;
    const hash = Math.imul(triangle[fragment] + 1, 0x9e3779b1) >>> 0;
    setPixel(data, pixel, [64 + ((hash >>> 8) & 191), 64 + ((hash >>> 16) & 191), 64 + ((hash >>> 24) & 191)]);
  });
  return {};
}

// The depths of all fragments in the order of their arrival; those of a triangle follow each other.
function allDepths(run) {
  run.depths ??= Float32Array.from({length: run.fragmentCount}, (_, i) =>
    run.columns["fragment.triangle"][i] === noTriangle ? NaN : depthOf(run, i));
  return run.depths;
}

function paintDepth({run, owner}, data) {
  const depths = allDepths(run);
  let least = Infinity, greatest = -Infinity;
  for (const fragment of owner) {
    const depth = fragment < 0 ? NaN : depths[fragment];
    if (depth < least) least = depth;
    if (depth > greatest) greatest = depth;
  }
  owner.forEach((fragment, pixel) => {
    const depth = fragment < 0 ? NaN : depths[fragment];
    if (Number.isNaN(depth)) return;
    const grey = 255 - 215 * ((depth - least) / (greatest - least || 1));
    setPixel(data, pixel, [grey, grey, grey]);
  });
  return {least, greatest};
}

function paintNormals({run}, data) {
  const picture = run.normalPicture;
  for (let pixel = 0; picture && pixel < run.width * run.height; pixel++) {
    if (picture[4 * pixel + 3]) setPixel(data, pixel, picture.subarray(4 * pixel, 4 * pixel + 3));
  }
  return {};
}

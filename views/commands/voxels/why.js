// The picked voxel in every picture: which pictures see it, with what colour, and what follows.

const pictures = manifest.shown.map((one) => ({...one, pixels: null, hidden: null}));
const kCrop = 25; // px, each way

async function pixelsOf(picture) {
  if (picture.pixels) return picture.pixels;
  const image = new Image();
  image.src = picture.uri;
  await image.decode();
  const canvas = newCanvas(picture.width, picture.height), context = canvas.getContext("2d", {willReadFrequently: true});
  context.drawImage(image, 0, 0);
  return picture.pixels = context.getImageData(0, 0, picture.width, picture.height).data;
}

async function hiddenOf(picture, i) {
  if (!manifest.has_layers) return null;
  if (!picture.hidden) picture.hidden = await inflate(bytesOfBase64(byId(`hidden${i}`).textContent));
  return picture.hidden;
}

// The pixel of the voxel's centre; null if it is outside the picture or behind the camera.
function pixelOf(picture, {x, y, z}) {
  const m = picture.pixel_from_grid, p = [x + .5, y + .5, z + .5, 1];
  const [u, v, w] = [0, 4, 8].map((row) => p.reduce((sum, value, k) => sum + m[row + k] * value, 0));
  const column = Math.floor(u / w), row = Math.floor(v / w);
  return w > 0 && column >= 0 && row >= 0 && column < picture.width && row < picture.height ? {column, row} : null;
}

// The result for one picture: "sees it", with its colour, or why not.
async function lookUp(picture, i, voxel) {
  const pixel = pixelOf(picture, voxel);
  if (!pixel) return {says: "does not contain it"};
  const pixels = await pixelsOf(picture), at = pixel.row * picture.width + pixel.column;
  if (pixels[4 * at + 3] === 0) return {says: "shows background", pixel};
  const hidden = await hiddenOf(picture, i);
  const from = hidden ? hidden[2 * at] | hidden[2 * at + 1] << 8 : 65535;
  if (from < layerOf(voxel)) return {says: `sees layer ${from + 1} in front of it`, pixel};
  return {says: hidden ? "sees it" : "contains it", pixel, color: [...pixels.subarray(4 * at, 4 * at + 3)]};
}

// For the colours of the pictures that see it: the mean, and the standard deviation pooled over the
// channels.
function statistics(colors) {
  const mean = [0, 1, 2].map((k) => colors.reduce((sum, color) => sum + color[k], 0) / colors.length);
  const squares = colors.reduce((sum, color) => sum + color.reduce((part, value, k) => part + (value - mean[k]) ** 2, 0), 0);
  return {mean, sigma: colors.length > 1 ? Math.sqrt(squares / (3 * (colors.length - 1))) : 0};
}

async function figureOf(picture, found) {
  const pixels = await pixelsOf(picture), canvas = newCanvas(kCrop, kCrop), context = canvas.getContext("2d");
  const crop = context.createImageData(kCrop, kCrop), half = kCrop >> 1;
  if (found.pixel) {
    for (let y = 0; y < kCrop; y++) {
      for (let x = 0; x < kCrop; x++) {
        const column = found.pixel.column + x - half, row = found.pixel.row + y - half;
        if (column < 0 || row < 0 || column >= picture.width || row >= picture.height) continue;
        const from = 4 * (row * picture.width + column);
        crop.data.set(pixels.subarray(from, from + 4), 4 * (y * kCrop + x));
      }
    }
  }
  context.putImageData(crop, 0, 0);
  context.strokeStyle = "#3df5ff";
  if (found.pixel) context.strokeRect(half - .5, half - .5, 2, 2);
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", `${picture.name} around the voxel`);
  const swatch = found.color ? element("i", {className: "swatch"}) : null;
  if (swatch) swatch.style.background = `rgb(${found.color.join(" ")})`;
  return element("figure", {className: found.color ? "" : "unseen"}, canvas, element("figcaption", {}, swatch, `${picture.name} ${found.says}`));
}

// The result of the test with the pixels at the centres. The verdict itself is the command's.
function testText(sigma) {
  const {test, space, settings} = manifest;
  if (space === "lab") return "the test compares CIELab";
  if (manifest.footprint !== "centre") return `the test compares all pixels of the footprint (${manifest.footprint})`;
  if (test === "sigma") {
    if (settings.threshold === null) return "below T = infinity";
    if (sigma < settings.threshold) return `below T = ${settings.threshold}`;
    const edges = settings.edge > 0 ? `, which is allowed where every picture has an edge of ${settings.edge}` : "";
    return `not below T = ${settings.threshold}${edges}`;
  }
  if (test === "ratio") return `the likelihood ratio assumes a noise of ${settings.noise}`;
  return `T = ${settings.k1} M + ${settings.k2}`;
}

let asked = 0;
async function explain(voxel) {
  const mine = ++asked;
  const found = await Promise.all(pictures.map((picture, i) => lookUp(picture, i, voxel)));
  const figures = await Promise.all(pictures.map((picture, i) => figureOf(picture, found[i])));
  if (mine !== asked) return;
  const colors = found.filter((one) => one.color).map((one) => one.color), {mean, sigma} = statistics(colors);
  const where = `Voxel (${voxel.x}, ${voxel.y}, ${voxel.z}), layer ${layerOf(voxel) + 1}`;
  const seen = manifest.has_layers
    ? `${count(colors.length, "picture")} ${colors.length === 1 ? "sees" : "see"} it`
    : `${count(colors.length, "picture")} ${colors.length === 1 ? "has" : "have"} it inside the object, some of them hidden by others`;
  const numbers = colors.length > 1 ? `: mean (${mean.map((value) => value.toFixed(1)).join(", ")}), sigma ${sigma.toFixed(2)}, ${testText(sigma)}` : "";
  const verdict = verdicts.length ? verdictNames[verdictOf(voxel)] : coloursOf.has(indexOf(voxel)) ? "coloured" : "carved, or inside";
  byId("readout").textContent = `${where}: ${verdict}. ${seen}${numbers}.`;
  byId("projections").replaceChildren(...figures);
}

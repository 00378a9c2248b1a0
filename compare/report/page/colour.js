// From samples to what the screen shows.

const nanColour = [255, 0, 255];
const plusInfinityColour = [255, 150, 0];
const minusInfinityColour = [0, 140, 255];

// Smallest and largest finite sample of the pictures.
function finiteRange(pictures) {
  let low = Infinity, high = -Infinity;
  for (const picture of pictures) {
    for (const {samples} of picture.tiles) {
      for (const value of samples) {
        if (value < low && value !== -Infinity) low = value;
        if (value > high && value !== Infinity) high = value;
      }
    }
  }
  return low <= high ? {low, high} : {low: 0, high: 1};
}

// The 8-bit colour of samples [start, start + channels): 16 bits to the nearest 8, floats linearly from range.low
// (black) to range.high (white).
function colourOf(picture, samples, start, range, out) {
  const grey = picture.channels < 3;
  for (let channel = 0; channel < 3; channel++) {
    const value = samples[grey ? start : start + channel];
    if (picture.type === "u8") out[channel] = value;
    else if (picture.type === "u16") out[channel] = Math.round(value / 257);
    else if (Number.isNaN(value)) return setColour(out, nanColour);
    else if (value === Infinity) return setColour(out, plusInfinityColour);
    else if (value === -Infinity) return setColour(out, minusInfinityColour);
    else out[channel] = Math.round(clamp((value - range.low) / (range.high - range.low || 1), 0, 1) * 255);
  }
}

function setColour(out, colour) {
  for (let channel = 0; channel < 3; channel++) out[channel] = colour[channel];
}

function alphaOf(picture, samples, start) {
  if (picture.channels % 2) return 255;
  const value = samples[start + picture.channels - 1];
  if (picture.type === "f32") return Math.round(clamp(value, 0, 1) * 255);
  return picture.type === "u16" ? Math.round(value / 257) : value;
}

// One canvas a tile, a pixel for a pixel.
function paintPicture(picture, range, opaque) {
  const colour = [0, 0, 0];
  for (const tile of picture.tiles) {
    tile.canvas ??= newCanvas(tile.width, tile.height);
    const context = tile.canvas.getContext("2d");
    const image = context.createImageData(tile.width, tile.height);
    const {samples} = tile, {channels} = picture, {data} = image;
    for (let from = 0, to = 0; from < samples.length; from += channels, to += 4) {
      colourOf(picture, samples, from, range, colour);
      data[to] = colour[0];
      data[to + 1] = colour[1];
      data[to + 2] = colour[2];
      data[to + 3] = opaque ? 255 : alphaOf(picture, samples, from);
    }
    context.putImageData(image, 0, 0);
  }
}

// The heat map, and versions of half the size again and again, for when a screen pixel stands for several of the
// picture: each has the hottest of its four, so that a single wrong pixel stays visible from any distance.
function paintHeat(heat, colours) {
  for (const tile of heat.tiles) {
    let level = {width: tile.width, height: tile.height, levels: tile.samples};
    tile.halvings = [level];
    while (level.width > 1 || level.height > 1) tile.halvings.push((level = halve(level)));
    for (const each of tile.halvings) each.canvas = paintLevels(each, colours);
    tile.canvas = tile.halvings[0].canvas;
  }
}

const leftOut = 255, hottest = 254, movedEdge = 253, belowThreshold = 252;
const setAside = (level) => level === movedEdge || level === belowThreshold;

// What is not compared and what is set aside are hotter than equal pixels, and less hot than all other differences.
const heatOf = (level) => (level === leftOut ? 0.1 : setAside(level) ? 0.2 : level);
const hotter = (a, b) => (heatOf(a) > heatOf(b) ? a : b);

function halve({width, height, levels}) {
  const half = {width: (width + 1) >> 1, height: (height + 1) >> 1};
  half.levels = new Uint8Array(half.width * half.height);
  for (let y = 0; y < half.height; y++) {
    const above = 2 * y * width, below = Math.min(2 * y + 1, height - 1) * width;
    for (let x = 0; x < half.width; x++) {
      const left = 2 * x, right = Math.min(2 * x + 1, width - 1);
      half.levels[y * half.width + x] = hotter(hotter(levels[above + left], levels[above + right]),
        hotter(levels[below + left], levels[below + right]));
    }
  }
  return half;
}

function paintLevels({width, height, levels}, colours) {
  const canvas = newCanvas(width, height);
  const context = canvas.getContext("2d");
  const image = context.createImageData(width, height);
  const pixels = new Uint32Array(image.data.buffer);
  for (let i = 0; i < levels.length; i++) pixels[i] = colours[levels[i]];
  context.putImageData(image, 0, 0);
  return canvas;
}

// "#rrggbb" as a pixel of ImageData read as a little-endian number.
const packedColour = (text) => {
  const rgb = parseInt(text.slice(1), 16);
  return (0xff000000 | ((rgb & 255) << 16) | (rgb & 0xff00) | (rgb >> 16)) >>> 0;
};

// A small square in the colour of this level.
function swatch(level) {
  const made = element("i", {className: "swatch"});
  made.style.background = manifest.heat_colours[level];
  return made;
}

// The colours of the heat map from a single step to the hottest, without those of what is set aside, which has swatches.
function paintLegend(colours) {
  const levels = Uint8Array.from({length: hottest}, (_, i) => (setAside(i + 1) ? belowThreshold - 1 : i + 1));
  byId("legend").getContext("2d").drawImage(paintLevels({width: levels.length, height: 1, levels}, colours), 0, 0);
  byId("moved-edge").prepend(swatch(movedEdge));
  byId("below-threshold").prepend(swatch(belowThreshold));
}

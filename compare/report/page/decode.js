// From the data blocks of the page to exact samples.

const sampleTypes = {u8: Uint8Array, u16: Uint16Array, f32: Float32Array};

// Loads the pictures of a pair that lie in a file beside the page, as texts in base64. The file is a script that calls
// `glassboxPictures`, because a page that was opened without a server may not read files in another way.
let arrived = null;
window.glassboxPictures = (stamp, texts) => (arrived = {stamp, texts});

// `path` is the address for people.
function loadBeside({address, path, stamp}) {
  return new Promise((done, fail) => {
    const script = element("script", {src: address});
    script.onload = () => {
      script.remove();
      if (arrived?.stamp === stamp) done(arrived.texts);
      else fail(new Error(`The file ${path} beside this page belongs to another page.`));
      arrived = null;
    };
    script.onerror = () => {
      script.remove();
      fail(new Error(`There is no file ${path} beside this page.`));
    };
    document.head.append(script);
  });
}

// A picture of the manifest with its samples. They lie in tiles, boxes [x, x + width) x [y, y + height) of the
// picture: one for the whole of it, or several crops.
async function decodePicture(facts, text) {
  const bytes = await inflate(bytesOfBase64(text));
  const Samples = sampleTypes[facts.type];
  let offset = 0;
  const tiles = facts.tiles.map(([x, y, width, height]) => {
    const stride = width * facts.channels * Samples.BYTES_PER_ELEMENT;
    const part = bytes.slice(offset, offset + stride * height);
    offset += part.length;
    undoRowDifferences(part, stride);
    return {x, y, width, height, samples: new Samples(part.buffer)};
  });
  return {...facts, tiles};
}

// The samples of a pixel, one a channel; null where the page does not have it.
function samplesAt(picture, x, y) {
  for (const tile of picture?.tiles ?? []) {
    if (x < tile.x || y < tile.y || x >= tile.x + tile.width || y >= tile.y + tile.height) continue;
    const start = ((y - tile.y) * tile.width + (x - tile.x)) * picture.channels;
    return tile.samples.subarray(start, start + picture.channels);
  }
  return null;
}

const sampleText = (picture, value) => (picture.type === "f32" ? floatText(value) : String(value));

const channelLetters = {1: [""], 2: ["", "A"], 3: ["R", "G", "B"], 4: ["R", "G", "B", "A"]};

// Floats as integers in their order, neighbours one apart, -0 one below +0.
const floatStore = new Float32Array(1);
const bitsStore = new Int32Array(floatStore.buffer);
function orderOfFloat(value) {
  floatStore[0] = value;
  const bits = bitsStore[0];
  return bits < 0 ? ~bits - 2 ** 31 : bits;
}

// How many floats the second lies above the first; NaN where no number of steps leads there.
function ulpsBetween(a, b, nanEqualsNan) {
  if (Number.isNaN(a) && Number.isNaN(b)) return nanEqualsNan ? 0 : NaN;
  if (Number.isFinite(a) && Number.isFinite(b)) return orderOfFloat(b) - orderOfFloat(a);
  return a === b ? 0 : NaN;
}

// Test minus reference in steps of the format; NaN where that is no number.
function stepsBetween(picture, a, b) {
  return picture.type === "f32" ? ulpsBetween(a, b, state.facts.nan_equals_nan) : b - a;
}

function stepsText(steps) {
  if (Number.isNaN(steps)) return "∞";
  return steps === 0 ? "0" : (steps > 0 ? "+" : "−") + Math.abs(steps);
}

const unitOf = {u8: "/255", u16: "/65535", f32: " ulp"};

// The pictures: the reference, the differences of each way's picture from it, and how visible these
// are.

const {width, height} = manifest;
const unpacked = new Map(); // by the id of a block

async function bytesOf(id) {
  if (!unpacked.has(id)) unpacked.set(id, inflate(bytesOfBase64(byId(id).textContent)));
  return unpacked.get(id);
}

// The bytes of an opaque picture from a value for each channel of each pixel.
function image(valueOf) {
  const made = new ImageData(width, height), pixels = width * height;
  for (let i = 0; i < pixels; i++) {
    for (let channel = 0; channel < 3; channel++) made.data[4 * i + channel] = valueOf(i, channel, channel * pixels + i);
    made.data[4 * i + 3] = 255;
  }
  return made;
}

// The bytes of a picture, one plane per channel. The page stores the difference, modulo 256, from
// another picture or the reference.
async function planesOf(at) {
  const base = manifest.bases[at], from = base === null ? await bytesOf("reference") : await planesOf(base);
  const difference = await bytesOf(`difference${at}`);
  return difference.map((byte, i) => byte + from[i]);
}

const views = {
  picture: {
    title: "Picture",
    note: () => "The picture that glassbox render draws in this way, byte for byte.",
    async make(at) {
      const planes = await planesOf(at);
      return image((i, channel, place) => planes[place]);
    },
  },
  reference: {
    title: "Reference",
    note: () => `The reference: ${manifest.reference}.`,
    async make() {
      const reference = await bytesOf("reference");
      return image((i, channel, place) => reference[place]);
    },
  },
  difference: {
    title: "Difference",
    note: () => "The difference of each channel from the reference, eight times as bright.",
    async make(at) {
      const reference = await bytesOf("reference"), planes = await planesOf(at);
      return image((i, channel, place) => 8 * Math.abs(planes[place] - reference[place]));
    },
  },
  flip: {
    title: "FLIP",
    note: () => "The difference that a person sees when the two pictures are shown in turn, at 67 pixels per degree of view: black is none, white is the largest.",
    async make(at) {
      const levels = await bytesOf(`flip${at}`);
      return image((i, channel) => manifest.heat[levels[i]][channel]);
    },
  },
};

let shownView = "picture", flickering = 0, request = 0;

// Only the latest request is shown, because unpacking takes a while.
async function showPicture(name, point) {
  const mine = ++request, made = await views[name].make(point.picture);
  if (mine !== request) return;
  const canvas = byId("picture");
  Object.assign(canvas, {width, height, ariaLabel: `${views[name].title}: ${point.name}`});
  canvas.getContext("2d").putImageData(made, 0, 0);
  byId("picture-note").textContent = views[name].note();
}

function flicker(point, at = 0) {
  showPicture(at % 2 ? "reference" : "picture", point);
  flickering = setTimeout(() => flicker(point, at + 1), 500);
}

function showStage(point) {
  clearTimeout(flickering);
  if (byId("flicker").ariaPressed === "true") flicker(point);
  else showPicture(shownView, point);
}

// The page: the layers from the reader's viewpoint, each layer on its own, and the number of layers
// per pixel.

const screenFromEye = Float64Array.from(manifest.screen_from_eye), eyeFromScreen = inverse(screenFromEye);
const worldFromEye = Float64Array.from(manifest.world_from_eye);
const magenta = 0xffff00ff, most = manifest.most_samples_of_a_pixel;
const shown = {turn: 0, tilt: 0, nearer: 0, only: 0, holes: false};
const small = width < 480;
let layers, pixels, depths, image, waiting = false;

const moved = (x, y, z) => Float64Array.of(1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z, 0, 0, 0, 1);
function turned(turn, tilt) {
  const [c, s, d, t] = [Math.cos(turn), Math.sin(turn), Math.cos(tilt), Math.sin(tilt)];
  return product(Float64Array.of(c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1), Float64Array.of(1, 0, 0, 0, 0, d, -t, 0, 0, t, d, 0, 0, 0, 0, 1));
}

// From the reader's eye space to the camera's: a turn around the pivot, which is on the gaze, and a
// move towards it.
function eyeFromReader() {
  const {turn, tilt, nearer} = shown, far = manifest.pivot;
  return product(product(moved(0, 0, -far), turned(turn, tilt)), moved(0, 0, far * (1 - nearer)));
}
const warpMatrix = () => product(product(screenFromEye, inverse(eyeFromReader())), eyeFromScreen);

function show() {
  waiting = false;
  if (!layers) return;
  const start = performance.now();
  const splat = document.querySelector("#splats :checked").value;
  const counts = warpLayers(layers, warpMatrix(), {splat, only: shown.only, background: shown.holes ? magenta : manifest.background}, pixels, depths);
  const ms = performance.now() - start;
  byId("picture").getContext("2d").putImageData(image, 0, 0);
  const degrees = (angle) => `${(angle * 180 / Math.PI).toFixed(1).replace("-", "−")}°`;
  byId("readout").textContent = `Turned by ${degrees(shown.turn)} and ${degrees(shown.tilt)}, ${(100 * shown.nearer).toFixed(0).replace("-", "−")} % nearer. ` +
    `${count(counts.drawn, "sample")} drawn; ${(100 * counts.holes / depths.length).toFixed(2)} % of the pixels have none; ${ms.toFixed(1)} ms.`;
  byId("layer-shown").textContent = shown.only === 0 ? `all ${most}` : `number ${shown.only} of ${most}`;
  byId("layer").value = shown.only;
  byId("holes").ariaPressed = String(shown.holes);
  for (const button of document.querySelectorAll("#layers button")) button.className = Number(button.value) === shown.only ? "chosen" : "";
  byId("command").textContent = commandHere();
}

function showSoon() {
  if (!waiting) requestAnimationFrame(show);
  waiting = true;
}

// The camera's lens as options. The planes are given too, because the program would otherwise
// choose them to fit the scene.
function lensHere() {
  const m = screenFromEye, digits = (value) => Number(value.toPrecision(9)).toString(), same = (a, b) => Math.abs(a - b) <= 1e-9 * Math.abs(a);
  const wide = width / m[0], tall = -height / m[5];
  if (m[14] === 0) return `--ortho ${digits(tall)} --near=${digits((m[11] - 1) / m[10])} --far=${digits(m[11] / m[10])}`;
  const near = m[11], left = near * m[2] / m[0], top = near * m[6] / m[5];
  const right = left + near * wide, bottom = top - near * tall;
  const upright = same(left, -right) && same(bottom, -top) && same(wide * height, tall * width);
  return `${upright ? `--fov ${digits(2 * Math.atan(tall / 2) * 180 / Math.PI)}` : `--frustum=${[left, right, bottom, top].map(digits)}`} --near ${digits(near)}`;
}

// The command line that draws the same picture.
function commandHere() {
  const world = product(worldFromEye, eyeFromReader()), digits = (value) => Number(value.toPrecision(7)).toString();
  const column = (k, by = 1) => [0, 1, 2].map((i) => world[4 * i + k] * by);
  const eye = column(3), gaze = column(2, -manifest.pivot), target = eye.map((value, i) => value + gaze[i]);
  const text = (values) => values.map(digits).join(",");
  const splat = document.querySelector("#splats :checked").value;
  return `glassbox views layers draw ${manifest.file_as_word} --eye=${text(eye)} --look-at=${text(target)} --up=${text(column(1))} ${lensHere()}` +
    `${splat === "projected" ? "" : ` --splat ${splat}`}${shown.holes ? " --holes 1,0,1" : ""} -o view.png`;
}

function walk(turn, tilt, nearer = 0) {
  const quarter = Math.PI / 2;
  shown.turn = clamp(shown.turn + turn, -Math.PI, Math.PI);
  shown.tilt = clamp(shown.tilt + tilt, -quarter, quarter);
  shown.nearer = clamp(shown.nearer + nearer, -2, .95);
  showSoon();
}
function goHome() {
  Object.assign(shown, {turn: 0, tilt: 0, nearer: 0});
  showSoon();
}
function choose(only) {
  shown.only = clamp(only, 0, most);
  showSoon();
}
function toggleHoles() {
  shown.holes = !shown.holes;
  showSoon();
}

function pressed(event) {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const by = (event.shiftKey ? 10 : 2) * Math.PI / 180;
  const does = {
    ArrowLeft: () => walk(-by, 0), ArrowRight: () => walk(by, 0), ArrowUp: () => walk(0, -by), ArrowDown: () => walk(0, by),
    "+": () => walk(0, 0, .05), "=": () => walk(0, 0, .05), "-": () => walk(0, 0, -.05), 0: goHome, h: toggleHoles, H: toggleHoles,
    "[": () => choose(shown.only - 1), "]": () => choose(shown.only + 1),
  }[event.key];
  if (!does) return;
  event.preventDefault();
  does();
}

function setUpPicture() {
  const picture = byId("picture");
  Object.assign(picture, {width, height, className: small ? "small" : "", ariaLabel: "The layers from another view"});
  image = new ImageData(width, height);
  pixels = new Uint32Array(image.data.buffer);
  depths = new Float32Array(width * height);
  const perPixel = () => Math.PI / 2 / Math.max(picture.clientWidth, 1);
  picture.addEventListener("pointerdown", (event) => picture.setPointerCapture(event.pointerId));
  picture.addEventListener("pointermove", (event) => {
    if (picture.hasPointerCapture(event.pointerId)) walk(-event.movementX * perPixel(), -event.movementY * perPixel());
  });
  picture.addEventListener("wheel", (event) => {
    event.preventDefault();
    walk(0, 0, -Math.sign(event.deltaY) * .05);
  }, {passive: false});
  picture.addEventListener("keydown", pressed);
  byId("holes").addEventListener("click", toggleHoles);
  byId("home").addEventListener("click", goHome);
  Object.assign(byId("layer"), {max: most, oninput: ({target}) => choose(Number(target.value))});
  for (const radio of document.querySelectorAll("#splats input")) radio.addEventListener("change", showSoon);
}

// Place 0 is the pixel at the bottom left.
function fillByPlace(canvas, colourOf) {
  Object.assign(canvas, {width, height, className: small ? "small" : ""});
  const made = new ImageData(width, height), to = new Uint32Array(made.data.buffer);
  for (let place = 0, y = height - 1; y >= 0; y--) {
    for (let x = 0; x < width; x++, place++) to[y * width + x] = colourOf(place);
  }
  canvas.getContext("2d").putImageData(made, 0, 0);
}

function layerButton(number) {
  const canvas = newCanvas(width, height);
  let samples = 0;
  fillByPlace(canvas, (place) => {
    if (layers.counts[place] < number) return 0;
    samples++;
    return layers.colour[layers.first[place + 1] - number];
  });
  canvas.ariaHidden = "true";
  return element("button", {type: "button", value: number, onclick: () => choose(shown.only === number ? 0 : number)}, canvas,
    element("span", {}, `${number}: ${count(samples, "sample")}`));
}

// Dark to light, so that the numbers can be told apart without colours too: none, 1, 2, 3, 4 or 5,
// more.
const heat = ["#00000000", "#2d2a6e", "#3b7fb8", "#43bd8f", "#b5d84b", "#fdf6b0"];
const heatOf = (samples) => samples === 0 ? 0 : samples <= 3 ? samples : samples <= 5 ? 4 : 5;
const heatNames = ["none", "1", "2", "3", "4 or 5", "6 or more"];
function packedColour(text) {
  const channels = [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16));
  return text.length > 7 ? 0 : (0xff000000 | channels[2] << 16 | channels[1] << 8 | channels[0]) >>> 0;
}

function setUpComplexity() {
  const packed = heat.map(packedColour), pixelsWith = heat.map(() => 0);
  fillByPlace(byId("complexity"), (place) => {
    const level = heatOf(layers.counts[place]);
    pixelsWith[level]++;
    return packed[level];
  });
  byId("complexity").ariaLabel = `Samples of each pixel: ${manifest.depth_complexity.toFixed(2)} on average, over pixels that have one`;
  byId("legend").append(...heat.flatMap((colour, level) => {
    if (!pixelsWith[level]) return [];
    const mark = element("i", {ariaHidden: "true"});
    mark.style.background = colour;
    return [element("span", {}, mark, `${heatNames[level]}: ${(100 * pixelsWith[level] / layers.counts.length).toFixed(1)} %`)];
  }));
}

document.title = `${manifest.file}: glassbox views layers`;
byId("title").textContent = manifest.file;
byId("summary").textContent = `${width} × ${height}, ${count(manifest.samples, "sample")}, depth complexity ${manifest.depth_complexity.toFixed(2)}`;
byId("program").textContent = manifest.program;
setUpPicture();
readLayers().then((read) => {
  layers = read;
  const shownLayers = Math.min(most, 12);
  byId("layers").append(...Array.from({length: shownLayers}, (_, i) => layerButton(i + 1)));
  if (most > shownLayers) byId("layers").append(element("span", {}, `The first ${shownLayers} of ${most}.`));
  setUpComplexity();
  show();
  document.body.dataset.ready = "true";
});

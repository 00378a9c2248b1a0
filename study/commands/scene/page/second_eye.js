// The right eye, drawn or warped from what the left one sees: its error, its cost, and where it
// differs.

const eyes = manifest.second_eye;

// The red, green and blue planes of the right eye's picture for each way. For warped pictures the
// page stores the difference from the drawn one.
async function eyePlanes(name) {
  const drawn = await bytesOf("right-eye");
  if (name === "drawn") return drawn;
  const difference = await bytesOf(`right-eye-${name}`);
  return difference.map((byte, i) => byte + drawn[i]);
}

const eyeName = ({layers}) => `warp:${layers}`;
const eyeViews = eyes.left_out ? {} : Object.fromEntries([["drawn", {title: "Drawn", note: "The right eye, drawn."}],
  ...eyes.warped.flatMap((eye) => [
    [eyeName(eye), {title: `Warped from ${count(eye.layers, "layer")}`, note: `${digits(100 * eye.holes / eyes.pixels)} % of its pixels are holes, filled from the pixels beside them.`}],
    [`${eyeName(eye)} off`, {title: `Difference, ${count(eye.layers, "layer")}`, note: "The difference of each channel from the drawn picture of the right eye, eight times as bright."}]]),
  ["left", {title: "The left eye instead", note: "What the left eye sees."}]]);

let eyeRequest = 0;
async function showEye(name) {
  const mine = ++eyeRequest, [own, off] = name.split(" "), planes = await eyePlanes(own), drawn = off ? await bytesOf("right-eye") : null;
  if (mine !== eyeRequest) return;
  const canvas = byId("eye-picture");
  Object.assign(canvas, {width, height, ariaLabel: `${eyeViews[name].title}: the right eye`});
  canvas.getContext("2d").putImageData(image((i, channel, place) => drawn ? 8 * Math.abs(planes[place] - drawn[place]) : planes[place]), 0, 0);
  byId("eye-note").textContent = eyeViews[name].note;
}

function eyeTable() {
  const ms = (time) => [digits(time), (time / eyes.one_eye_ms).toFixed(2)], percent = (pixels) => `${digits(100 * pixels / eyes.pixels)} %`;
  const rows = [["drawn", "0", "0", "0 %", "0 %", ...ms(eyes.both_drawn_ms)],
    ...eyes.warped.map((eye) => [eyeName(eye), digits(eye.rms), eye.largest, percent(eye.wrong_pixels), percent(eye.holes), ...ms(eye.both_ms)]),
    ["the left eye's picture for both eyes", digits(eyes.left_in_its_place.rms), eyes.left_in_its_place.largest, percent(eyes.left_in_its_place.wrong_pixels), "", ...ms(eyes.one_eye_ms)]];
  const heads = ["right eye", "RMS [1/255]", "largest", "wrong", "filled", "ms a pair", "times one eye"];
  return table(heads, heads.map((head, i) => i > 0 ? "number" : ""), rows);
}

function setUpEyes() {
  if (eyes.left_out) {
    byId("eye-summary").textContent = `Not measured: ${eyes.left_out}.`;
    byId("eye-parts").hidden = true;
    return;
  }
  byId("eye-summary").textContent = `Two eyes ${digits(eyes.separation)} apart, with the window at ${digits(eyes.window)}: the pictures of glassbox render --stereo pair --second-eye, ` +
    "compared with drawing the right eye. Times are processor time of one thread.";
  byId("eye-table").append(eyeTable());
  segments("eye-views", titles(eyeViews), "eye-view", showEye);
  showEye("drawn");
}

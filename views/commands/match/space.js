// The points in space, drawn one by one with a depth buffer, as the rasterizer draws pixels.

const space = byId("space");
const turn = {yaw: 0, pitch: 0, near: 1};
const cloud = {}; // x, y, z: floats, the camera at 0, looking along +z; of: each point's pixel; at: each pixel's point, or -1; image: as drawn last

// Without a calibration depths are unknown; then each pixel is lifted off the picture by its
// disparity.
function placePoints(colours) {
  const count = width * height, {focal_px: f, baseline, offset_px: offset, centre} = manifest.calibration ?? {focal_px: width, centre: [width / 2, height / 2]};
  Object.assign(cloud, {focal: f, x: new Float32Array(count), y: new Float32Array(count), z: new Float32Array(count), of: new Int32Array(count), at: new Int32Array(count).fill(-1), count: 0, colours});
  const depths = [];
  const depthOf = (disparity) => manifest.calibration ? f * baseline / (disparity + offset) : 1 - .5 * (disparity - data.ends[0]) / (data.ends[1] - data.ends[0]);
  for (let i = 0; i < count; i++) {
    const depth = depthOf(data.disparity[i]);
    if (!Number.isFinite(data.disparity[i]) || !(depth > 0 && Number.isFinite(depth))) continue;
    const at = cloud.count++, column = i % width + .5, row = Math.floor(i / width) + .5;
    const share = manifest.calibration ? depth / f : 1 / f;
    cloud.x[at] = (column - centre[0]) * share;
    cloud.y[at] = (row - centre[1]) * share;
    cloud.z[at] = depth;
    cloud.of[at] = i;
    cloud.at[i] = at;
    depths.push(depth);
  }
  depths.sort((a, b) => a - b);
  cloud.middle = depths.length ? depths[Math.floor(depths.length / 2)] : 1;
}

// Projects a point: stores its position in place.x and place.y, px, and its depth in place.depth.
// The camera turns about the middle of what it sees.
function eyeOf(across, down) {
  const {yaw, pitch, near} = turn, cy = Math.cos(yaw), sy = Math.sin(yaw), cp = Math.cos(pitch), sp = Math.sin(pitch);
  const fit = Math.min(across / width, down / height) * near, scale = cloud.focal * fit;
  const see = (k, place) => {
    const x = cloud.x[k], y = cloud.y[k], z = cloud.z[k] - cloud.middle;
    const xt = cy * x + sy * z, zt = cy * z - sy * x, yt = cp * y + sp * zt;
    place.depth = cp * zt - sp * y + cloud.middle;
    place.x = Math.round(across / 2 + scale * xt / place.depth);
    place.y = Math.round(down / 2 + scale * yt / place.depth);
    return place.depth >= .02 * cloud.middle;
  };
  return {see, fit};
}

function drawCloud(across, down) {
  const image = new ImageData(across, down), words = new Uint32Array(image.data.buffer), depths = new Float32Array(across * down).fill(Infinity);
  words.fill(0xff1c1714);
  const {see, fit} = eyeOf(across, down), size = Math.max(1, Math.ceil(1.15 * fit)), before = Math.floor(size / 2), place = {};
  for (let k = 0; k < cloud.count; k++) {
    if (!see(k, place)) continue;
    const {x, y, depth} = place;
    for (let v = Math.max(y - before, 0); v < Math.min(y - before + size, down); v++) {
      for (let u = Math.max(x - before, 0); u < Math.min(x - before + size, across); u++) {
        const at = v * across + u;
        if (depth < depths[at]) depths[at] = depth, words[at] = cloud.colours[cloud.of[k]];
      }
    }
  }
  return image;
}

function drawRing(context) {
  const chosen = cloud.at[cursor.y * width + cursor.x], place = {};
  if (chosen < 0 || !eyeOf(space.width, space.height).see(chosen, place)) return;
  for (const [colour, line] of [["#000b", 4.5], ["#3df5ff", 2]]) {
    context.beginPath();
    context.arc(place.x, place.y, 7 * devicePixelRatio, 0, 2 * Math.PI);
    Object.assign(context, {strokeStyle: colour, lineWidth: line * devicePixelRatio});
    context.stroke();
  }
}

// Shows the points as drawn last, and the cursor's point.
function showSpace() {
  if (!cloud.image) return;
  const context = space.getContext("2d");
  context.putImageData(cloud.image, 0, 0);
  drawRing(context);
}

function drawSpace() {
  if (!cloud.x || !space.clientWidth) return;
  const across = space.width = Math.min(Math.round(space.clientWidth * devicePixelRatio), 1400), down = space.height = Math.round(across / 1.5);
  cloud.image = drawCloud(across, down);
  showSpace();
}

function turnBy(yaw, pitch) {
  Object.assign(turn, {yaw: turn.yaw + yaw, pitch: clamp(turn.pitch + pitch, -1.5, 1.5)});
  drawSpace();
}
function comeNearer(factor) {
  turn.near = clamp(turn.near * factor, .25, 16);
  drawSpace();
}

function setUpSpace() {
  const picture = byId("left").querySelector("img"), canvas = newCanvas(width, height);
  const context = canvas.getContext("2d");
  context.drawImage(picture, 0, 0);
  placePoints(new Uint32Array(context.getImageData(0, 0, width, height).data.buffer));
  space.addEventListener("pointerdown", (event) => space.setPointerCapture(event.pointerId));
  space.addEventListener("pointermove", (event) => {
    if (space.hasPointerCapture(event.pointerId)) turnBy(event.movementX * -.006, event.movementY * .006);
  });
  space.addEventListener("keydown", (event) => {
    const turns = {ArrowLeft: [-.1, 0], ArrowRight: [.1, 0], ArrowUp: [0, -.1], ArrowDown: [0, .1]}[event.key], factor = {"+": 1.2, "=": 1.2, "-": 1 / 1.2}[event.key];
    if (event.ctrlKey || event.altKey || event.metaKey || !(turns || factor)) return;
    event.preventDefault();
    if (turns) turnBy(...turns);
    else comeNearer(factor);
  });
  byId("nearer").addEventListener("click", () => comeNearer(1.2));
  byId("farther").addEventListener("click", () => comeNearer(1 / 1.2));
  byId("straight").addEventListener("click", () => {
    Object.assign(turn, {yaw: 0, pitch: 0, near: 1});
    drawSpace();
  });
  byId("space-note").textContent = `${count(cloud.count, "point")}. Drag, or turn them with the arrow keys. ${manifest.calibration ? "Parts that the left camera does not see are empty." : "Without --calibration there is no depth: points are in front of the picture by their disparity."}`;
  new ResizeObserver(drawSpace).observe(space);
}

// Draws what is on top of the 3D geometry: the axes of the space with their names, the camera, the
// chosen triangle, and its chosen vertex. The geometry does not hide them.

const marksCanvas = byId("space-marks"), marks2d = marksCanvas.getContext("2d");

// ---- from a place of the space to the canvas, as the vertex shader goes ----

class Eye {
  constructor(space, {centre, scale}) {
    Object.assign(this, {centre, scale, m: turnMatrix(space), turned: turnScale()});
    const inFront = (p) => this.wOf(p) - 0.1;
    const within = [0, 1, 2].flatMap((k) => [(p) => 1 - p[k], (p) => 1 + p[k]]); // the shader's `reach`
    this.seen = space.divided ? [inFront, ...within] : [inFront];
  }
  fit(place) { return place.map((value, k) => (value - this.centre[k]) * this.scale); }

  // Turns to x right, y up, z away.
  turn(fitted) {
    const [x, y, z] = fitted.map((value, k) => value - turn.pivot[k]), {m} = this;
    return [0, 1, 2].map((row) => m[row] * x + m[row + 3] * y + m[row + 6] * z);
  }
  wOf(fitted) { return 1 + 0.25 * this.turn(fitted)[2]; }

  // The canvas point for a result of `fit`.
  point(fitted) {
    const [x, y, z] = this.turn(fitted), [sx, sy] = this.turned, w = 1 + 0.25 * z;
    return [marksCanvas.width * (0.5 + (0.5 * sx * x) / w), marksCanvas.height * (0.5 - (0.5 * sy * y) / w)];
  }

  // The canvas points of the visible part of a polygon, or of a line given by two positions.
  outline(places) { return this.seen.reduce(keepWhere, places.map((place) => this.fit(place))).map((p) => this.point(p)); }
}

// The part of a polygon where a linear function is not negative.
function keepWhere(polygon, distance) {
  return polygon.flatMap((p, i) => {
    const q = polygon[(i + 1) % polygon.length], [dp, dq] = [distance(p), distance(q)];
    const crossing = (dp >= 0) === (dq >= 0) ? [] : [p.map((value, k) => value + ((q[k] - value) * dp) / (dp - dq))];
    return dp >= 0 ? [p, ...crossing] : crossing;
  });
}

function tracePath(points) {
  marks2d.beginPath();
  points.forEach(([x, y], i) => marks2d[i ? "lineTo" : "moveTo"](x, y));
  marks2d.closePath();
}

function writeBeside([x, y], text, colour, [dx, dy]) {
  const size = 13 * devicePixelRatio;
  marks2d.font = `600 ${size}px system-ui, sans-serif`;
  marks2d.textAlign = "center";
  marks2d.textBaseline = "middle";
  marks2d.lineWidth = 4 * devicePixelRatio;
  marks2d.strokeStyle = colourVariable("--stage");
  marks2d.fillStyle = colour;
  const width = marks2d.measureText(text).width, at = [x + dx * (size + width / 2), y + dy * size];
  marks2d.strokeText(text, ...at);
  marks2d.fillText(text, ...at);
}

// ---- the axes ----

const roundBelow = (value) => {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * [5, 2, 1].find((factor) => factor * power <= value * (1 + 1e-9));
};

// Three lines from the origin, each with the coordinate at its end. If the view is far from the
// origin, they start at a round position near the middle of the view. Depth is drawn longer on the
// screen than it is.
function axesOf(run, space, {centre, scale, size}) {
  const seen = size / turn.zoom, middle = centre.map((value, k) => value + turn.pivot[k] / scale);
  const near = middle.every((value) => Math.abs(value) <= 1.2 * seen), grid = roundBelow(0.1 * seen);
  const from = middle.map((value) => (near ? 0 : Number((Math.floor((value - 0.45 * seen) / grid) * grid).toPrecision(9))));
  return {from, near, axes: (space.axes ?? letters.slice(0, 3)).map((name, k) => {
    const unit = space.down && k === 2 ? screenDepth(run) : 1, length = roundBelow((0.6 * seen) / unit);
    return {name, colour: colourVariable(`--axis-${letters[k]}`), to: from.map((value, i) => (i === k ? value + length * unit : value)),
      end: Number((from[k] / unit + length).toPrecision(9))};
  })};
}

function drawAxes(eye, {from, near, axes}) {
  const foot = eye.point(eye.fit(from));
  for (const {name, colour, to, end} of axes) {
    const line = eye.outline([from, to]);
    if (line.length < 2) continue;
    for (const [stroke, width] of [[colourVariable("--stage"), 4], [colour, 2]]) {
      tracePath(line);
      marks2d.strokeStyle = stroke;
      marks2d.lineWidth = width * devicePixelRatio;
      marks2d.stroke();
    }
    const tip = eye.point(eye.fit(to)), away = [tip[0] - foot[0], tip[1] - foot[1]], length = Math.hypot(...away) || 1;
    writeBeside(tip, `${name} = ${doubleText(end)}`, colour, away.map((value) => value / length));
  }
  if (!near) writeBeside(foot, vectorText(from), colourVariable("--quiet"), [0, 1]);
}

// ---- the camera ----

function drawCamera(eye, run, {camera}) {
  const at = camera && eye.outline([camera(run)])[0];
  if (!at) return;
  const size = 6 * devicePixelRatio, colour = colourVariable("--other");
  marks2d.beginPath();
  marks2d.arc(...at, size, 0, 2 * Math.PI);
  marks2d.fillStyle = colourVariable("--stage");
  marks2d.fill();
  marks2d.strokeStyle = colour;
  marks2d.lineWidth = 2 * devicePixelRatio;
  marks2d.stroke();
  marks2d.beginPath();
  marks2d.arc(...at, size / 2.5, 0, 2 * Math.PI);
  marks2d.fillStyle = colour;
  marks2d.fill();
  writeBeside(at, "camera", colour, [-0.7, -0.8]);
}

// ---- what is chosen ----

// The position of a vertex of the chosen triangle in the space. A vertex made by clipping has the
// position before the division that its weights give.
function placeOfVertex(run, space, chain, vertex) {
  if (vertex < 3) return space.place(chain.corners[vertex], run);
  const {clip, weights} = chain.polygon[vertex - 3];
  if (space.divided || space.fixed) return space.place({clip}, run);
  return weighted(weights, chain.corners.map((corner) => space.place(corner, run)));
}

function drawChosen(eye, run, space, chain) {
  const three = chain.corners.map((corner) => space.place(corner, run)), colour = colourVariable("--mark");
  marks2d.strokeStyle = marks2d.fillStyle = colour;
  marks2d.lineWidth = 1.5 * devicePixelRatio;
  if (three.every(Boolean)) {
    tracePath(eye.outline(three));
    marks2d.fill();
    marks2d.stroke();
  }
  const place = placeOfVertex(run, space, chain, state.vertex), at = place && eye.outline([place])[0];
  if (!at) return;
  marks2d.beginPath();
  marks2d.arc(...at, 5 * devicePixelRatio, 0, 2 * Math.PI);
  marks2d.stroke();
  writeBeside(at, vertexName(state.vertex), colour, [0.5, -1]);
}

function drawMarks(run, space, mesh) {
  const eye = new Eye(space, mesh);
  marks2d.clearRect(0, 0, marksCanvas.width, marksCanvas.height);
  drawAxes(eye, axesOf(run, space, mesh));
  drawCamera(eye, run, space);
  const chain = state.triangle === null ? null : cachedChain(run, state.triangle);
  if (chain) drawChosen(eye, run, space, chain);
}

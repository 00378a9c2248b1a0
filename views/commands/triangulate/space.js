// The cameras, rays and points in space, drawn from a side that can be turned.

const {matches, cameras} = manifest, centres = [cameras.left.centre, cameras.right.centre];
const plus = (a, b, share = 1) => a.map((x, k) => x + share * b[k]);
const minus = (a, b) => plus(a, b, -1);
const medianOf = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

let chosen = 0, middle = [0, 0, 0], radius = 1, places = [];
const inFront = ({state}) => state === "in front of both cameras";

// The middle is the median of the points in front of both cameras, and the radius reaches nine
// points in ten and both cameras: a few points far away do not count.
function measureSpace() {
  const points = matches.filter(inFront).map(({point}) => point);
  const seen = points.length ? points : centres;
  middle = [0, 1, 2].map((axis) => medianOf(seen.map((point) => point[axis])));
  const away = seen.map((point) => Math.hypot(...minus(point, middle))).sort((a, b) => a - b);
  radius = Math.max(away[Math.floor(.9 * (away.length - 1))], ...centres.map((c) => Math.hypot(...minus(c, middle)))) || 1;
}

// The corners of a camera's picture at a distance from its centre, in the world: the directions are
// R^T K^-1 (x, y, 1).
function pictureCorners({K, R, centre}, away) {
  const [across, down] = [2 * K[0][2], 2 * K[1][2]];
  return [[0, 0], [across, 0], [across, down], [0, down]].map(([x, y]) => {
    const v = (y - K[1][2]) / K[1][1], u = (x - K[0][2] - K[0][1] * v) / K[0][0];
    return plus(centre, [0, 1, 2].map((axis) => R[0][axis] * u + R[1][axis] * v + R[2][axis]), away);
  });
}

// Where a ray ends: at its point nearest to the other ray, or far away.
function rayEnd({origin, direction}, t) {
  return plus(origin, direction, t > 0 && t < 8 * radius ? t : 8 * radius);
}

// Draws lines and points, the nearer ones over the farther ones.
function drawSpace() {
  const ratio = Math.min(devicePixelRatio, 2), width = Math.max(1, Math.round(shape.clientWidth * ratio)), height = Math.max(1, Math.round(width / 2));
  shape.width = width;
  shape.height = height;
  const rows = turnedWorld(), away = 2 * radius / turn.nearer, eye = plus(middle, rows[2], away), focal = 1.2 * height, near = radius / 1000;
  const seenAt = (p) => rows.map((row) => row.reduce((sum, x, k) => sum + x * (p[k] - eye[k]), 0));
  const onCanvas = ([x, y, z]) => [width / 2 - focal * x / z, height / 2 + focal * y / z];
  const line = (from, to, colour, thick) => {
    let [a, b] = [seenAt(from), seenAt(to)];
    if (a[2] > -near && b[2] > -near) return;
    if (a[2] > -near) [a, b] = [b, a];
    if (b[2] > -near) b = plus(a, minus(b, a), (-near - a[2]) / (b[2] - a[2]));
    shapeContext.beginPath();
    shapeContext.moveTo(...onCanvas(a));
    shapeContext.lineTo(...onCanvas(b));
    Object.assign(shapeContext, {strokeStyle: colour, lineWidth: thick * ratio});
    shapeContext.stroke();
  };
  const [left, right, odd, own] = ["--reference", "--test", "--warn", "--text"].map(colourVariable);
  shapeContext.clearRect(0, 0, width, height);
  line(...centres, own, 1);
  for (const [camera, colour] of [[cameras.left, left], [cameras.right, right]]) {
    const corners = pictureCorners(camera, .15 * radius);
    corners.forEach((corner, k) => { line(camera.centre, corner, colour, 1.5); line(corner, corners[(k + 1) % 4], colour, 1.5); });
  }
  const isAll = byId("shown").querySelector(":checked").value === "all";
  matches.forEach((match, i) => {
    if (!isAll && i !== chosen) return;
    line(match.left_ray.origin, rayEnd(match.left_ray, match.t_left), left, i === chosen ? 2 : .5);
    line(match.right_ray.origin, rayEnd(match.right_ray, match.t_right), right, i === chosen ? 2 : .5);
  });
  const {ellipsoid, point} = matches[chosen];
  if (ellipsoid && point) ellipsoid.axes.forEach((axis, k) => {
    const half = Math.min(ellipsoid.half_axes[k] ?? Infinity, 8 * radius);
    line(plus(point, axis, -half), plus(point, axis, half), own, 1.5);
  });
  places = matches.map(({point}) => point && seenAt(point)).map((at) => at && at[2] < -near ? [...onCanvas(at), -at[2]] : null);
  const order = matches.map((_, i) => i).filter((i) => places[i]).sort((a, b) => places[b][2] - places[a][2]);
  for (const i of order) {
    shapeContext.beginPath();
    shapeContext.arc(places[i][0], places[i][1], (i === chosen ? 6 : 2.5) * ratio, 0, 2 * Math.PI);
    shapeContext.fillStyle = i === chosen ? own : inFront(matches[i]) ? left : odd;
    shapeContext.fill();
  }
}

const shortNumber = (value) => value === null || value === undefined ? "–" : Number(value.toPrecision(5)).toString().replace("-", "−");
const vectorText = (vector) => `(${vector.map(shortNumber).join(", ")})`;

function choose(at) {
  chosen = (at + matches.length) % matches.length;
  const {state, left, right, point, t_left, t_right, gap, angle_degrees, reprojection_px, ellipsoid} = matches[chosen];
  byId("readout").textContent = `Match ${chosen + 1} of ${matches.length}: ${state}. Left ${vectorText(left)}, right ${vectorText(right)}; t_l = ${shortNumber(t_left)}, t_r = ${shortNumber(t_right)}, gap ${shortNumber(gap)}, angle ${shortNumber(angle_degrees)}°. ${point ? `Point ${vectorText(point)}. ` : ""}Errors ${reprojection_px.map(shortNumber).join(" and ")} px. ${ellipsoid ? `Half axes ${ellipsoid.half_axes.map(shortNumber).join(", ")}.` : ""}`;
  redrawSpace();
}

function chooseNear(at) {
  const x = at % shape.width, y = Math.floor(at / shape.width);
  let best = -1, least = Infinity;
  places.forEach((place, i) => {
    const off = place ? Math.hypot(place[0] - x, place[1] - y) : Infinity;
    if (off < least) [best, least] = [i, off];
  });
  if (best >= 0) choose(best);
}

let redrawSpace = () => {};
function setUpSpace() {
  measureSpace();
  redrawSpace = setUpTurning({draw: drawSpace, mostNear: 16, pickAt: chooseNear});
  byId("shown").addEventListener("change", redrawSpace);
  byId("previous").addEventListener("click", () => choose(chosen - 1));
  byId("next").addEventListener("click", () => choose(chosen + 1));
  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.key === "n") choose(chosen + 1);
    if (event.key === "p") choose(chosen - 1);
  });
  choose(0);
}

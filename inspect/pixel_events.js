// What would have covered a pixel, and left no fragment there: triangles that turn away, and parts
// that a clipping plane cut off. They are the events that `glassbox pixel` lists, in its words.

// ---- which triangles may cover a pixel ----

// Finds the boxes that contain a pixel. A box is kept at the level whose cells are as large as the
// box, so it lies in at most four of them.
class BoxIndex {
  constructor(width, height) {
    this.levels = [];
    for (let shift = 2; shift === 2 || Math.max(width, height) >> (shift - 1); shift++) {
      const columns = (width >> shift) + 1;
      this.levels.push({shift, columns, last: new Int32Array(columns * ((height >> shift) + 1)).fill(-1)});
    }
    this.rows = [];
    this.before = []; // for each entry, the one before it in the same cell
  }

  add([x0, y0, x1, y1], row) {
    const {shift, columns, last} = this.levels.find((level) => Math.max(x1 - x0, y1 - y0) <= 1 << level.shift);
    for (let y = y0 >> shift; y <= y1 >> shift; y++) {
      for (let x = x0 >> shift; x <= x1 >> shift; x++) {
        this.before.push(last[y * columns + x]);
        last[y * columns + x] = this.rows.push(row) - 1;
      }
    }
  }

  at(x, y) {
    const found = [];
    for (const {shift, columns, last} of this.levels) {
      for (let i = last[(y >> shift) * columns + (x >> shift)]; i >= 0; i = this.before[i]) found.push(this.rows[i]);
    }
    return found.sort((a, b) => a - b);
  }
}

// The pixels that a triangle may cover if no plane cuts it, first and last column and row: all if it
// reaches behind the eye, where a corner has no place; null if there are none.
function boxOfCorners({width, height}, places) {
  if (!places.some(Boolean)) return null;
  if (!places.every(Boolean)) return [0, 0, width - 1, height - 1];
  const xs = places.map(([x]) => x), ys = places.map(([, y]) => y), margin = 1; // the snap moves them by less
  const low = (values) => Math.max(0, Math.floor(Math.min(...values)) - margin);
  const high = (values, size) => Math.min(size - 1, Math.floor(Math.max(...values)) + margin);
  const [x0, y0, x1, y1] = [low(xs), low(ys), high(xs, width), high(ys, height)];
  return x0 <= x1 && y0 <= y1 ? [x0, y0, x1, y1] : null;
}

const cutOff = marks.rejected | marks.clippedAway | marks.cut;

// The rows of the triangles of which a plane cut something off, or which turn away.
function indexWithoutFragment(run) {
  const index = new BoxIndex(run.width, run.height), c = run.columns;
  for (const draw of run.facts.draws) {
    const places = [], placeOf = (i) => {
      if (places[i] !== undefined) return places[i];
      const clip = clipFrom(draw.clip_from_anchored, anchoredFrom(draw, positionOf(run, draw, i).object));
      return (places[i] = clip[3] > 0 ? toScreen(divide(clip), run.facts.view.viewport).position : null);
    };
    for (let row = draw.firstRow; row < draw.firstRow + draw.triangles; row++) {
      if (!(c["triangle.marks"][row] & (cutOff | marks.culled))) continue;
      const box = boxOfCorners(run, corners.map((corner) => placeOf(c[`triangle.${corner}`][row])));
      if (box) index.add(box, row);
    }
  }
  return index;
}

// ---- what happened to a triangle at a pixel ----

const determinant = (a, b, c) =>
  a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) + c[0] * (a[1] * b[2] - a[2] * b[1]);

// As unclipped_point_at of history.cpp: the point of the whole triangle that is seen through the
// pixel's centre, in clip space; null if the triangle does not cover the centre.
function unclippedPointAt(clips, [left, top, right, bottom], x, y) {
  const centre = [(2 * (x + 0.5 - left)) / (right - left) - 1, 1 - (2 * (y + 0.5 - top)) / (bottom - top), 1];
  const three = clips.map(([cx, cy, , cw]) => [cx, cy, cw]), whole = determinant(...three);
  if (whole === 0 || !Number.isFinite(whole)) return null;
  const shares = [0, 1, 2].map((k) => determinant(...three.map((corner, i) => (i === k ? centre : corner))) / whole);
  if (!shares.every((share) => share >= 0)) return null;
  const sum = shares[0] + shares[1] + shares[2];
  if (!(sum > 0)) return null;
  const clip = [0, 1, 2, 3].map((k) => clips.reduce((total, corner, i) => total + (shares[i] / sum) * corner[k], 0));
  return {clip, counterClockwise: whole > 0};
}

function clippedEvent(run, row, x, y) {
  const {columns: c, facts} = run, draw = drawOfRow(run, row);
  const clips = corners.map((corner) => clipFrom(draw.clip_from_anchored,
    anchoredFrom(draw, positionOf(run, draw, c[`triangle.${corner}`][row]).object)));
  const seen = unclippedPointAt(clips, facts.view.viewport, x, y);
  const plane = seen && facts.planes.find((each) => signedDistance(each, seen.clip) < 0);
  return plane ? {fate: "clipped", plane: plane.name, inside: signedDistance(plane, seen.clip),
    front: seen.counterClockwise !== draw.mirrored} : null;
}

function turnedAwayEvent(run, row, x, y) {
  const piece = chainOf(run, run.columns["triangle.number"][row]).pieces.find(({setup, culled}) =>
    culled && setup.edges.every((edge) => covers(edge, edgeAt(edge, x, y))));
  if (!piece) return null;
  const area = piece.setup.doubleArea / 131072;
  return {fate: "turned-away", front: piece.front, area: piece.setup.clockwise ? -area : area};
}

function eventOf(run, row, x, y) {
  const mark = run.columns["triangle.marks"][row];
  return (mark & marks.culled ? turnedAwayEvent(run, row, x, y) : null) ?? (mark & cutOff ? clippedEvent(run, row, x, y) : null);
}

// The events without a fragment at a pixel, in the order of drawing. Those of the last pixel are
// kept.
function eventsAt(run, x, y) {
  if (run.lastEvents?.x === x && run.lastEvents.y === y) return run.lastEvents.events;
  run.withoutFragment ??= indexWithoutFragment(run);
  const numbers = run.columns["triangle.number"];
  const drawn = new Set(Array.from(fragmentsAt(run, x, y), (i) => run.columns["fragment.triangle"][i]));
  const events = run.withoutFragment.at(x, y).filter((row) => !drawn.has(numbers[row])).flatMap((row) => {
    const event = eventOf(run, row, x, y);
    return event ? [{...event, row, number: numbers[row]}] : [];
  });
  run.lastEvents = {x, y, events};
  return events;
}

// Fragments, {fragment}, and events without one, {event}, in the order of drawing.
function historyOf(run, x, y) {
  const events = eventsAt(run, x, y), all = [], triangle = run.columns["fragment.triangle"];
  let next = 0;
  for (const fragment of fragmentsAt(run, x, y)) {
    const row = run.rowOf.get(triangle[fragment]) ?? -1;
    while (next < events.length && events[next].row < row) all.push({event: events[next++]});
    all.push({fragment});
  }
  return [...all, ...events.slice(next).map((event) => ({event}))];
}

// ---- in words ----

const nineDigits = (value) => String(Number(value.toPrecision(9))).replace("-", "−");

function eventText({fate, plane, inside, front, area}) {
  const side = front ? "front" : "back";
  return fate === "clipped" ? `the ${plane} plane cut off its ${side}, which would be at this pixel (it is ${nineDigits(-inside)} outside)` :
    `shows its ${side}: signed area ${nineDigits(area)} px², counter-clockwise is positive`;
}

// "2 turned-away, 1 clipped"
function eventCounts(events) {
  return ["turned-away", "clipped"].map((fate) => [events.filter((event) => event.fate === fate).length, fate])
    .filter(([number]) => number).map(([number, fate]) => `${number.toLocaleString("en")} ${fate}`).join(", ");
}

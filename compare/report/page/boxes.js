// Boxes around the differing pixels. What lies close together on the screen shares a box, so that the picture stays
// visible under the boxes, however many pixels differ.

const boxesApart = 16; // CSS pixels that boxes have between them, unless each box is a region
const mostBoxes = 20_000; // with more, the page would not follow the mouse

const isDifference = (level) => level !== 0 && (level < belowThreshold || level === hottest);

// How far apart in px, along both axes, differing pixels should share a box: a power of two, and 1 where each box is a
// region. Nothing is further apart than the picture is large.
function reachAt(scale) {
  const largest = Math.max(state.pair.width, state.pair.height);
  let reach = 1;
  while (reach * scale < boxesApart && reach < largest) reach *= 2;
  return reach;
}

// The boxes for a reach, {reach, boxes}; those for a larger one where there would be too many. The picture is divided into
// cells of reach x reach px. Cells with differing pixels that touch each other make a box, and it is drawn around their
// differing pixels. Boxes that overlap become one, unless they are regions.
function boxesOf(heat, reach) {
  heat.boxes ??= new Map();
  if (!heat.boxes.has(reach)) {
    const boxes = boxesOfTiles(heat.tiles, reach);
    heat.boxes.set(reach, boxes ? {reach, boxes: reach > 1 ? withoutOverlaps(boxes) : boxes} : boxesOf(heat, 2 * reach));
  }
  return heat.boxes.get(reach);
}

// Null if there are more than the most boxes. A tile is one cell at last, and there are few tiles.
function boxesOfTiles(tiles, reach) {
  const boxes = [];
  for (const tile of tiles) {
    const cells = connectedCells(tile.halvings[Math.min(Math.log2(reach), tile.halvings.length - 1)], mostBoxes - boxes.length);
    if (!cells) return null;
    for (const box of cells) boxes.push(tightened(tile, box, reach));
  }
  return boxes;
}

// The boxes around connected cells: runs of cells in a row are joined to those that they touch in the row above (Rosenfeld
// and Pfaltz 1966). Null as soon as there are surely more than `most`: each box that may still be joined to another one has
// a run in this row.
function connectedCells({width, height, levels}, most) {
  const boxes = [];
  let number = 0, above = [];
  for (let y = 0; y < height; y++) {
    const row = runsIn(levels, y * width, width);
    let first = 0;
    for (const run of row) {
      while (first < above.length && above[first].to < run.from) first++;
      for (let i = first; i < above.length && above[i].from <= run.to; i++) {
        const box = lastOf(above[i].box);
        run.box ??= box;
        if (box === run.box) continue;
        joinInto(run.box, box);
        number--;
      }
      if (!run.box) {
        boxes.push(run.box = {left: run.from, top: y, right: run.to, bottom: y + 1, into: null});
        number++;
      }
      grow(run.box, run.from, y, run.to, y + 1);
    }
    if (number - row.length > most) return null;
    above = row;
  }
  return number > most ? null : boxes.filter(({into}) => !into);
}

// The runs [from, to) of differing cells in a row.
function runsIn(levels, start, width) {
  const runs = [];
  for (let x = 0; x < width; x++) {
    if (!isDifference(levels[start + x])) continue;
    const from = x;
    while (x < width && isDifference(levels[start + x])) x++;
    runs.push({from, to: x, box: null});
  }
  return runs;
}

// The box that a box has been joined into, by whatever way.
function lastOf(box) {
  while (box.into) {
    box.into = box.into.into ?? box.into;
    box = box.into;
  }
  return box;
}

function joinInto(box, other) {
  grow(box, other.left, other.top, other.right, other.bottom);
  other.into = box;
}

function grow(box, left, top, right, bottom) {
  box.left = Math.min(box.left, left);
  box.top = Math.min(box.top, top);
  box.right = Math.max(box.right, right);
  box.bottom = Math.max(box.bottom, bottom);
}

// A box of cells in px of the picture, without empty rows and columns at its sides.
function tightened(tile, cells, reach) {
  let left = cells.left * reach, top = cells.top * reach;
  let right = Math.min(cells.right * reach, tile.width), bottom = Math.min(cells.bottom * reach, tile.height);
  const isEmpty = (x0, y0, x1, y1) => {
    for (let y = y0; y < y1; y++) for (let x = x0; x < x1; x++) if (isDifference(tile.samples[y * tile.width + x])) return false;
    return true;
  };
  while (isEmpty(left, top, right, top + 1)) top++;
  while (isEmpty(left, bottom - 1, right, bottom)) bottom--;
  while (isEmpty(left, top, left + 1, bottom)) left++;
  while (isEmpty(right - 1, top, right, bottom)) right--;
  return {x: tile.x + left, y: tile.y + top, width: right - left, height: bottom - top};
}

const around = (a, b) => {
  const x = Math.min(a.x, b.x), y = Math.min(a.y, b.y);
  return {x, y, width: Math.max(a.x + a.width, b.x + b.width) - x, height: Math.max(a.y + a.height, b.y + b.height) - y};
};

// Joins boxes that overlap until none do.
function withoutOverlaps(boxes) {
  let joined = true;
  while (joined) {
    joined = false;
    boxes.sort((a, b) => a.y - b.y);
    for (let i = 0; i < boxes.length; i++) {
      for (let j = i + 1; boxes[i] && j < boxes.length && (!boxes[j] || boxes[j].y < boxes[i].y + boxes[i].height); j++) {
        const [a, b] = [boxes[i], boxes[j]];
        if (!b || a.x >= b.x + b.width || b.x >= a.x + a.width) continue;
        boxes[i] = around(a, b);
        boxes[j] = null;
        joined = true;
      }
    }
    boxes = boxes.filter(Boolean);
  }
  return boxes;
}

// The boxes at this zoom, and their reach; none where the pictures were not compared.
const shownBoxes = () => (state.pair?.heat ? boxesOf(state.pair.heat, reachAt(view.scale)) : {reach: 1, boxes: []});

function boxesText() {
  const {reach, boxes: {length}} = shownBoxes();
  if (!length) return "";
  const where = `${length === 1 ? "1 box" : `${numberText(length)} boxes`} on ${state.pair.tiled ? "these parts" : "the picture"}: `;
  return where + (reach === 1 || length === state.facts.differences.region_count ? "one around each region."
    : `at this zoom, pixels up to ${reach} px apart share one.`);
}

// Boxes around the differing pixels. What lies close together on the screen shares a box, so that the picture stays
// visible under the boxes, however many pixels differ.

const boxesApart = 16; // CSS pixels that boxes have between them, unless each box is a region

const isDifference = (level) => level !== 0 && (level < belowThreshold || level === hottest);

// How far apart in px, along both axes, differing pixels surely share a box: a power of two, and 1 where each box is a
// region. Nothing is further apart than the picture is large.
function reachAt(scale) {
  const largest = Math.max(state.pair.width, state.pair.height);
  let reach = 1;
  while (reach * scale < boxesApart && reach < largest) reach *= 2;
  return reach;
}

// The boxes for a reach. The picture is divided into cells of reach x reach px. Cells with differing pixels that touch each
// other make a box, and it is drawn around their differing pixels. Boxes that overlap become one, unless they are regions.
function boxesOf(heat, reach) {
  heat.boxes ??= new Map();
  if (!heat.boxes.has(reach)) {
    const boxes = heat.tiles.flatMap((tile) => boxesOfTile(tile, reach));
    heat.boxes.set(reach, reach > 1 ? withoutOverlaps(boxes) : boxes);
  }
  return heat.boxes.get(reach);
}

function boxesOfTile(tile, reach) {
  const {width, height, levels} = tile.halvings[Math.min(Math.log2(reach), tile.halvings.length - 1)];
  const seen = new Uint8Array(width * height), boxes = [];
  for (let at = 0; at < levels.length; at++) {
    if (!seen[at] && isDifference(levels[at])) boxes.push(tightened(tile, cellsFrom(at, width, height, levels, seen), reach));
  }
  return boxes;
}

// The box of the cells that hang together with one of them; marks them as seen.
function cellsFrom(start, width, height, levels, seen) {
  const box = {left: width, top: height, right: 0, bottom: 0}, open = [start];
  seen[start] = 1;
  while (open.length) {
    const at = open.pop(), x = at % width, y = (at - x) / width;
    box.left = Math.min(box.left, x);
    box.top = Math.min(box.top, y);
    box.right = Math.max(box.right, x + 1);
    box.bottom = Math.max(box.bottom, y + 1);
    for (let row = Math.max(y - 1, 0); row <= Math.min(y + 1, height - 1); row++) {
      for (let column = Math.max(x - 1, 0); column <= Math.min(x + 1, width - 1); column++) {
        const next = row * width + column;
        if (seen[next] || !isDifference(levels[next])) continue;
        seen[next] = 1;
        open.push(next);
      }
    }
  }
  return box;
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

// The boxes at this zoom; none where the pictures were not compared.
const shownBoxes = () => (state.pair?.heat ? boxesOf(state.pair.heat, reachAt(view.scale)) : []);

function boxesText() {
  const {length} = shownBoxes(), reach = reachAt(view.scale);
  if (!length) return "";
  const where = `${length === 1 ? "1 box" : `${numberText(length)} boxes`} on ${state.pair.tiled ? "these parts" : "the picture"}: `;
  return where + (reach === 1 || length === state.facts.differences.region_count ? "one around each region."
    : `at this zoom, pixels up to ${reach} px apart share one.`);
}

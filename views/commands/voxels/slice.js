// One layer of the sweep with its verdicts, and the picked voxel.

const verdictNames = ["background", "hidden", "seen by fewer than two", "inconsistent", "coloured"];
const verdictColours = [[226, 229, 234], [60, 66, 78], [150, 120, 190], [196, 108, 92], [255, 255, 255]];
const slice = byId("slice"), sliceContext = slice.getContext("2d");
const [sliceAxis, sliceWay] = manifest.direction, rowAxis = (sliceAxis + 1) % 3, columnAxis = (sliceAxis + 2) % 3;
let verdicts = new Uint8Array(0), coloursOf = new Map(), picked = null;

const layerCount = manifest.count[sliceAxis];
const placeOf = (layer) => sliceWay > 0 ? layer : layerCount - 1 - layer;
const layerOf = (voxel) => placeOf([voxel.x, voxel.y, voxel.z][sliceAxis]);
const indexOf = ({x, y, z}) => (z * ny + y) * nx + x;

function voxelIn(layer, row, column) {
  const at = [0, 0, 0];
  at[sliceAxis] = placeOf(layer);
  at[rowAxis] = row;
  at[columnAxis] = column;
  return {x: at[0], y: at[1], z: at[2]};
}

// Carving keeps no verdicts; it only shows which voxels are coloured.
const verdictOf = (voxel) => verdicts.length ? verdicts[indexOf(voxel)] : coloursOf.has(indexOf(voxel)) ? 4 : 0;

function drawSlice() {
  const layer = Number(byId("layer").value), width = manifest.count[rowAxis], height = manifest.count[columnAxis];
  byId("layer-at").textContent = `${layer + 1} of ${layerCount}`;
  slice.width = width;
  slice.height = height;
  const picture = sliceContext.createImageData(width, height);
  for (let column = 0; column < height; column++) {
    for (let row = 0; row < width; row++) {
      const voxel = voxelIn(layer, row, column);
      const colour = coloursOf.get(indexOf(voxel)) ?? verdictColours[verdictOf(voxel)];
      picture.data.set([...colour, 255], 4 * ((height - 1 - column) * width + row));
    }
  }
  sliceContext.putImageData(picture, 0, 0);
  if (!picked || layerOf(picked) !== layer) return;
  const at = [picked.x, picked.y, picked.z], x = at[rowAxis], y = height - 1 - at[columnAxis];
  sliceContext.lineWidth = 1;
  for (const [room, colour] of [[2.5, "#000"], [1.5, "#3df5ff"]]) {
    sliceContext.strokeStyle = colour;
    sliceContext.strokeRect(x - room + .5, y - room + .5, 2 * room, 2 * room);
  }
}

function setUpSlice(pick) {
  const range = byId("layer");
  range.max = layerCount - 1;
  range.value = Math.floor(layerCount / 3);
  range.addEventListener("input", drawSlice);
  slice.addEventListener("click", (event) => {
    // The picture keeps its aspect ratio, at the left of the canvas.
    const box = slice.getBoundingClientRect(), cell = Math.min(box.width / slice.width, box.height / slice.height);
    const row = Math.floor((event.clientX - box.left) / cell);
    const column = slice.height - 1 - Math.floor((event.clientY - box.top - (box.height - cell * slice.height) / 2) / cell);
    if (row < 0 || column < 0 || row >= slice.width || column >= slice.height) return;
    pick(voxelIn(Number(range.value), row, column));
  });
  slice.addEventListener("keydown", (event) => {
    const step = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
    if (!step) return;
    event.preventDefault();
    const at = picked && layerOf(picked) === Number(range.value) ? [picked.x, picked.y, picked.z] : null;
    const row = at ? at[rowAxis] + step[0] : slice.width >> 1, column = at ? at[columnAxis] + step[1] : slice.height >> 1;
    pick(voxelIn(Number(range.value), clamp(row, 0, slice.width - 1), clamp(column, 0, slice.height - 1)));
  });
  const names = verdicts.length ? verdictNames : ["empty, or inside", null, null, null, "coloured"];
  byId("legend").append(...names.map((name, i) => {
    if (!name) return null;
    const mark = element("i", {});
    mark.style.background = `rgb(${verdictColours[i].join(" ")})`;
    return element("span", {}, mark, i === 4 ? `${name}: shown in its colour` : name);
  }).filter((one) => one));
  drawSlice();
}

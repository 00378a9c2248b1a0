// Draws the coloured voxels from any side: as squares, with a depth for each pixel.

const [nx, ny, nz] = manifest.count, kVoxelBytes = 10;
let voxels = new Uint8Array(0), nearestAt = new Int32Array(0);

const voxelCount = () => voxels.length / kVoxelBytes;
function voxelAt(i) {
  const at = i * kVoxelBytes, short = (k) => voxels[at + k] | voxels[at + k + 1] << 8;
  return {x: short(0), y: short(2), z: short(4), color: [voxels[at + 6], voxels[at + 7], voxels[at + 8]], views: voxels[at + 9]};
}

// Colours from blue (few pictures) to yellow (many).
const viewsColour = (views) => {
  const share = clamp(views / manifest.pictures, 0, 1);
  return [40 + 210 * share, 80 + 140 * share, 200 - 150 * share];
};

// The rows of the rotation of the world: to the right, up, towards the eye.
function turnRows() {
  const world = turnedWorld();
  const axes = [0, 1, 2].map((k) => manifest.axes.slice(3 * k, 3 * k + 3));
  return world.map((row) => axes.map((axis) => row[0] * axis[0] + row[1] * axis[1] + row[2] * axis[2]));
}

function drawShape() {
  const ratio = Math.min(devicePixelRatio, 2);
  const width = Math.max(1, Math.round(shape.clientWidth * ratio)), height = Math.max(1, Math.round(width * 3 / 4));
  shape.width = width;
  shape.height = height;
  const picture = shapeContext.createImageData(width, height), depth = new Float32Array(width * height).fill(-Infinity);
  nearestAt = new Int32Array(width * height).fill(-1);
  const [right, up, out] = turnRows(), scale = turn.nearer * Math.min(width, height) / Math.hypot(nx, ny, nz);
  const size = Math.max(1, Math.ceil(scale * 1.5)), byViews = document.querySelector("#shades :checked").value === "views";
  for (let i = 0; i < voxelCount(); i++) {
    const voxel = voxelAt(i), p = [voxel.x + .5 - nx / 2, voxel.y + .5 - ny / 2, voxel.z + .5 - nz / 2];
    const along = (row) => row[0] * p[0] + row[1] * p[1] + row[2] * p[2];
    const left = Math.round(width / 2 + scale * along(right) - size / 2), top = Math.round(height / 2 - scale * along(up) - size / 2);
    const near = along(out), colour = byViews ? viewsColour(voxel.views) : voxel.color;
    for (let y = Math.max(top, 0); y < Math.min(top + size, height); y++) {
      for (let x = Math.max(left, 0); x < Math.min(left + size, width); x++) {
        const at = y * width + x;
        if (near <= depth[at]) continue;
        depth[at] = near;
        nearestAt[at] = i;
        picture.data.set([colour[0], colour[1], colour[2], 255], 4 * at);
      }
    }
  }
  shapeContext.putImageData(picture, 0, 0);
}

function setUpShape(pick) {
  const redraw = setUpTurning({draw: drawShape, mostNear: 40, pickAt: (at) => { if (nearestAt[at] >= 0) pick(voxelAt(nearestAt[at])); }});
  byId("shades").addEventListener("change", redraw);
}

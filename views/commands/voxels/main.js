// Assembles the page.

const unpack = async (id) => inflate(bytesOfBase64(byId(id).textContent));

function pick(voxel) {
  picked = voxel;
  byId("layer").value = layerOf(voxel);
  drawSlice();
  return explain(voxel);
}

async function main() {
  document.title = `${manifest.cameras}: glassbox views voxels`;
  byId("title").textContent = manifest.cameras;
  byId("summary").textContent = `${count(manifest.coloured, "coloured voxel")} from ${count(manifest.pictures, "picture")}`;
  byId("text").textContent = manifest.text;
  byId("program").textContent = manifest.program;
  byId("command").textContent = manifest.command;
  setUpLeftOut(manifest.flicker, "the voxels");
  [voxels, verdicts] = await Promise.all([unpack("voxels"), unpack("verdicts")]);
  for (let i = 0; i < voxelCount(); i++) {
    const voxel = voxelAt(i);
    coloursOf.set(indexOf(voxel), voxel.color);
  }
  setUpShape(pick);
  setUpSlice(pick);
  document.body.dataset.ready = "yes";
}

main();

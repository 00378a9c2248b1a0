// The page, put together.

const unpack = async (id) => inflate(bytesOfBase64(byId(id).textContent));

function pick(voxel) {
  picked = voxel;
  byId("layer").value = layerOf(voxel);
  drawSlice();
  return explain(voxel);
}

function setUpLeftOut() {
  const part = byId("left-out-part"), {flicker} = manifest;
  part.hidden = !flicker;
  if (!flicker) return;
  const image = byId("held"), button = byId("flicker");
  let isDrawn = false, timer = 0;
  const show = () => {
    image.src = isDrawn ? flicker.drawn : flicker.picture;
    image.alt = isDrawn ? "drawn from the voxels" : "the picture itself";
    byId("which").textContent = `${flicker.name}: ${isDrawn ? "drawn from the voxels, which did not have it" : "the picture itself"}`;
  };
  const change = () => { isDrawn = !isDrawn; show(); };
  byId("other").addEventListener("click", change);
  button.addEventListener("click", () => {
    button.setAttribute("aria-pressed", String(!timer));
    button.textContent = timer ? "Flicker" : "Hold";
    if (timer) clearInterval(timer);
    // Twice a second: slow enough for everybody's eyes.
    timer = timer ? 0 : setInterval(change, 500);
  });
  show();
}

async function main() {
  document.title = `${manifest.cameras}: glassbox views voxels`;
  byId("title").textContent = manifest.cameras;
  byId("summary").textContent = `${count(manifest.coloured, "coloured voxel")} from ${count(manifest.pictures, "picture")}`;
  byId("text").textContent = manifest.text;
  byId("program").textContent = manifest.program;
  byId("command").textContent = manifest.command;
  setUpLeftOut();
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

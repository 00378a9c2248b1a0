// Assembles the page.

const unpack = async (id) => inflate(bytesOfBase64(byId(id).textContent));

// The pixels of a picture in a form that the page can read.
async function pixelsOf(view) {
  const image = new Image();
  image.src = view.uri;
  await image.decode();
  const canvas = document.createElement("canvas");
  canvas.width = image.naturalWidth;
  canvas.height = image.naturalHeight;
  const context = canvas.getContext("2d", {willReadFrequently: true});
  context.drawImage(image, 0, 0);
  const {data} = context.getImageData(0, 0, canvas.width, canvas.height);
  return {matrix: view.pixel_from_world, width: canvas.width, height: canvas.height, data};
}

async function main() {
  document.title = `${manifest.title}: glassbox views ${manifest.verb}`;
  byId("title").textContent = manifest.title;
  byId("summary").textContent = manifest.summary;
  byId("text").textContent = manifest.text;
  byId("program").textContent = manifest.program;
  byId("command").textContent = manifest.command;
  byId("weights-part").hidden = byId("textured-choice").hidden = !textures;
  setUpLeftOut(manifest.flicker, "the surface");
  const bytes = await Promise.all(["places", "colors", "views", "seen"].map(unpack));
  places = new Float32Array(bytes[0].buffer, bytes[0].byteOffset, bytes[0].length / 4);
  [, colors, views, seen] = bytes;
  measure();
  if (textures) {
    pictures = await Promise.all(textures.views.map(pixelsOf));
    document.querySelector("#shades [value=textured]").checked = true;
  }
  setUpShape();
  document.body.dataset.ready = "yes";
}

main();

// The report, laid out.

function foundTerms() {
  const {range: [first, last], cost, paths, planes, target, volume_bytes: bytes, ms, steps_ms: steps, in_doubt: doubted, rectification} = manifest;
  return terms([
    ["disparities", `${first} to ${last} px`.replaceAll("-", "−")],
    ["cost", cost],
    ["paths", paths ? String(paths) : "none: each pixel is matched by itself"],
    ["planes", planes && `${count(planes, "round")}`],
    ["volumes", `${shortNumber(bytes / 1048576)} MB`],
    ["time", `${shortNumber(ms)} ms with ${target}: ` + Object.entries(steps).map(([name, time]) => `${name} ${time.toFixed(1)}`).join(", ")],
    ["uncertain", Object.entries(doubted).map(([name, pixels]) => `${name} ${(100 * pixels / (width * height)).toFixed(1)} %`).join(", ")],
    ["rectified", rectification && `${rectification.lost_percent.left.toFixed(1)} and ${rectification.lost_percent.right.toFixed(1)} % of the pictures are cut off by rectification`],
  ]);
}

const errorNames = {visible_and_textured: "visible and textured", textured_at_jumps: "textured, at a jump", visible: "visible to both", visible_at_jumps: "visible, at a jump", all: "all known"};
function errorsTable() {
  const rows = Object.entries(manifest.errors).filter(([, one]) => one.pixels).map(([key, one]) => [errorNames[key] ?? key, one.pixels.toLocaleString("en"),
    ...["0.5", "1", "2", "4"].map((at) => one.bad_percent[at].toFixed(2)), one.rms_px.toFixed(2), one.rms_good_px.toFixed(3), one.density_percent.toFixed(1)]);
  return table(["pixels", "", "0.5 px, %", "1 px", "2 px", "4 px", "RMS px", "of good px", "density %"], ["", ...Array(8).fill("number")], rows);
}

async function setUp() {
  const bytesOf = async (id) => byId(id) ? inflate(bytesOfBase64(byId(id).textContent)) : null;
  const floatsOf = async (id) => { const bytes = await bytesOf(id); return bytes && new Float32Array(bytes.buffer); };
  for (const id of ["disparity", "truth"]) data[id] = await floatsOf(id);
  for (const id of ["marks", "confidence", "sums"]) data[id] = await bytesOf(id);
  data.ends = endsOf(data.truth ?? data.disparity);
  setUpPanes();
  await Promise.all(["left", "right"].map((side) => byId(side).querySelector("img").decode()));
  setUpCurve();
  setUpSpace();
  drawMap();
  showCursor();
  byId("panes").dataset.ready = "yes";
}

document.title = `${manifest.pair}: glassbox views match`;
byId("title").textContent = manifest.pair;
byId("summary").textContent = manifest.errors ? `${manifest.errors.visible.bad_percent["1"].toFixed(2)} % of what both pictures show is off by more than a pixel` : `disparities ${range[0]} to ${range[1]}`;
if (manifest.errors) {
  byId("errors").append(errorsTable());
  byId("visible-by").textContent = `Per cent of the pixels that are off by more. Visible: ${manifest.visible_by}. A pixel without disparity counts as off. Good: those off by 1 px at most.`;
} else {
  byId("errors-section").hidden = true;
}
byId("found").append(...foundTerms());
byId("left-out").append(...manifest.left_out.map(({what, why}) => element("li", {}, element("strong", {}, what), `: ${why}`)));
byId("program").textContent = manifest.program;
byId("command").textContent = manifest.command;
setUp();

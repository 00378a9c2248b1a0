// Turns the planes into numbers, and reconstructs the bands from some of the components.

const {width, height, components, bands} = manifest;
const planes = {band: [], component: []};
let kept = manifest.kept, band = 0;

async function plane(name, i, [low, high]) {
  const bytes = await inflate(bytesOfBase64(byId(`${name}${i}`).textContent));
  const words = new Uint16Array(bytes.buffer, bytes.byteOffset, width * height);
  return Float32Array.from(words, (word) => low + (high - low) * word / 65535);
}

// Draws the samples. `grey` maps each to 0 .. 255.
function draw(canvas, samples, grey) {
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d"), image = context.createImageData(width, height);
  for (let i = 0; i < samples.length; i++) {
    const value = grey(samples[i]);
    image.data.set([value, value, value, 255], 4 * i);
  }
  context.putImageData(image, 0, 0);
}

const between = (low, high) => (value) => clamp(255 * (value - low) / (high - low || 1), 0, 255);
const shown = (value) => Number(value.toPrecision(4)).toLocaleString("en").replace("-", "−");

function again() {
  const sum = new Float32Array(width * height).fill(bands[band].mean);
  for (let k = 0; k < kept; k++) {
    const weight = components[k].vector[band], samples = planes.component[k];
    for (let i = 0; i < sum.length; i++) sum[i] += weight * samples[i];
  }
  return sum;
}

function show() {
  byId("kept").value = kept;
  byId("kept-at").textContent = `${kept} of ${components.length}`;
  const [low, high] = manifest.band_ranges[band], original = planes.band[band], made = again();
  draw(byId("original"), original, between(low, high));
  draw(byId("again"), made, between(low, high));
  const off = made.map((value, i) => value - original[i]);
  const rms = Math.sqrt(off.reduce((sum, value) => sum + value * value, 0) / off.length);
  const reach = Math.max(4 * rms, (high - low) / 255);
  draw(byId("difference"), off, between(-reach, reach));
  byId("again-says").textContent = kept ? `from ${count(kept, "component")}` : "from no component: its mean";
  byId("difference-says").textContent = `the difference: RMS ${shown(rms)}, white is +${shown(reach)}`;
  document.querySelectorAll("#components button").forEach((button, k) => {
    button.setAttribute("aria-pressed", String(k < kept));
    button.className = k < kept ? "" : "out";
  });
  document.querySelectorAll("#eigenvalues tbody tr").forEach((row, k) => { row.className = k < kept ? "" : "out"; });
}

function setUpComponents() {
  byId("components").append(...components.map(({eigenvalue, share}, k) => {
    const canvas = newCanvas(width, height), reach = 3 * Math.sqrt(eigenvalue);
    draw(canvas, planes.component[k], between(-reach, reach));
    const button = element("button", {type: "button"}, canvas, `${k + 1}: ${(100 * share).toFixed(2)} % of the variance`);
    button.addEventListener("click", () => { kept = k + 1; show(); });
    return button;
  }));
}

function setUpEigenvalues() {
  const rows = components.map(({eigenvalue, share, mse_without: rest, vector}, k) => {
    const bar = element("span", {className: "bar"});
    bar.style.width = `${100 * Math.sqrt(share)}%`;
    return [k + 1, shown(eigenvalue), bar, shown(rest), ...vector.map((value) => value.toFixed(3).replace("-", "−"))];
  });
  byId("eigenvalues").append(table(["", "eigenvalue", "deviation", "MSE with components up to it", ...bands.map(({name}) => name)],
    ["number", "number", "bars", "number", ...bands.map(() => "number")], rows));
}

async function main() {
  document.title = `${manifest.source}: glassbox views klt`;
  byId("title").textContent = manifest.source;
  byId("summary").textContent = `${count(bands.length, "band")} of ${width} × ${height}`;
  byId("text").textContent = manifest.text;
  byId("program").textContent = manifest.program;
  byId("command").textContent = manifest.command;
  byId("kept").max = components.length;
  byId("band").append(...bands.map(({name}, value) => element("option", {value}, name)));
  planes.band = await Promise.all(manifest.band_ranges.map((range, i) => plane("band", i, range)));
  planes.component = await Promise.all(manifest.component_ranges.map((range, i) => plane("component", i, range)));
  setUpComponents();
  setUpEigenvalues();
  byId("kept").addEventListener("input", () => { kept = Number(byId("kept").value); show(); });
  byId("band").addEventListener("change", () => { band = Number(byId("band").value); show(); });
  show();
  document.body.dataset.ready = "yes";
}

main();

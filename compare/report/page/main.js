// What is shown, and what happens when a pair is opened.

const state = {
  facts: null,   // the open pair in the manifest
  pair: null,    // its pictures, decoded: see decodePair
  panes: [],     // boxes of the canvas, each with its layers
  mode: "side",
  shown: 0,      // by flicker: 0 the reference, 1 the test
  divider: 0.5,  // of the wipe, from the pane's left (0) to its right (1)
  cursor: null,  // the pixel of the readout
  region: null,  // index of the one jumped to
  range: {low: 0, high: 1},
  fitted: true,
  get showBoxes() { return byId("boxes").checked; },
};

async function openPair(facts) {
  Object.assign(state, {facts, pair: null, panes: [], cursor: null, region: null, shown: 0, fitted: true});
  showFindings(facts);
  update();
  byId("message").textContent = facts.pictures || facts.beside ? "Decoding …" : "";
  const pair = await decodePair(facts);
  if (state.facts !== facts) return; // another one was opened meanwhile
  state.pair = pair;
  showWhatIsMissing(pair.problem ?? facts.left_out);
  offerControls();
  listRegions({...facts, regions: pair.regions});
  setRange(pair.range.low, pair.range.high);
  setMode(document.querySelector(`input[value=${state.mode}]`).disabled ? "side" : state.mode);
  if (pair.tiled && pair.regions.length) goToRegion(0);
}

async function decodePair(facts) {
  const {pictures: found = {}, textOf, problem} = await samplesOf(facts);
  const decode = (name) => (found[name] ? decodePicture(found[name], textOf(name)) : null);
  const [reference, test, heat] = await Promise.all(["reference", "test", "heat"].map(decode));
  const pictures = [reference, test].filter(Boolean);
  return {
    reference, test, heat, pictures, problem,
    width: Math.max(0, ...pictures.map((picture) => picture.width)),
    height: Math.max(0, ...pictures.map((picture) => picture.height)),
    tiled: pictures.some(isTiled),
    range: pictures[0]?.type === "f32" ? finiteRange(pictures) : {low: 0, high: 1},
    regions: facts.differences?.regions ?? [],
  };
}

// Whether the page has only parts of a picture.
function isTiled({tiles: [first, ...others], width, height, place}) {
  const [, , columns, rows] = place ?? [0, 0, width, height];
  return !first || others.length > 0 || first.width < columns || first.height < rows;
}

// The pictures of a pair, and their samples as text: from beside the page, or those in it.
async function samplesOf({pictures, beside}) {
  const inside = {pictures, textOf: (name) => byId(pictures[name].blob).textContent};
  if (!beside) return inside;
  try {
    const texts = await loadBeside(beside);
    return {pictures: beside.pictures, textOf: (name) => texts[name]};
  } catch (error) {
    return {...inside, problem: error.message};
  }
}

// Says over the pictures, or in their place, why they are not whole, and how to get them.
function showWhatIsMissing(text) {
  const {pictures, tiled} = state.pair, {alone_command, thumbnail} = state.facts;
  const why = text ?? (tiled ? "The whole pictures are too large for a page." : "");
  const parts = tiled ? "Here is what surrounds the worst differences. " : "";
  const said = why ? [element("p", {}, parts + why), command(alone_command) ?? ""] : [];
  byId("cropped").hidden = !pictures.length || !why;
  byId("cropped").replaceChildren(...(pictures.length ? said : []));
  byId("message").replaceChildren(...(pictures.length ? [] : said), pictures.length || !thumbnail ? "" : thumbnailImage(thumbnail));
}

// Only what works for the open pair.
function offerControls() {
  const {pictures, heat, range} = state.pair;
  const works = {side: pictures.length, flicker: pictures.length === 2, wipe: pictures.length === 2, heat};
  for (const [mode, possible] of Object.entries(works)) {
    document.querySelector(`input[value=${mode}]`).disabled = !possible;
  }
  for (const id of ["controls", "options", "readout"]) byId(id).hidden = !pictures.length;
  byId("opaque-label").hidden = !pictures.some(({channels}) => channels % 2 === 0);
  byId("range").hidden = byId("marks").hidden = pictures[0]?.type !== "f32";
  byId("readout").classList.toggle("tall", pictures[0]?.type === "f32" || pictures[0]?.channels === 4);
  for (const end of ["low", "high"]) Object.assign(byId(`${end}-slider`), {min: range.low, max: range.high});
  byId("hottest").textContent = {u8: "255", u16: "65,535", f32: "2²⁴ ulp or more"}[pictures[0]?.type];
  const {moved_edges, below_threshold} = state.facts.differences ?? {};
  byId("moved-edge").hidden = !moved_edges;
  byId("below-threshold").hidden = !below_threshold;
  byId("boxes-label").hidden = !heat;
  if (heat) paintHeat(heat, heatColours);
}

function paintPair() {
  for (const picture of state.pair.pictures) {
    picture.opaque = byId("opaque").checked;
    paintPicture(picture, state.range, picture.opaque);
  }
}

function pictureLayer(title, colour, picture) {
  const shown = [0, 0, 0];
  return {
    title, colour, picture, from: 0, to: 1,
    textAt: (x, y) => valueLines(picture, samplesAt(picture, x, y), (value) => sampleText(picture, value)),
    isBright: (x, y) => {
      const samples = samplesAt(picture, x, y);
      colourOf(picture, samples, 0, state.range, shown);
      return brightness(shown, picture.opaque ? 255 : alphaOf(picture, samples, 0)) > 140;
    },
  };
}

function heatLayer() {
  const {heat, reference} = state.pair;
  return {
    title: "Heat map", colour: "--heat", picture: heat, from: 0, to: 1,
    textAt: (x, y) => {
      const steps = differenceAt(x, y);
      if (!steps) return null;
      return steps.every((step) => step === 0) ? ["="] : valueLines(reference, steps, stepsText);
    },
    isBright: (x, y) => {
      const rgb = parseInt(manifest.heat_colours[samplesAt(heat, x, y)[0]].slice(1), 16);
      return brightness([rgb >> 16, (rgb >> 8) & 255, rgb & 255], 255) > 140;
    },
  };
}

const brightness = ([red, green, blue], alpha) =>
  ((red * 0.299 + green * 0.587 + blue * 0.114) * alpha + 230 * (255 - alpha)) / 255;

const valueLines = (picture, values, text) => values && Array.from(values, (value, channel) =>
  `${channelLetters[picture.channels][channel]}\u00a0${text(value)}`.trim());

// Test minus reference, one a channel; null where that is not known, or was left out of the comparison.
function differenceAt(x, y) {
  const {reference, test, heat} = state.pair;
  const a = samplesAt(reference, x, y), b = samplesAt(test, x, y), level = samplesAt(heat, x, y);
  if (!level || !a || !b || level[0] === leftOut) return null;
  return Array.from(a, (value, channel) => stepsBetween(reference, value, b[channel]));
}

// The panes of the mode.
function arrange() {
  const {reference, test, heat, pictures} = state.pair;
  const layers = [
    reference && pictureLayer("Reference", "--reference", reference),
    test && pictureLayer("Test", "--test", test),
    heat && heatLayer(),
  ];
  const groups = {
    side: layers.filter(Boolean).map((layer) => [layer]),
    flicker: [[layers[state.shown]]],
    wipe: [[{...layers[0], to: state.divider}, {...layers[1], from: state.divider}]],
    heat: [[layers[2]]],
  }[state.mode];
  const boxes = pictures.length ? paneBoxes(groups.length, state.pair) : [];
  state.panes = boxes.map((box, i) => ({...box, layers: groups[i]}));
  document.querySelectorAll("[data-for]").forEach((group) => {
    group.hidden = group.dataset.for !== (state.mode === "side" && heat ? "heat" : state.mode);
  });
  if (state.fitted && state.panes.length) fit();
  update();
}

function resize() {
  const box = byId("stage").getBoundingClientRect();
  canvas.width = Math.round(box.width * devicePixelRatio);
  canvas.height = Math.round(box.height * devicePixelRatio);
  if (state.pair) arrange();
  draw(); // at once: an emptied canvas would flash
}

// Draws with the next frame, however often it is asked for.
let frame = 0;
function update() {
  frame ||= requestAnimationFrame(() => {
    frame = 0;
    draw();
    showReadout();
    byId("boxes-text").textContent = state.showBoxes && state.pair?.heat ? boxesText() : "";
  });
}

function showReadout() {
  byId("zoom-level").textContent = view.scale < 1 ? `${Math.round(view.scale * 100)} %` : `${view.scale}×`;
  byId("at").textContent = state.cursor && state.pair ? `${state.cursor.x}, ${state.cursor.y}` : "–";
  for (const name of ["reference", "test"]) showSamples(name);
  byId("difference-value").textContent = differenceText();
}

function showSamples(name) {
  const picture = state.pair?.[name];
  const samples = state.cursor && samplesAt(picture, state.cursor.x, state.cursor.y);
  const colour = [0, 0, 0];
  if (samples) colourOf(picture, samples, 0, state.range, colour);
  byId(`${name}-colour`).style.background = samples ? `rgb(${colour})` : "transparent";
  byId(`${name}-value`).textContent =
    samples ? valueLines(picture, samples, (value) => sampleText(picture, value)).join("  ") : "–";
}

function differenceText() {
  if (!state.cursor || !state.pair?.heat) return "–";
  const {x, y} = state.cursor, {reference, heat} = state.pair, steps = differenceAt(x, y);
  if (!steps) return samplesAt(heat, x, y)?.[0] === leftOut ? "not compared" : "not in this page";
  const aside = {[movedEdge]: ", a moved edge", [belowThreshold]: ", below the threshold"};
  return valueLines(reference, steps, stepsText).join("  ") + (reference.type === "f32" ? " ulp" : "") +
    (aside[samplesAt(heat, x, y)[0]] ?? "");
}

const heatColours = manifest.heat_colours.map(packedColour);

showTitle();
paintLegend(heatColours);
setUpList();
setUpApproval();
listenToMouse();
listenToControls();
if (manifest.pairs.length) followAddress();

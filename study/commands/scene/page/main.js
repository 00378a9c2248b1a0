// The page: the chosen way to draw the scene, and the lists to choose from.

let chosen = manifest.points[0], shownWays = "front";

// Radio buttons in a fieldset, the first of them checked.
function segments(id, choices, name, onchange) {
  byId(id).append(...Object.entries(choices).map(([value, title], i) => element("label", {},
    element("input", {type: "radio", name, value, checked: i === 0, onchange: () => onchange(value)}), element("span", {}, title))));
}
const titles = (things) => Object.fromEntries(Object.entries(things).map(([name, {title}]) => [name, title]));

const wayLists = {
  front: {title: "The Pareto front", has: ({standing, knob}) => standing === "front" || knob === "none"},
  alone: {title: "Each option alone", has: ({knob}) => knob !== "several"},
  all: {title: "All", has: () => true},
};

// A way's options, each without a line break.
const optionsOf = (name) => name.split(/ (?=--)/).flatMap((option, i) => [i > 0 ? " " : "", element("span", {}, option)]);

function wayTable() {
  const points = manifest.points.filter(wayLists[shownWays].has);
  if (shownWays === "front") points.sort((a, b) => a.ns - b.ns);
  const heads = ["way", "RMS [1/255]", "largest", "wrong", "FLIP", "depth error", `${unit.name} a frame`, "quartiles", "threads", ""];
  const rows = points.map((point) => [
    element("button", {type: "button", className: "way", onclick: () => choose(point)}, ...optionsOf(point.name)),
    digits(255 * point.rms), point.largest, `${digits(100 * point.wrong)} %`, digits(point.flip), digits(point.depth_error, 2), digits(point.ns / unit.ns),
    point.ns_quartiles.map((ns) => digits(ns / unit.ns)).join(" to "), point.threads, [point.standing, point.disturbed ? "disturbed" : ""].filter(Boolean).join(", ")]);
  const kinds = heads.map((head, i) => i > 0 && i < heads.length - 1 ? "number" : "");
  return table(heads, kinds, rows, (i) => points[i] === chosen ? "chosen" : points[i].standing ?? "");
}

function showTable() {
  byId("table").replaceChildren(wayTable());
}

function choose(point) {
  chosen = point;
  byId("way-title").textContent = point.name;
  byId("facts").replaceChildren(...terms([
    ["RMS error", `${digits(255 * point.rms)}/255, at most ${point.largest}/255`],
    ["Pixels off by more than 8/255", `${digits(100 * point.wrong)} %`],
    ["FLIP", digits(point.flip)],
    ["Largest depth error", `${digits(point.depth_error, 2)} of the distance`],
    ["A frame", `${timeText(point.ns)}, quartiles ${point.ns_quartiles.map(timeText).join(" and ")}, ${count(point.threads, "thread")}`],
  ]));
  byId("way-command").textContent = point.command;
  showStage(point);
  showTable();
  drawCharts();
}

function toggle(id, onchange) {
  byId(id).addEventListener("click", ({currentTarget}) => {
    currentTarget.ariaPressed = String(currentTarget.ariaPressed !== "true");
    onchange(currentTarget.ariaPressed === "true");
  });
}

byId("title").textContent = `${manifest.scene}: what accuracy costs`;
byId("summary").textContent = `${width} x ${height}; ${count(manifest.points.length, "way")}, ${count(manifest.pictures, "picture")}; ${manifest.machine}`;
byId("chart").append(chart("Error against time of each way; the table below has the same numbers", errorChart));
segments("measures", titles(measures), "measure", (name) => { shownMeasure = name; drawCharts(); });
segments("views", titles(views), "view", (name) => { shownView = name; byId("flicker").ariaPressed = "false"; showStage(chosen); });
segments("shown", titles(wayLists), "ways", (name) => { shownWays = name; showTable(); });
toggle("flicker", () => showStage(chosen));
toggle("size", (every) => byId("stage").classList.toggle("every", every));
byId("left-out-title").hidden = manifest.left_out.length === 0;
byId("left-out").append(...manifest.left_out.flatMap(({knob, why}) => [element("dt", {}, knobs[knob]), element("dd", {}, why)]));
byId("origin").append(...terms([["Reference", `the picture ${manifest.reference}`],
  ["Positions", `largest error ${digits(manifest.position_error_px)} px, over ${count(manifest.vertices, "vertex").replace("vertexs", "vertices")}, compared with 50 digits`],
  ["Times", `medians of ${manifest.repetitions} frames; processor time for one thread`],
  ["Machine", manifest.machine], ["Compiler", manifest.compiler], ["Flags", manifest.flags], ["Glassbox", manifest.version]]));
byId("command").textContent = manifest.command;
setUpEyes();
choose(chosen);

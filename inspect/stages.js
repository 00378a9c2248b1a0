// The stages, with what went in, what came out and how long it took, and the title of the page.

// For each part of a stage's output: the number, its name, and the function that chooses the next
// one (null: they are not in the page).
function stageRows({stages: s}) {
  const whole = s.triangles - s.degenerate - s.rejected - s.clipped_away - s.clipped;
  return [
    ["Assembly", `${count(s.instances, "instance")}`, s.triangles, "triangles", s.ms.prepare, [[s.degenerate, "without area", null]]],
    ["Vertices", s.vertices, s.vertices, "in clip space", s.ms.vertices, []],
    ["Clipping", s.triangles - s.degenerate, s.after_clipping, "triangles", null,
      [[whole, "whole", untouched], [s.clipped, "cut", withMark(marks.cut)],
        [s.rejected, "outside one plane", withMark(marks.rejected)], [s.clipped_away, "clipped away", withMark(marks.clippedAway)]]],
    ["Setup, culling", s.after_clipping, s.set_up, "set up", s.ms.triangles,
      [[s.culled, "culled", withMark(marks.culled)], [s.zero_area, "no area", withMark(marks.zeroArea)]]],
    ["Coverage", s.set_up, s.covered, "fragments", null, []],
    ["Depth test", s.covered, s.covered - s.depth_failed, "in front", null, [[s.depth_failed, "hidden", withFate("hidden")]]],
    ["Colour", s.covered - s.depth_failed, s.written, "written", s.ms.fragments,
      [[s.discarded, "discarded", withFate("discarded")], [s.blended, "blended", withFate("blended")]]],
  ];
}

const numberText = (value) => (typeof value === "number" ? value.toLocaleString("en") : value);

function partElement(stage, [number, label, choose]) {
  const text = `${number.toLocaleString("en")} ${label}`;
  if (!choose) return element("small", {className: "part"}, text);
  return element("button", {type: "button", className: "part", title: "go to the next of them",
    onclick: () => goToNext(stage, label, choose)}, text);
}

function showStages() {
  const {facts} = state.runs[0];
  byId("stages").replaceChildren(...stageRows(facts).map(([name, into, out, what, ms, parts]) => {
    const item = element("li", {},
      element("button", {type: "button", className: "stage", title: `show ${name.toLowerCase()} of the chosen triangle`,
        onclick: () => goToStage(name)}, name),
      ms === null ? null : element("small", {}, ` ${ms.toFixed(1)} ms`),
      element("span", {className: "flow"}, `${numberText(into)} → ${numberText(out)} ${what}`),
      ...parts.filter(([number]) => number).map((part) => partElement(name, part)));
    item.dataset.stage = name;
    return item;
  }));
}

// Marks the stage and the step that the page shows.
function markStop() {
  const stage = stops.find(({step}) => step === state.stop)?.stage;
  for (const item of byId("stages").children) {
    if (item.dataset.stage === stage) item.setAttribute("aria-current", "step");
    else item.removeAttribute("aria-current");
  }
  sectionOf(state.stop)?.setAttribute("aria-current", "step");
}

function showTitle() {
  const {facts, fragmentCount, triangleCount} = state.runs[0];
  document.title = `${facts.scene} · glassbox inspect`;
  byId("title").textContent = facts.scene;
  byId("summary").textContent = `${facts.width} × ${facts.height} · ${count(triangleCount, "triangle")} · ` +
    `${count(fragmentCount, "fragment")}` + (facts.rectangle ? ` · only pixels ${rectangleText(facts.rectangle)}` : "");
  byId("command").textContent = facts.command;
  byId("program").textContent = facts.program;
}
const rectangleText = ([x0, y0, x1, y1]) => `(${x0}, ${y0}) to (${x1 - 1}, ${y1 - 1})`;

// The stages, with what went in, what came out and how long it took; and what the page is of.

function stageRows({stages: s, draws}) {
  const whole = s.triangles - s.degenerate - s.rejected - s.clipped_away - s.clipped;
  return [
    ["Assembly", `${count(s.instances, "instance")}`, s.triangles, "triangles", s.ms.prepare, [[s.degenerate, "without area"]]],
    ["Vertices", s.vertices, s.vertices, "in clip space", s.ms.vertices, []],
    ["Clipping", s.triangles - s.degenerate, s.after_clipping, "triangles", null,
      [[whole, "whole"], [s.clipped, "cut"], [s.rejected, "outside one plane"], [s.clipped_away, "clipped away"]]],
    ["Setup, culling", s.after_clipping, s.set_up, "set up", s.ms.triangles, [[s.culled, "culled"], [s.zero_area, "no area"]]],
    ["Coverage", s.set_up, s.covered, "fragments", null, []],
    ["Depth test", s.covered, s.covered - s.depth_failed, "in front", null, [[s.depth_failed, "hidden"]]],
    ["Colour", s.covered - s.depth_failed, s.written, "written", s.ms.fragments,
      [[s.discarded, "discarded"], [s.blended, "blended"]]],
  ];
}

const numberText = (value) => (typeof value === "number" ? value.toLocaleString("en") : value);

function showStages() {
  const {facts} = state.runs[0];
  byId("stages").replaceChildren(...stageRows(facts).map(([name, into, out, what, ms, parts]) =>
    element("li", {},
      element("b", {}, name), ms === null ? null : element("small", {}, ` ${ms.toFixed(1)} ms`),
      element("span", {className: "flow"}, `${numberText(into)} → ${numberText(out)} ${what}`),
      ...parts.filter(([number]) => number).map(([number, label]) =>
        element("small", {className: "part"}, `${number.toLocaleString("en")} ${label}`)))));
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

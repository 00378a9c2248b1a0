// Matrices, and the parameters that they are made of.

function opened(name, id, ...content) {
  const details = element("details", {className: "opens", id}, element("summary", {}, name), ...content);
  details.open = state.open.has(id);
  details.addEventListener("toggle", () => state.open[details.open ? "add" : "delete"](id));
  return details;
}

const parameter = (name, text) => [element("dt", {}, name), element("dd", {}, text)];
const parameters = (...pairs) => element("dl", {}, ...pairs.flatMap(([name, text]) => parameter(name, text)));
const vectorText = (v) => `(${v.map((value) => doubleText(Number(value.toPrecision(9)))).join(", ")})`;
const distanceText = (value) => (value === "inf" ? "∞" : doubleText(value));

function modelMatrix(draw) {
  const lengths = [0, 1, 2].map((k) => Math.hypot(...[0, 1, 2].map((row) => draw.world_from_object[4 * row + k])));
  return opened("Model matrix: world from object", "model",
    matrixTable("world from object", draw.world_from_object, "double"),
    parameters(["moves the origin to", vectorText([3, 7, 11].map((at) => draw.world_from_object[at]))],
      ["lengths of its columns", vectorText(lengths)], ["mirrors", draw.mirrored ? "yes: front faces run clockwise" : "no"]),
    element("p", {}, draw.nodes.length > 1 ? "The product of its nodes, from the root:" : "From its node:"),
    ...draw.nodes.map((node, i) => matrixTable(node.name || `node ${i}`, node.matrix, "double")));
}

// UVN: the rows are the camera's axes, and the last column is minus the eye's coordinates along
// them.
function viewMatrix({camera: {name, eye, gaze, up, right}, view, options}) {
  const axes = [...right, 0, ...up, 0, ...gaze.map((value) => -value + 0), 0, 0, 0, 0, 1];
  const moved = [1, 0, 0, -eye[0], 0, 1, 0, -eye[1], 0, 0, 1, -eye[2], 0, 0, 0, 1].map((value) => value + 0);
  return opened("View matrix: eye from world", "view-matrix",
    matrixTable("eye from world = R · T", view.eye_from_world, "double"),
    parameters(["camera", name || "without a name"], ["eye", vectorText(eye)], ["gaze", vectorText(gaze)], ["up", vectorText(up)],
      ...givenParameters(options, ["--eye", "--look-at", "--up", "--camera"])),
    matrixTable("R: right, up and minus the gaze as rows", axes, "double"),
    matrixTable("T: the eye moves to the origin", moved, "double"));
}
function givenParameters(words, names) {
  return words.flatMap((word, i) => (names.includes(word) ? [[`asked for: ${word}`, words[i + 1]]] : []));
}

function projectionMatrix({camera: {lens}, view, options, width, height}) {
  const {kind, near, far, ...others} = lens, named = {fovy_degrees: "vertical angle of view, degrees", half_height: "half of the visible height"};
  return opened("Projection matrix: clip from eye", "projection",
    matrixTable("clip from eye", view.clip_from_eye, "double"),
    parameters(["kind", kind], ...Object.entries(others).map(([key, value]) => [named[key] ?? key, doubleText(value)]),
      ["near", distanceText(near)], ["far", distanceText(far)], ["aspect", `${width} / ${height} = ${doubleText(width / height)}`],
      ["depth", view.reversed ? "1 at the near plane, 0 at the far one" : "0 at the near plane, 1 at the far one"],
      ...givenParameters(options, ["--fov", "--ortho", "--frustum", "--near", "--far"])),
    element("p", {}, options.includes("--proj")
      ? "Your projection, converted to Glassbox's clip space: z runs from 0 to w, y points up, and w is the distance along the gaze."
      : formulaOf(lens, view)));
}
function formulaOf({kind, far}, {reversed}) {
  const depth = reversed ? "n/(f−n) and n·f/(f−n)" : far === "inf" ? "−1 and −n" : "−f/(f−n) and −n·f/(f−n)";
  if (kind === "perspective") return `The diagonal is cot(angle/2)/aspect and cot(angle/2); the third row ${depth}; w is −z, the distance along the gaze.`;
  if (kind === "frustum") return `The diagonal is 2n/(right−left) and 2n/(top−bottom); the third row ${depth}; w is −z, the distance along the gaze.`;
  return "The diagonal is 1/half width, 1/half height; w is 1.";
}

function composedMatrix(draw) {
  const anchored = draw.anchor.some((value) => value !== 0);
  return opened("The matrix that the run applies: clip from object, in float", "composed",
    matrixTable("clip from object", draw.clip_from_anchored, "float"),
    element("p", {}, "Projection · view · model in double, rounded to float once" +
      (anchored ? `, for positions minus the anchor ${vectorText(draw.anchor)}.` : ".")));
}

function viewportMatrix({view: {viewport: [left, top, right, bottom]}}) {
  const m = [(right - left) / 2, 0, 0, (right + left) / 2, 0, (top - bottom) / 2, 0, (top + bottom) / 2, 0, 0, 1, 0, 0, 0, 0, 1];
  return opened("Viewport: screen from NDC", "viewport", matrixTable("screen from NDC", m, "float"),
    parameters(["left, right", `${left}, ${right} pixels`], ["top, bottom", `${top}, ${bottom} pixels`], ["y", "runs downwards"]));
}

// The report, laid out.

const shortNumber = (value) => value === null || value === undefined ? "–" : Number(value.toPrecision(4)).toString().replace("-", "−");

function legend() {
  const bar = element("i", {ariaHidden: "true"});
  bar.style.background = `linear-gradient(to right, ${ramp.join(", ")})`;
  const parts = [];
  if (constraint) parts.push(element("span", {className: "ramp"}, "inliers: 0 px", bar, `${manifest.threshold_px} px`));
  const mark = svg("svg", {viewBox: "-1 -1 2 2", "aria-hidden": "true"}, svg("path", {d: cross(0, 0, .7), class: "mark", stroke: farColour}));
  parts.push(element("span", {}, mark, constraint ? "farther than that" : "not an inlier"));
  const dashed = svg("svg", {viewBox: "0 0 24 8", class: "dashed", "aria-hidden": "true"}, svg("path", {d: "M0 4H24", stroke: farColour, "stroke-width": 2, "stroke-dasharray": "5 4"}));
  parts.push(element("span", {}, dashed, "connection of one that is not an inlier"));
  if (manifest.all_matches > matches.length) parts.push(element("span", {}, `The first ${matches.length} of ${manifest.all_matches} matches.`));
  return parts;
}

function foundTerms() {
  const {system, truth, found, inliers, samples, law, estimator, all_matches: all, pair_is: kind, left_pixels: fates} = manifest, {outliers} = truth ?? {};
  return terms([
    ["pair", manifest.pair],
    ["left pixels", fates && `${fates.seen} are visible in the right picture, ${fates.hidden} hidden there, ${fates.beside} outside it, ${fates.missing} missing`],
    ["corners", found && `${found.corners_left} in the left picture, ${found.corners_right} in the right one (${found.detector})`],
    ["matches", found && `${all}: ${found.rules}`],
    ["the pair is", kind.sentence],
    ["inliers", `${inliers} of ${all} within ${manifest.threshold_px} px` + (outliers?.planted ? `; ${outliers.planted} outliers were added, ${outliers.kept} of them are inliers by chance, ${outliers.lost_matches} true matches are rejected` : "")],
    ["samples", samples ? `${samples} of ${estimator}; ${law}` : "none determines a model"],
    ["equations", `rank ${system.rank} (8 determine F, 9 is due to noise); condition ${shortNumber(system.condition_raw)} raw, ${shortNumber(system.condition_normalised)} with normalised points`],
    ["costs (GRIC)", `constraint ${shortNumber(kind.cost_of_constraint)}, homography ${shortNumber(kind.cost_of_homography)}, rotation ${shortNumber(kind.cost_of_rotation)}`],
    ["model", manifest.model && `${manifest.model.name}: ${manifest.model.why}`],
    ["two poses", manifest.model?.poses],
    ["truth", typeof truth?.rotation_error_degrees === "number" && `rotation off by ${shortNumber(truth.rotation_error_degrees)}°` + (truth.direction_error_degrees === null ? "" : `, direction of T by ${shortNumber(truth.direction_error_degrees)}°`)],
  ]);
}

function residualsTable() {
  const rows = [["Sampson's distance", manifest.residuals.sampson], ["to epipolar lines", manifest.residuals.epipolar]].map(([name, one]) =>
    [name, ...["rms_px", "median_px", "largest_px"].map((key) => shortNumber(one[key]))]);
  return table(["inliers' residuals, px", "rms", "median", "largest"], ["", "number", "number", "number"], rows);
}

// A matrix whose columns are equally wide, however small its entries.
function matrixText(rows, digits) {
  const texts = rows.map((row) => row.map((value) => digits === undefined ? value.toExponential(3) : (Math.round(value * 10 ** digits) / 10 ** digits + 0).toFixed(digits)));
  const widest = Math.max(...texts.flat().map((text) => text.length));
  return texts.map((row) => row.map((text) => text.padStart(widest)).join("  ")).join("\n").replaceAll("-", "−");
}

function matrices() {
  const {F, E, E_of_shift: other, pose, second_pose: second} = manifest, all = [];
  const add = (name, text) => all.push(element("div", {}, element("h3", {}, name), element("pre", {}, text)));
  if (F) add("F, between pixels: p_rᵀ F p_l = 0", matrixText(F));
  if (E) add("E = R S, P_r = R (P_l − T)", matrixText(E, 6));
  if (other) add("[t]× R, P_r = R P_l + t, t = −R T", matrixText(other, 6));
  if (pose) {
    add("R", matrixText(pose.R, 6));
    add("T, of length 1: the right camera, seen from the left one", matrixText([pose.T], 6));
  }
  if (second) {
    add("R of the second pose, which is possible too", matrixText(second.R, 6));
    add("T of the second pose", matrixText([second.T], 6));
  }
  return all.length ? all : [element("p", {}, "Not determined: see what is left out.")];
}

const vectorText = (vector) => `(${vector.map((value) => (Math.round(value * 1000) / 1000 + 0).toFixed(3).replace("-", "−")).join(", ")})`;

function posesTable() {
  const rows = manifest.four_poses.map((pose) => [vectorText(pose.T), shortNumber(turnOf(pose.R)) + "°", pose.in_front]);
  return table(["four poses: T", "rotation", "in front of both"], ["", "number", "number"], rows, (at) => manifest.four_poses[at].chosen ? "chosen" : "");
}

// The angle of a rotation, whose trace is 1 + 2 cos(angle).
const turnOf = (r) => Math.acos(clamp((r[0][0] + r[1][1] + r[2][2] - 1) / 2, -1, 1)) * 180 / Math.PI;

document.title = `${manifest.about}: glassbox views geometry`;
byId("title").textContent = manifest.about;
byId("summary").textContent = `${count(manifest.all_matches, "match").replace("matchs", "matches")}, ${manifest.pair_is.kind}`;
setUpPictures();
byId("legend").append(...legend());
byId("found").append(...foundTerms());
if (manifest.residuals) byId("residuals").append(residualsTable());
byId("matrices").append(...matrices());
if (manifest.four_poses.length) byId("poses").append(posesTable());
byId("left-out").append(...manifest.left_out.map(({what, why}) => element("li", {}, element("strong", {}, what), `: ${why}`)));
byId("program").textContent = manifest.program;
byId("command").textContent = manifest.command;

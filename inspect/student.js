// A run in which a student's functions took part (glassbox lab render): their records next to the
// reference's.

function showStudent(run) {
  const {student} = run.facts;
  byId("student").hidden = !student;
  if (!student) return;
  const head = element("tr", {}, ...["Stage", "Records", "Wrong"].map((name) => element("th", {scope: "col"}, name)));
  const rows = student.stages.map(({name, functions, records, wrong}) => element("tr", {className: wrong ? "wrong" : ""},
    element("td", {title: functions}, name), element("td", {}, records.toLocaleString("en")), element("td", {}, wrong.toLocaleString("en"))));
  byId("student-stages").replaceChildren(head, ...rows);
  const pixel = student.first_pixel, record = student.records.find(({wrong, triangle}) => wrong && run.rowOf.has(triangle));
  const rounding = student.stages.every(({wrong}) => !wrong) ? " Every record is within its bound: the differences are rounding." : "";
  byId("student-note").textContent = pixel ? `${count(student.differing_pixels, "pixel")} differ from the reference.${rounding}` : "Every pixel is equal to the reference.";
  byId("student-pixel").hidden = !pixel;
  byId("student-pixel").onclick = () => { choosePixel(pixel.x, pixel.y); };
  byId("student-record").hidden = !record;
  byId("student-record").onclick = () => chooseTriangle(record.triangle);
  run.recordsOf = Map.groupBy ? Map.groupBy(student.records, ({triangle}) => triangle) : groupedBy(student.records);
}

function groupedBy(records) {
  const groups = new Map();
  for (const record of records) groups.set(record.triangle, [...(groups.get(record.triangle) ?? []), record]);
  return groups;
}

// The student's answers for the triangle and for the whole scene, the wrong ones first.
function studentSections(run, triangle) {
  if (!run.recordsOf) return [];
  const records = [...(run.recordsOf.get(null) ?? []), ...(triangle === null ? [] : run.recordsOf.get(triangle) ?? [])];
  if (!records.length) return [step("student", "Your values and the reference", element("p", {className: "quiet"}, "The page has no record of this triangle."))];
  const ordered = [...records.filter(({wrong}) => wrong), ...records.filter(({wrong}) => !wrong)];
  return ordered.map((record) => recordSection(run, record));
}

function recordSection(run, {stage, triangle, record, yours, reference, wrong}) {
  const {name, functions} = run.facts.student.stages[stage], differs = yours.some((value, i) => value !== reference[i]) || yours.length !== reference.length;
  const place = triangle === null ? `record ${record}` : `triangle ${triangle}`;
  const number = (value) => element("td", {}, value === undefined ? "–" : value === null ? "not a number" : doubleText(value));
  const rows = Array.from({length: Math.max(yours.length, reference.length)}, (_, i) => element("tr", {className: yours[i] === reference[i] ? "" : "differs"},
    element("td", {}, String(i)), number(yours[i]), number(reference[i])));
  const table = element("table", {className: "answers"}, element("tr", {}, ...["", "yours", "reference"].map((word) => element("th", {scope: "col"}, word))), ...rows);
  return step("student", `${name} of ${place}`, element("p", {className: "quiet"}, functions),
    wrong ? element("p", {className: "wrong"}, wrongText(wrong)) :
      element("p", {className: "quiet"}, differs ? "Different from the reference, but within its bound." : "Equal to the reference, to the bit."),
    opened(`${count(yours.length, "number")}${yours.length >= 48 ? " and more" : ""}`, `student-${stage}-${record}`, table));
}

function wrongText({element: what, yours, reference, bound, unit, explanation}) {
  const shown = (value) => value === null ? "not a number" : doubleText(value);
  return `${what}: yours ${shown(yours)}, reference ${shown(reference)}` +
    (explanation ? `: ${explanation}.` : `; at most ${shortNumber(bound)}${unit ? ` ${unit}` : ""} apart is allowed.`);
}

// Shows one of the pictures that the page has in addition to the run's.
function paintOther(name) {
  return ({run}, data) => {
    if (run.others[name]) data.set(run.others[name]);
    return {};
  };
}

// Marks where the finished pictures differ.
function paintParts({run}, data) {
  const {reference, made} = run.others, yours = made ?? data.slice();
  if (made) data.set(made);
  let pixels = 0;
  darken(data);
  for (let pixel = 0; reference && pixel < run.width * run.height; pixel++) {
    if ([0, 1, 2].every((k) => yours[4 * pixel + k] === reference[4 * pixel + k])) continue;
    pixels++;
    setPixel(data, pixel, [217, 95, 2]);
  }
  return {pixels};
}

// Tables and lists of terms.

// `kinds` has a class for each column: "number", "words" or "". `mark` gives a row's.
function table(heads, kinds, rows, mark = () => "") {
  const cell = (tag, text, i) => element(tag, {className: kinds[i], ...(tag === "th" ? {scope: "col"} : {})},
    ...(text instanceof Node ? [text] : [String(text)]));
  return element("table", {}, element("thead", {}, element("tr", {}, ...heads.map((head, i) => cell("th", head, i)))),
    element("tbody", {}, ...rows.map((row, at) => element("tr", {className: mark(at)}, ...row.map((text, i) => cell("td", text, i))))));
}

// A term and its text in turn, without those that have none.
const terms = (pairs) => pairs.filter(([, text]) => text).flatMap(([term, text]) => [element("dt", {}, term), element("dd", {}, text)]);

// Makes tables and lists of terms.

// Makes a table. `kinds` has a class for each column: "number", "words" or "". `mark` returns a
// row's class.
function table(heads, kinds, rows, mark = () => "") {
  const cell = (tag, text, i) => element(tag, {className: kinds[i], ...(tag === "th" ? {scope: "col"} : {})},
    ...(text instanceof Node ? [text] : [String(text)]));
  return element("table", {}, element("thead", {}, element("tr", {}, ...heads.map((head, i) => cell("th", head, i)))),
    element("tbody", {}, ...rows.map((row, at) => element("tr", {className: mark(at)}, ...row.map((text, i) => cell("td", text, i))))));
}

// Terms and their texts alternately, without terms that have no text.
const terms = (pairs) => pairs.filter(([, text]) => text).flatMap(([term, text]) => [element("dt", {}, term), element("dd", {}, text)]);

// Writes numbers as text, and makes tables of them.

const doubleText = (value) => (Number.isFinite(value) ? String(value === 0 ? 0 : value).replace("-", "−") : floatText(value));
const boundText = (bound) => (bound === undefined ? "" : bound === 0 ? "exact" : Number.isFinite(bound) ? `± ${bound.toExponential(1).replace("-", "−")}` : "± ∞");

const hexOf = (bits, digits) => bits.toString(16).padStart(digits, "0");
function floatHex(value) {
  return "0x" + hexOf(bitsOfFloat(value), 8);
}
function doubleHex(value) {
  bitStore.setFloat64(0, value);
  return "0x" + hexOf(bitStore.getUint32(0), 8) + hexOf(bitStore.getUint32(4), 8);
}

const kinds = {
  float: {text: floatText, hex: floatHex},
  double: {text: doubleText, hex: doubleHex},
  integer: {text: (value) => value.toLocaleString("en").replace("-", "−"), hex: (value) => (value < 0 ? "−0x" : "0x") + Math.abs(value).toString(16)},
};

// A table of named numbers: {name, value, kind, bound, other}, where `other` is the second run's
// number if there is one.
function numbersTable(caption, rows) {
  const compared = rows.some(({other}) => other !== undefined), bounded = rows.some(({bound}) => bound !== undefined);
  return element("table", {className: "numbers"}, element("caption", {className: "hidden"}, caption),
    element("tbody", {}, ...rows.map(({name, value, kind, bound, other}) => {
      const {text, hex} = kinds[kind], differs = other !== undefined && !Object.is(other, value);
      return element("tr", {className: differs ? "differs" : ""}, element("th", {scope: "row"}, name),
        element("td", {}, text(value), state.hex ? element("small", {className: "bits"}, hex(value)) : null),
        bounded ? element("td", {className: "bound"}, boundText(bound)) : null,
        compared ? element("td", {className: "other"}, other === undefined ? "" : differs ? text(other) : "same") : null);
    })));
}

const letters = ["x", "y", "z", "w"];
const coordinateRows = (values, kind, bounds, others) => values.map((value, k) =>
  ({name: letters[k], value, kind, bound: bounds?.[k], other: others?.[k]}));

// Sixteen numbers, row by row.
function matrixTable(caption, m, kind) {
  const {hex} = kinds[kind];
  return element("table", {className: "matrix"}, element("caption", {}, caption),
    element("tbody", {}, ...[0, 1, 2, 3].map((row) => element("tr", {}, ...[0, 1, 2, 3].map((column) =>
      element("td", {title: hex(m[4 * row + column])}, shortMatrixText(m[4 * row + column])))))));
}
// Six digits are enough to read a matrix; the tooltip has the exact number.
const shortMatrixText = (value) => doubleText(Number(value.toPrecision(6)));

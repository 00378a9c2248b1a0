// Charts as SVG.

function svgElement(tag, attributes, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

// A minus sign that is as wide as a plus.
const signed = (value, digits) => {
  const text = Math.abs(value).toFixed(digits);
  return Number(text) === 0 ? text : (value < 0 ? "−" : "+") + text;
};

// Steps of 1, 2 or 5 times a power of ten, about `count` of them from `low` to `high`.
function ticks(low, high, count) {
  const rough = (high - low) / count, decade = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * decade).find((width) => width >= rough);
  const found = [];
  for (let i = Math.ceil(low / step); i * step <= high; i++) found.push(i * step);
  return {found, digits: Math.max(0, -Math.floor(Math.log10(step) + 1e-9))};
}

// The colour that the map has for a disparity.
function disparityColour(px) {
  const {limit, colours} = manifest.scales.disparity, middle = (colours.length - 1) / 2;
  const share = limit > 0 ? clamp(px / limit, -1, 1) : 0;
  return colours[Math.round(middle + share * middle)];
}

// Disparities of the left eye's pixels: bars in the map's colours, striped beyond the budget.
function histogramChart() {
  const {histogram, budget_in_front_px: front, budget_behind_px: behind} = manifest.disparity;
  const {first_px: first, bin_px: bin, counts} = histogram;
  const width = 640, height = 250, left = 52, right = 16, top = 28, bottom = 46;
  const low = Math.min(first, -front, 0), high = Math.max(first + bin * counts.length, behind, 0);
  const margin = (high - low) * 0.03 || 1;
  const x = (px) => left + (px - low + margin) / (high - low + 2 * margin) * (width - left - right);
  const all = counts.reduce((sum, one) => sum + one, 0), most = Math.max(...counts);
  const y = (count) => height - bottom - Math.sqrt(count / most) * (height - top - bottom);
  const beyond = (px) => px < -front || px > behind;

  const chart = svgElement("svg", {viewBox: `0 0 ${width} ${height}`, role: "img",
    "aria-label": `Histogram: ${all} pixels between ${signed(first, 1)} and ${signed(first + bin * counts.length, 1)} px of parallax, the budget from ${signed(-front, 1)} to ${signed(behind, 1)} px`},
  svgElement("defs", {}, svgElement("pattern", {id: "stripes", width: 6, height: 6, patternUnits: "userSpaceOnUse", patternTransform: "rotate(45)"},
    svgElement("rect", {width: 3, height: 6, fill: "#141414"}))));
  counts.forEach((count, i) => {
    if (!count) return;
    const at = {x: x(first + i * bin), y: y(count), width: Math.max(x(bin) - x(0), 1), height: y(0) - y(count), class: "bar"};
    const middle = first + (i + 0.5) * bin;
    chart.append(svgElement("rect", {...at, fill: disparityColour(middle)},
      svgElement("title", {}, `${(first + i * bin).toPrecision(4)} to ${(first + (i + 1) * bin).toPrecision(4)} px: ${(100 * count / all).toFixed(2)} %`)));
    if (beyond(middle)) chart.append(svgElement("rect", {...at, fill: "url(#stripes)"}));
  });
  chart.append(svgElement("line", {x1: left, x2: width - right, y1: y(0), y2: y(0), class: "axis"}));
  for (const share of [0.25, 1]) {
    const text = svgElement("text", {x: left - 6, y: y(share * most) + 5, "text-anchor": "end"}, `${(100 * share * most / all).toPrecision(2)} %`);
    chart.append(text, svgElement("line", {x1: left - 3, x2: left, y1: y(share * most), y2: y(share * most), class: "axis"}));
  }
  const {found, digits} = ticks(low - margin, high + margin, 7);
  for (const px of found) {
    chart.append(svgElement("line", {x1: x(px), x2: x(px), y1: y(0), y2: y(0) + 4, class: "axis"}),
      svgElement("text", {x: x(px), y: y(0) + 20, "text-anchor": "middle"}, signed(px, digits)));
  }
  chart.append(svgElement("line", {x1: x(0), x2: x(0), y1: top - 4, y2: y(0), class: "window"}));
  const percent = manifest.disparity.budget_percent;
  for (const [px, anchor, text] of [[-front, "start", `−${percent} %`], [behind, "end", `+${percent} %`]]) {
    const outside = anchor === "start" ? x(px) - left > 60 : width - right - x(px) > 60;
    chart.append(svgElement("line", {x1: x(px), x2: x(px), y1: top - 4, y2: y(0), class: "limit"}),
      svgElement("text", {x: x(px), y: top - 9, "text-anchor": outside ? "middle" : anchor, class: "limit-text"}, text));
  }
  chart.append(svgElement("text", {x: (left + width - right) / 2, y: height - 4, "text-anchor": "middle"},
    "in front ←  parallax, px  → behind"));
  return chart;
}

// Mean rivalry against mean colour difference of what recolouring can reach.
function compromiseChart() {
  const {recolour, target_rivalry: target} = manifest.anaglyph, {curve} = recolour;
  const width = 640, height = 300, left = 60, right = 20, top = 16, bottom = 50;
  const highX = Math.max(...curve.map((one) => one.ciede2000), recolour.ciede2000) || 1;
  const highY = Math.max(...curve.map((one) => one.rivalry), target) || 1;
  const x = (value) => left + value / highX * (width - left - right);
  const y = (value) => height - bottom - value / highY * (height - top - bottom);
  const chart = svgElement("svg", {viewBox: `0 0 ${width} ${height}`, role: "img",
    "aria-label": `Rivalry falls from ${curve[0].rivalry.toFixed(3)} while the colour difference grows to ${highX.toFixed(1)}`},
  svgElement("line", {x1: left, x2: width - right, y1: y(0), y2: y(0), class: "axis"}),
  svgElement("line", {x1: left, x2: left, y1: top, y2: y(0), class: "axis"}),
  svgElement("line", {x1: left, x2: width - right, y1: y(target), y2: y(target), class: "limit"}),
  svgElement("text", {x: width - right, y: y(target) - 6, "text-anchor": "end", class: "limit-text"}, `aimed at ${target}`),
  svgElement("polyline", {points: curve.map((one) => `${x(one.ciede2000)},${y(one.rivalry)}`).join(" "), class: "line"}));
  for (const one of curve) chart.append(svgElement("circle", {cx: x(one.ciede2000), cy: y(one.rivalry), r: 3.5, class: "dot"},
    svgElement("title", {}, `desaturated ${one.desaturate.toFixed(2)}, brightened ${one.brighten.toFixed(2)}: rivalry ${one.rivalry.toFixed(3)}, difference ${one.ciede2000.toFixed(1)}`)));
  chart.append(svgElement("circle", {cx: x(recolour.ciede2000), cy: y(recolour.rivalry), r: 7, class: "mark"}));
  for (const [axis, high] of [["x", highX], ["y", highY]]) {
    const {found, digits} = ticks(0, high, 5);
    for (const value of found) {
      chart.append(axis === "x"
        ? svgElement("text", {x: x(value), y: y(0) + 20, "text-anchor": "middle"}, value.toFixed(digits))
        : svgElement("text", {x: left - 8, y: y(value) + 5, "text-anchor": "end"}, value.toFixed(digits)));
    }
  }
  chart.append(svgElement("text", {x: (left + width - right) / 2, y: height - 6, "text-anchor": "middle"}, "mean colour difference, CIEDE2000"),
    svgElement("text", {transform: `translate(15 ${(top + height - bottom) / 2}) rotate(-90)`, "text-anchor": "middle"}, "mean rivalry"));
  return chart;
}

// The sums of costs at the cursor's pixel, for every disparity. The smallest one wins.

const plot = {width: 640, height: 300, left: 62, right: 14, top: 30, bottom: 46};

const placeOf = (disparity) => plot.left + (disparity - range[0]) / Math.max(range[1] - range[0], 1) * (plot.width - plot.left - plot.right);

// Three to eight round numbers in the range.
function ticksOf(low, high) {
  const rough = (high - low) / 6 || 1, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((each) => each >= rough), all = [];
  for (let at = Math.ceil(low / step) * step; at <= high + 1e-9; at += step) all.push(at);
  return all;
}

function axes(greatest) {
  const bottom = plot.height - plot.bottom, heightOf = (sum) => bottom - sum / greatest * (bottom - plot.top);
  const across = ticksOf(...range).flatMap((at) => [svg("path", {class: "axis", d: `M${placeOf(at)} ${bottom}v5`}),
    svg("text", {x: placeOf(at), y: bottom + 21, "text-anchor": "middle"}, shortNumber(at))]);
  const up = ticksOf(0, greatest).flatMap((at) => [svg("path", {class: "axis", d: `M${plot.left} ${heightOf(at)}H${plot.width - plot.right}`}),
    svg("text", {x: plot.left - 8, y: heightOf(at) + 5, "text-anchor": "end"}, shortNumber(at))]);
  return [...up, ...across, svg("text", {x: plot.width - plot.right, y: plot.height - 5, "text-anchor": "end"}, "disparity, px"),
    svg("text", {x: 4, y: 16}, "sum of costs")];
}

function markOf(kind, name, disparity, above) {
  if (!Number.isFinite(disparity) || disparity < range[0] - .5 || disparity > range[1] + .5) return [];
  const x = placeOf(disparity), atEnd = x > plot.width - 130;
  return [svg("path", {class: kind, d: `M${x} ${plot.top}V${plot.height - plot.bottom}`}),
    svg("text", {class: `${kind}-name`, x: x + (atEnd ? -6 : 6), y: plot.top + (above ? -2 : 15), "text-anchor": atEnd ? "end" : "start"}, `${name} ${pixelText(disparity)}`)];
}

function drawCurve(i) {
  if (!data.sums) return;
  const all = range[1] - range[0] + 1, sums = Array.from(data.sums.subarray(i * all, (i + 1) * all)), step = manifest.sums_step;
  const sought = sums.map((sum, at) => [range[0] + at, sum]).filter(([, sum]) => sum !== 255);
  const greatest = Math.max(...sought.map(([, sum]) => sum * step), step), bottom = plot.height - plot.bottom;
  const points = sought.map(([at, sum]) => `${placeOf(at).toFixed(1)},${(bottom - sum * step / greatest * (bottom - plot.top)).toFixed(1)}`);
  const name = `Sums of costs at pixel ${cursor.x}, ${cursor.y}`;
  byId("curve").replaceChildren(svg("svg", {viewBox: `0 0 ${plot.width} ${plot.height}`, role: "img", "aria-label": name}, ...axes(greatest),
    ...(points.length ? [svg("polyline", {class: "sums", points: points.join(" ")})] : []),
    ...markOf("found", "found", data.disparity[i], true), ...(hasTruth ? markOf("truth", "true", data.truth[i], false) : [])));
}

// Keeps letters the same size: the drawing is as wide as its place on the page.
function fitCurve() {
  plot.width = clamp(byId("curve").clientWidth, 280, 1200);
  drawCurve(cursor.y * width + cursor.x);
}

function setUpCurve() {
  new ResizeObserver(fitCurve).observe(byId("curve"));
  byId("curve-note").textContent = data.sums
    ? `The sum of all paths' costs for each disparity (in steps of ${manifest.sums_step}). The smallest sum wins; a second valley of the same depth makes the match uncertain. Where there is no line, the other pixel is outside the right picture.`
    : "The sums of so many pixels and disparities would be too large for a page: give smaller pictures or a shorter --range.";
}

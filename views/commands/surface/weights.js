// The weights of the pictures around a direction, computed as in the program
// (views/texture/view_sphere.cpp).

const {textures} = manifest;
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => { const length = Math.sqrt(dot(a, a)); return a.map((x) => x / length); };
const directionOf = (view) => textures.views[view].direction;

// The weights w with v = sum w_i d_i, for three directions as columns.
function inBasis(a, b, c, v) {
  const volume = dot(a, cross(b, c));
  return [dot(v, cross(b, c)) / volume, dot(v, cross(c, a)) / volume, dot(v, cross(a, b)) / volume];
}

function weightsAround(direction) {
  const shares = (views, w) => {
    const held = w.map((x) => Math.max(x, 0)), sum = held.reduce((a, b) => a + b);
    return views.map((view, i) => ({view, weight: held[i] / sum})).filter((each) => each.weight > 0);
  };
  for (const triangle of textures.triangles) {
    const w = inBasis(...triangle.map(directionOf), direction);
    if (Math.min(...w) >= -1e-12) return shares(triangle, w);
  }
  let best = [], most = -2;
  for (const edge of textures.border) {
    const [a, b] = edge.map(directionOf), ab = dot(a, b), av = dot(a, direction), bv = dot(b, direction), scale = 1 - ab * ab;
    const w = [(av - ab * bv) / scale, (bv - ab * av) / scale];
    if (!(Math.min(...w) >= 0) || !(w[0] + w[1] > 0)) continue;
    const near = dot(unit([0, 1, 2].map((k) => w[0] * a[k] + w[1] * b[k])), direction);
    if (near > most) [best, most] = [shares(edge, w), near];
  }
  textures.views.forEach((view, i) => {
    const near = dot(view.direction, direction);
    if (near > most) [best, most] = [[{view: i, weight: 1}], near];
  });
  return best;
}

// The weights of those pictures that see a polygon. If none of them does, the nearest picture that
// sees it gets all the weight.
function weightsOf(around, direction, polygon) {
  const seen = around.filter((each) => sees(each.view, polygon)), sum = seen.reduce((all, each) => all + each.weight, 0);
  if (sum > 0) return seen.map((each) => ({view: each.view, weight: each.weight / sum}));
  let best = -1, most = -2;
  textures.views.forEach((view, i) => {
    const near = dot(view.direction, direction);
    if (near > most && sees(i, polygon)) [best, most] = [i, near];
  });
  return best < 0 ? [] : [{view: best, weight: 1}];
}

// A map of all directions: the pole of +y is in the middle, and the distance from it is the angle.
function drawSphere(direction, around) {
  const canvas = byId("sphere"), side = Math.max(1, Math.round(canvas.clientWidth * Math.min(devicePixelRatio, 2)));
  canvas.width = canvas.height = side;
  const context = canvas.getContext("2d"), style = getComputedStyle(document.body);
  const place = (d) => {
    const away = Math.acos(clamp(d[1], -1, 1)) / Math.PI, along = Math.hypot(d[0], d[2]) || 1;
    return [side / 2 + d[0] / along * away * side * .48, side / 2 + d[2] / along * away * side * .48];
  };
  const line = (edge) => {
    context.beginPath();
    // A great circle between them, drawn in steps.
    for (let i = 0; i <= 12; i++) {
      const [x, y] = place(unit([0, 1, 2].map((k) => directionOf(edge[0])[k] * (1 - i / 12) + directionOf(edge[1])[k] * i / 12)));
      if (i === 0) context.moveTo(x, y); else context.lineTo(x, y);
    }
    context.stroke();
  };
  context.lineWidth = side / 300;
  context.strokeStyle = style.getPropertyValue("--line") || "#888";
  for (const t of textures.triangles) for (const edge of [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]]) line(edge);
  for (const edge of textures.border) line(edge);
  context.strokeStyle = context.fillStyle = style.getPropertyValue("--accent") || "#4a90d9";
  context.lineWidth = side / 120;
  if (around.length === 3) for (const [i, j] of [[0, 1], [1, 2], [2, 0]]) line([around[i].view, around[j].view]);
  for (const [i, view] of textures.views.entries()) {
    const [x, y] = place(view.direction), weight = around.find((each) => each.view === i)?.weight ?? 0;
    context.beginPath();
    context.arc(x, y, side * (.008 + .02 * weight), 0, 7);
    context.fill();
  }
  const [x, y] = place(direction);
  context.fillStyle = "#e2433a";
  context.beginPath();
  context.arc(x, y, side * .016, 0, 7);
  context.fill();
}

function showWeights(direction) {
  const around = weightsAround(direction), list = byId("weights");
  drawSphere(direction, around);
  list.replaceChildren(...around.map(({view, weight}) => {
    const figure = document.createElement("figure"), image = document.createElement("img"), caption = document.createElement("figcaption");
    image.src = textures.views[view].uri;
    image.alt = textures.views[view].name;
    caption.textContent = `${textures.views[view].name}: ${weight.toFixed(2)}`;
    figure.append(image, caption);
    return figure;
  }));
}

// A shape on the canvas #shape that is turned with the mouse, the wheel and the keys, and on which
// a click picks a point.

const shape = byId("shape"), shapeContext = shape.getContext("2d");
const turn = {around: .6, above: .35, nearer: 1};

// The rows of the rotation of the world: to the right, up, towards the eye.
function turnedWorld() {
  const [ca, sa, ce, se] = [Math.cos(turn.around), Math.sin(turn.around), Math.cos(turn.above), Math.sin(turn.above)];
  return [[ca, 0, -sa], [-sa * se, ce, -ca * se], [sa * ce, se, ca * ce]];
}

// `draw` draws the canvas anew. `pickAt` is called with the index (line by line) of a clicked
// pixel. `mostNear` is the largest zoom factor. Returns a function that draws with the next frame.
function setUpTurning({draw, pickAt, mostNear}) {
  let isWaiting = false, last = null, moved = 0;
  const redraw = () => {
    if (isWaiting) return;
    isWaiting = true;
    requestAnimationFrame(() => { isWaiting = false; draw(); });
  };
  const turnBy = (around, above) => {
    turn.around += around;
    turn.above = clamp(turn.above + above, -1.57, 1.57);
    redraw();
  };
  const comeNearer = (factor) => {
    turn.nearer = clamp(turn.nearer * factor, .25, mostNear);
    redraw();
  };
  shape.addEventListener("pointerdown", (event) => { last = event; moved = 0; shape.setPointerCapture(event.pointerId); });
  shape.addEventListener("pointermove", (event) => {
    if (!last) return;
    const dx = event.clientX - last.clientX, dy = event.clientY - last.clientY;
    moved += Math.abs(dx) + Math.abs(dy);
    last = event;
    turnBy(-dx / 150, dy / 150);
  });
  shape.addEventListener("pointerup", (event) => {
    if (last && moved < 4) {
      const box = shape.getBoundingClientRect();
      const x = Math.floor((event.clientX - box.left) * shape.width / box.width), y = Math.floor((event.clientY - box.top) * shape.height / box.height);
      pickAt(y * shape.width + x);
    }
    last = null;
  });
  shape.addEventListener("wheel", (event) => { event.preventDefault(); comeNearer(Math.exp(-event.deltaY / 500)); }, {passive: false});
  shape.addEventListener("keydown", (event) => {
    const step = {ArrowLeft: [.15, 0], ArrowRight: [-.15, 0], ArrowUp: [0, .15], ArrowDown: [0, -.15]}[event.key];
    if (step) turnBy(...step);
    else if (event.key === "+" || event.key === "=") comeNearer(1.2);
    else if (event.key === "-") comeNearer(1 / 1.2);
    else return;
    event.preventDefault();
  });
  addEventListener("resize", redraw);
  draw(); // at once, because a click may come before the next frame
  return redraw;
}

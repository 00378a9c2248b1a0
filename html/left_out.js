// Shows the left-out picture and the one drawn in its place alternately.

// `flicker` is {name, picture, drawn}, or nothing. `source` says what it is drawn from: "the
// voxels".
function setUpLeftOut(flicker, source) {
  byId("left-out-part").hidden = !flicker;
  if (!flicker) return;
  const image = byId("held"), button = byId("flicker");
  let isDrawn = false, timer = 0;
  const show = () => {
    image.src = isDrawn ? flicker.drawn : flicker.picture;
    image.alt = isDrawn ? `drawn from ${source}` : "the picture itself";
    byId("which").textContent = `${flicker.name}: ${isDrawn ? `drawn from ${source}, which did not have it` : "the picture itself"}`;
  };
  const change = () => { isDrawn = !isDrawn; show(); };
  byId("other").addEventListener("click", change);
  button.addEventListener("click", () => {
    button.setAttribute("aria-pressed", String(!timer));
    button.textContent = timer ? "Flicker" : "Hold";
    if (timer) clearInterval(timer);
    // Twice a second, which is slow enough to be safe for everybody.
    timer = timer ? 0 : setInterval(change, 500);
  });
  show();
}

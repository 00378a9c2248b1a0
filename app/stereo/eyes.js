// Shows one picture, or both side by side, or the two eyes alternately.

const kEyeNotes = {
  anaglyph: () => `Through ${manifest.anaglyph.glasses} glasses, the lens of the left eye first. Method: ${manifest.anaglyph.method}.`,
  left: () => "The left eye's picture.",
  right: () => "The right eye's picture.",
  pair: () => "Left and right, for parallel viewing.",
  crossed: () => "Right and left, seen by crossing the eyes."};
const kShown = {anaglyph: ["anaglyph"], left: ["left"], right: ["right"], pair: ["left", "right"], crossed: ["right", "left"]};
const kWiggleMs = 300; // an eye: below two full changes a second

const calm = matchMedia("(prefers-reduced-motion: reduce)");
let wiggling = 0;

const picture = (name, alt) => element("img", {src: manifest.pictures[name], alt, width: manifest.width, height: manifest.height, draggable: false});
const eyePictures = {
  anaglyph: picture("anaglyph", "The anaglyph of both eyes' pictures"),
  left: picture("left", "What the left eye sees"),
  right: picture("right", "What the right eye sees")};

const chosenView = () => document.querySelector("#views :checked").value;

function showEyes(view) {
  byId("shown").replaceChildren(...kShown[view].map((name) => eyePictures[name]));
  if (!wiggling) byId("shown-note").textContent = kEyeNotes[view]();
}

function chooseView(view) {
  document.querySelector(`#views [value=${view}]`).checked = true;
  showEyes(view);
}

function stopWiggling() {
  clearInterval(wiggling);
  wiggling = 0;
  byId("wiggle").setAttribute("aria-pressed", "false");
}

const otherEye = {left: "right", right: "left", pair: "crossed", crossed: "pair", anaglyph: "left"};
const swapEyes = () => chooseView(otherEye[chosenView()]);

function wiggle() {
  if (wiggling) return stopWiggling(), showEyes(chosenView());
  if (!["left", "right"].includes(chosenView())) chooseView("left");
  wiggling = setInterval(swapEyes, kWiggleMs);
  byId("wiggle").setAttribute("aria-pressed", "true");
  byId("shown-note").textContent = "The eyes in turn: whatever moves is in front of the window or behind it.";
}

function setUpEyes() {
  document.body.classList.toggle("pixels", manifest.width < 480);
  for (const radio of document.querySelectorAll("#views input")) {
    radio.addEventListener("change", () => { stopWiggling(); showEyes(radio.value); });
  }
  byId("swap").addEventListener("click", () => { stopWiggling(); swapEyes(); });
  byId("wiggle").addEventListener("click", wiggle);
  // If the user prefers reduced motion, the eyes are swapped by hand only.
  const heed = () => { byId("wiggle").hidden = calm.matches; if (calm.matches) stopWiggling(); };
  calm.addEventListener("change", heed);
  heed();
  showEyes("anaglyph");
}

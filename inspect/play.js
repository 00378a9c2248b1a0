// Playback: draws the picture again triangle by triangle, or follows the chosen triangle stage by
// stage.

const mostSeconds = 20; // for all triangles

const ways = {
  triangles: {
    name: "triangles",
    length: (run) => run.groupCount,
    seconds: (length) => Math.min(0.5, mostSeconds / length),
    // The number of groups drawn so far; at the end, playback starts again.
    position: (run) => (state.at >= run.fragmentCount ? 0 : nextGroup(run, state.at)),
    show: (run, drawn) => change(momentValues(run.groupStart[drawn])),
  },
  stages: {
    name: "stages of this triangle",
    length: () => stopsHere().length - 1,
    seconds: () => 1.6,
    position: () => {
      const here = stopsHere(), at = here.findIndex(({step}) => step === state.stop);
      return at === here.length - 1 ? 0 : Math.max(at, 0);
    },
    show: (run, i) => goToStop(stopsHere()[i]),
  },
};

// The first group that has not begun after `at` fragments. A group that is partly drawn counts as
// drawn.
function nextGroup({groupStart}, at) {
  let [low, high] = [0, groupStart.length - 1];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (groupStart[middle] < at) low = middle + 1;
    else high = middle;
  }
  return low;
}

let player = null; // what is being played: {way, from, length, seconds, began, shown}

function play() {
  const run = state.runs[0], way = ways[byId("play-what").value];
  if (way === ways.stages && state.triangle === null && state.fragment === null) chooseSomething();
  const length = way.length(run), from = way.position(run);
  if (length < 1) return say("There is nothing to play.");
  way.show(run, from);
  player = {way, from, length, seconds: way.seconds(length), began: performance.now(), shown: from};
  showPlaying();
  requestAnimationFrame(playOn);
}

function playOn(time) {
  if (!player) return;
  const {way, from, length, seconds, began, shown} = player;
  const next = Math.min(length, from + Math.max(0, Math.floor((time - began) / 1000 / seconds)));
  if (next !== shown) way.show(state.runs[0], (player.shown = next));
  if (next === length) stopPlaying();
  else requestAnimationFrame(playOn);
}

function stopPlaying() {
  if (!player) return;
  player = null;
  showPlaying();
}

function showPlaying() {
  byId("play").textContent = player ? "■ Stop" : "▶ Play";
  byId("now").ariaLive = player ? "off" : "polite"; // sixty sentences a second must not be read out
}

function listenToPlay() {
  for (const [value, {name}] of Object.entries(ways)) byId("play-what").append(element("option", {value, textContent: name}));
  byId("play").addEventListener("click", () => (player ? stopPlaying() : play()));
  byId("play-what").addEventListener("change", stopPlaying);
  showPlaying();
}

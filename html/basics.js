// Small functions that the other files use.

const byId = (id) => document.getElementById(id);
const clamp = (value, low, high) => Math.min(Math.max(value, low), high);
const colourVariable = (name) => getComputedStyle(document.documentElement).getPropertyValue(name);
const count = (number, noun) => `${number.toLocaleString("en")} ${noun}${number === 1 ? "" : "s"}`;

// Makes an element with properties and children. Strings become text, never markup, because names
// of files may contain anything.
function element(tag, properties, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children.filter((child) => child !== null));
  return made;
}

function newCanvas(width, height) {
  return element("canvas", {width, height});
}

const manifest = JSON.parse(byId("manifest").textContent);

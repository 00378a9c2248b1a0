// The pairs whose test picture is to become the reference: the page collects their names, and `glassbox diff` copies the
// pictures.

const approved = new Set(); // pairs

const mayBeApproved = ({verdict}) => verdict === "different" || verdict === "new";

// The box beside a pair in the list; nothing for a pair that cannot be approved.
function approvalBox(pair) {
  if (!mayBeApproved(pair) || !manifest.command) return null;
  const box = element("input", {type: "checkbox", disabled: Boolean(pair.not_listed), title: pair.not_listed ?? "Approve",
    ariaLabel: `Approve ${pair.name}`});
  box.onchange = () => approve([pair], box.checked);
  return element("span", {className: "approve"}, box);
}

function approve(pairs, yes) {
  for (const pair of pairs) {
    if (!mayBeApproved(pair) || pair.not_listed) continue;
    approved[yes ? "add" : "delete"](pair);
    rows.get(pair).querySelector("input").checked = yes;
  }
  showApproval();
}

function toggleApproval() {
  if (!byId("approve-label").hidden) approve([state.facts], !approved.has(state.facts));
}

// The box of the open pair, and the list of all that are approved.
function showApproval() {
  const pair = state.facts, offered = manifest.command && mayBeApproved(pair);
  byId("approve-label").hidden = !offered;
  byId("approve").disabled = Boolean(pair.not_listed);
  byId("approve").checked = approved.has(pair);
  byId("why-not-listed").textContent = offered && pair.not_listed
    ? `It cannot be approved here. ${pair.not_listed} Approve it alone: glassbox diff REFERENCE TEST --approve.` : "";
  byId("approval").hidden = !manifest.command || !manifest.pairs.some(mayBeApproved);
  byId("approved-count").textContent = approved.size ? `${count(approved.size, "pair")} approved:` :
    "No pair is approved. Approve a pair with the key A or with its box, when its test picture is right.";
  byId("approved-part").hidden = !approved.size;
  if (!approved.size) return;
  byId("approved-names").textContent = [...approved].map(({name}) => name).sort(naturally).map(listLine).join("\n");
  byId("approved-commands").replaceChildren(...approvalCommands());
}

// A name as a line of the list, in which a line that begins with # is a comment.
const listLine = (name) => (/^(#|\.\/)/.test(name) ? `./${name}` : name);

// The file that --approve-list reads.
const approvedText = () => `# glassbox diff --approve-list\n${byId("approved-names").textContent}\n`;

// A word as a POSIX shell reads it.
const shellQuoted = (word) => (/^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);
const isPlain = (word) => !/[\p{Cc}\p{Cf}\p{Zl}\p{Zp}]/u.test(word);
const longestCommand = 400; // characters that are still easy to read

function approvalCommands() {
  const lines = approvedText().slice(0, -1).split("\n");
  const short = `printf '%s\\n' ${lines.map(shellQuoted).join(" ")} | ${manifest.command} --approve-list -`;
  const file = [element("p", {}, "After you have saved the list:"), command(`${manifest.command} --approve-list approved.txt`)];
  const isShort = short.length <= longestCommand && lines.every(isPlain);
  return isShort ? [...file, element("p", {}, "Or without a file:"), command(short)] : file;
}

function saveApproved() {
  const address = URL.createObjectURL(new Blob([approvedText()], {type: "text/plain"}));
  element("a", {href: address, download: "approved.txt"}).click();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

function setUpApproval() {
  byId("approve").onchange = () => approve([state.facts], byId("approve").checked);
  byId("approve-all").onclick = () => approve(listed, true);
  byId("approve-none").onclick = () => approve([...approved], false);
  byId("approved-save").onclick = saveApproved;
  byId("approved-copy").onclick = () => copy(approvedText(), byId("approved-copy"), byId("approved-names"));
}

// Assembles the page.

document.title = `${manifest.about}: glassbox views triangulate`;
byId("title").textContent = manifest.about;
byId("summary").textContent = `${manifest.all_matches} matches, ${manifest.counts["in front of both cameras"]} points in front of both cameras${manifest.all_matches > matches.length ? `; the page has the first ${matches.length} matches` : ""}`;
byId("text").textContent = manifest.text;
byId("program").textContent = manifest.program;
byId("command").textContent = manifest.command;
setUpSpace();

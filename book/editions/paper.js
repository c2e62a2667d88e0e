// Make the one file ready for paper: every page that is printed, one after the other, with nothing folded away, cut off or
// too wide, and no link that leads nowhere.
"use strict";
const STILL =
  "On paper the simulator stands still. It runs in the chapter's site, and in its single file; here are its figures.";
const UNPRINTED = /^(source\/|api-)/; // how the names of pages begin that stay on the screen: listings, the reference
const ACTIVE = "a.headerlink, script, noscript, link, button, input, select, textarea, canvas, dialog, img.only-dark";
const ROOM = 150; // CSS pixels to the right of the graph, for a line of text in a wider font
const ROWS = 6; // of the graph in one piece: what is left of a page is filled to within its height
const all = (selector) => [...document.querySelectorAll(selector)];

async function putOnPaper(names) {
  await Chapter.ready(); // then MathJax is there
  document.documentElement.dataset.theme = "light";
  const pages = Chapter.pages.filter((page) =>
    names.length ? names.includes(page.dataset.page) : !UNPRINTED.test(page.dataset.page),
  );
  document.body.replaceChildren(...pages.map((page) => page.querySelector(".bd-article")));
  for (const simulator of all(".simulator")) simulator.outerHTML = `<p class="on-paper">${STILL}</p>`;
  for (const element of all(ACTIVE)) element.remove();
  for (const details of all("details")) details.open = true;
  // A heading gets its section's name: it may stand on the page after the one on which the section begins.
  for (const title of all("section[id] > :is(h1, h2, h3):first-of-type")) {
    title.id = title.parentElement.id;
    title.parentElement.id = "";
  }
  document.querySelector(".bd-article").insertAdjacentHTML("afterend", contents());
  for (const graph of all(".graph > svg")) cut(graph);
  for (const link of all("a, .not-mailed")) if (!leadsOn(link)) drop(link);
  await MathJax.typesetPromise();
  await fit();
}

// The table of contents: pages, and their sections, one below the title.
function contents() {
  const listed = (entries) => (entries.length ? `<ol>${entries.join("")}</ol>` : "");
  const entry = (title, inside) => `<li><a href="#${title.id}">${title.innerHTML}</a>${inside}</li>`;
  const below = (title) =>
    [...title.parentElement.querySelectorAll(":scope > section > h2")].map((part) => entry(part, ""));
  const [, ...titles] = all("h1"); // the front's is the whole chapter's
  return `<nav class="paper-contents"><h2>Contents</h2>${listed(titles.map((title) => entry(title, listed(below(title)))))}</nav>`;
}

// The graph of what rests on what is taller than a page: it is cut between its rows. A row keeps its id.
function cut(graph) {
  const { width, height } = graph.viewBox.baseVal;
  const middles = [...graph.querySelectorAll(".node .reach")].map((circle) => circle.cy.baseVal.value);
  for (let first = 0; first < middles.length; first += ROWS) {
    const edge = (row) => (middles[row - 1] + middles[row]) / 2;
    const top = first ? edge(first) : 0,
      bottom = first + ROWS < middles.length ? edge(first + ROWS) : height;
    const piece = graph.cloneNode(true);
    for (const node of [...piece.querySelectorAll(".node")].filter((_, row) => row < first || row >= first + ROWS))
      node.remove();
    piece.setAttribute("viewBox", `0 ${top} ${width + ROOM} ${bottom - top}`);
    piece.setAttribute("width", width + ROOM);
    piece.setAttribute("height", bottom - top);
    graph.before(piece);
  }
  graph.remove();
}

function leadsOn(link) {
  const address = link.getAttribute("href") || "";
  return (
    /^(https?:|mailto:)/.test(address) ||
    (address[0] === "#" && document.getElementById(decodeURIComponent(address.slice(1))))
  );
}

// Of provenance a link goes with the dot after it, elsewhere its words stay.
function drop(link) {
  const after = link.nextSibling;
  if (!link.closest(".provenance")) return link.replaceWith(...link.childNodes);
  if (after) after.data = after.data.replace(/^ · /, "");
  link.remove();
}

// Make what is wider than the page as narrow as the page: formulas and tables by their size, as little as may be.
async function fit() {
  await document.fonts.ready;
  await Promise.all([...document.images].map((image) => image.decode()));
  const room = (element) => {
    const block = element.closest("li, dd, td, th, p, figcaption, .theorem, div, section"),
      style = getComputedStyle(block);
    return block.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight);
  };
  const width = (element) => Math.max(element.getBoundingClientRect().width, element.scrollWidth);
  // Measured first and changed afterwards: the whole document is laid out once, not once for each formula.
  const formulas = all("mjx-container").map((formula) => {
    const inner = formula.hasAttribute("display") ? formula.querySelector("mjx-math") : formula;
    return { formula, share: room(formula) / width(inner), size: parseFloat(getComputedStyle(formula).fontSize) };
  });
  const tables = all("table").map((table) => ({ table, share: table.parentElement.clientWidth / width(table) }));
  for (const { formula, share, size } of formulas) if (share < 1) formula.style.fontSize = `${0.99 * share * size}px`;
  for (const { table, share } of tables) if (share < 1) table.style.zoom = 0.995 * share;
}

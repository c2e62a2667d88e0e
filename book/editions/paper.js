// Make the one file ready for paper: every page that is printed, one after the other, with nothing folded away, cut off or
// too wide, and no link that leads nowhere.
"use strict";
const STILL =
  "On paper the simulator stands still. It runs in the chapter's site, and in its single file; here are its figures.";
const UNPRINTED = /^(source\/|api-)/; // how the names of pages begin that stay on the screen: listings, the reference
const ACTIVE = "a.headerlink, script, noscript, link, button, input, select, textarea, canvas, dialog, img.only-dark";
const ROOM = 150; // CSS pixels to the right of the graph, for a line of text in a wider font
const ROWS = 6; // of the graph in one piece: what is left of a page is filled to within its height

/** @param {string[]} names of pages; none: all that are printed */
async function putOnPaper(names) {
  await Chapter.ready(); // then MathJax is there
  document.documentElement.dataset.theme = "light";
  const is_printed = (name = "") => (names.length ? names.includes(name) : !UNPRINTED.test(name));
  const pages = Chapter.pages.filter(({ dataset }) => is_printed(dataset.page));
  document.body.replaceChildren(...pages.map((page) => find_element(page, ".bd-article")));
  for (const simulator of document.querySelectorAll(".simulator"))
    simulator.replaceWith(make_element("p", { class: "on-paper" }, STILL));
  for (const element of document.querySelectorAll(ACTIVE)) element.remove();
  for (const details of document.querySelectorAll("details")) details.open = true;
  // A heading gets its section's name: it may stand on the page after the one on which the section begins.
  for (const section of document.querySelectorAll("section[id]:has(> :is(h1, h2, h3))")) {
    find_element(section, ":scope > :is(h1, h2, h3)").id = section.id;
    section.id = "";
  }
  find_element(document, ".bd-article").after(contents());
  /** @type {NodeListOf<SVGSVGElement>} */
  const graphs = document.querySelectorAll(".graph > svg");
  graphs.forEach(cut);
  for (const link of document.querySelectorAll("a, .not-mailed")) if (!leads_on(link)) drop(link);
  await MathJax.typesetPromise();
  await fit();
}

// The table of contents: pages, and their sections, one below the title.
function contents() {
  /** @param {Element} title @param {...Element} inside */
  function entry(title, ...inside) {
    const link = make_element("a", { href: `#${title.id}` });
    link.innerHTML = title.innerHTML;
    return make_element("li", {}, link, ...inside);
  }
  const [, ...titles] = document.querySelectorAll("h1"); // the front's is the whole chapter's
  const entries = titles.map((title) => {
    const parts = Array.from(title.parentElement?.querySelectorAll(":scope > section > h2") ?? [], (part) =>
      entry(part)
    );
    return parts.length ? entry(title, make_element("ol", {}, ...parts)) : entry(title);
  });
  const heading = make_element("h2", {}, "Contents");
  return make_element("nav", { class: "paper-contents" }, heading, make_element("ol", {}, ...entries));
}

/** The graph of what rests on what is taller than a page: it is cut between its rows. A row keeps its id. @param {SVGSVGElement} graph */
function cut(graph) {
  const { width, height } = graph.viewBox.baseVal;
  /** @type {NodeListOf<SVGCircleElement>} */
  const circles = graph.querySelectorAll(".node .reach");
  const middles = Array.from(circles, (circle) => circle.cy.baseVal.value);
  /** Where it is cut before a row. @param {number} row */
  const edge = (row) => (row && row < middles.length ? (middles[row - 1] + middles[row]) / 2 : row && height);
  for (let first = 0; first < middles.length; first += ROWS) {
    const [top, bottom] = [edge(first), edge(first + ROWS)];
    const piece = /** @type {SVGSVGElement} */ (graph.cloneNode(true));
    for (const [row, node] of piece.querySelectorAll(".node").entries())
      if (row < first || row >= first + ROWS) node.remove();
    const size = { width: width + ROOM, height: bottom - top };
    set_attributes(piece, { ...size, viewBox: `0 ${top} ${size.width} ${size.height}` });
    graph.before(piece);
  }
  graph.remove();
}

/** @param {Element} link */
function leads_on(link) {
  const address = link.getAttribute("href") ?? "";
  if (address.startsWith("#")) return document.getElementById(decodeURIComponent(address.slice(1)));
  return /^(https?:|mailto:)/.test(address);
}

/** Of provenance a link goes with the dot after it, elsewhere its words stay. @param {Element} link */
function drop(link) {
  const after = link.nextSibling;
  if (!link.closest(".provenance")) return link.replaceWith(...link.childNodes);
  if (after) after.nodeValue = (after.nodeValue ?? "").replace(/^ · /, "");
  link.remove();
}

// Make what is wider than the page as narrow as the page: formulas and tables by their size, as little as may be.
async function fit() {
  await document.fonts.ready;
  await Promise.all(Array.from(document.images, (image) => image.decode()));
  /** @param {Element} element */
  function room(element) {
    const block = element.closest("li, dd, td, th, p, figcaption, .theorem, div, section") ?? document.body;
    const style = getComputedStyle(block);
    return block.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight);
  }
  /** @param {Element} element */
  const width = (element) => Math.max(element.getBoundingClientRect().width, element.scrollWidth);
  // Measured first and changed afterwards: the whole document is laid out once, not once for each formula.
  /** @type {NodeListOf<HTMLElement>} */
  const containers = document.querySelectorAll("mjx-container");
  const formulas = Array.from(containers, (formula) => {
    const inner = formula.hasAttribute("display") ? find_element(formula, "mjx-math") : formula;
    return { formula, share: room(formula) / width(inner), size: parseFloat(getComputedStyle(formula).fontSize) };
  });
  const tables = Array.from(document.querySelectorAll("table"), (table) => {
    return { table, share: (table.parentElement?.clientWidth ?? 0) / width(table) };
  });
  for (const { formula, share, size } of formulas) if (share < 1) formula.style.fontSize = `${0.99 * share * size}px`;
  for (const { table, share } of tables) if (share < 1) table.style.zoom = String(0.995 * share);
}

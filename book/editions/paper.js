// Make the one file ready for paper: every page that is printed, one after the other, with nothing folded away, cut off or
// too wide, and no link that leads nowhere. What machines read, listings, certificates and Coq's text, is in the site.
"use strict";

/** Put pages on paper: those with the names, or without any all but listings and the reference. @param {string[]} names */
async function put_on_paper(names) {
  const active =
    "a.headerlink, script, noscript, link, button, input, select, textarea, canvas, dialog, img.only-dark, .claim, .coq, .simulator";
  document.documentElement.dataset.theme = "light";
  const pages = Chapter.pages.filter(({ dataset: { page = "" } }) =>
    names.length ? names.includes(page) : !/^(source\/|api-)/.test(page)
  );
  document.body.replaceChildren(...pages.map((page) => find_element(page, ".bd-article")));
  unfold(document);
  for (const element of find_all(document, active)) element.remove();
  for (const details of find_all(document, "details")) details.setAttribute("open", "");
  // A heading gets its section's name: it may stand on the page after the one on which the section begins.
  for (const section of find_all(document, "section[id]:has(> :is(h1, h2, h3))")) {
    const { id } = section;
    section.id = "";
    find_element(section, ":scope > :is(h1, h2, h3)").id = id;
  }
  list_contents();
  for (const link of find_all(document, "a, .not-mailed")) if (!leads_on(link)) drop_link(link);
  await fit_to_page();

  // The table of contents: pages, and their sections. The front's title is the whole chapter's.
  function list_contents() {
    const titles = find_all(document, "article + article > section > h1, article + article > section > section > h2");
    const entries = titles.map(({ id, localName, childNodes }) => {
      const link = make_element("a", { href: `#${id}` }, ...Array.from(childNodes, (node) => node.cloneNode(true)));
      return make_element("li", { class: localName }, link);
    });
    const list = make_element("ol", {}, ...entries);
    const contents = make_element("nav", { class: "paper-contents" }, make_element("h2", {}, "Contents"), list);
    find_element(document, "article").after(contents);
  }

  /** @param {Element} link */
  function leads_on(link) {
    const address = link.getAttribute("href") ?? "";
    return address[0] === "#"
      ? document.getElementById(decodeURIComponent(address.slice(1)))
      : /^(http|mailto:)/.test(address);
  }

  /** Of provenance a link goes with the dot after it, elsewhere its words stay. @param {Element} link */
  function drop_link(link) {
    if (!link.closest(".provenance")) return link.replaceWith(...link.childNodes);
    if (link.nextSibling instanceof Text) link.nextSibling.data = link.nextSibling.data.replace(/^ · /, "");
    link.remove();
  }

  // Make what is wider than the page as narrow as the page: formulas and tables by their size, as little as may be.
  async function fit_to_page() {
    await document.fonts.ready;
    await Promise.all([...document.images].map((image) => image.decode()));
    // Measured first and changed afterwards: the whole document is laid out once, not once for each formula.
    const formulas = find_all(document, "math").map((formula) => {
      const block = formula.closest("li, dd, td, th, p, figcaption, .theorem, div, section") ?? document.body;
      const { paddingLeft, paddingRight } = getComputedStyle(block);
      const parts = document.createRange(); // a displayed formula is itself as wide as its block
      parts.selectNodeContents(formula);
      const room = block.clientWidth - parseFloat(paddingLeft) - parseFloat(paddingRight);
      return {
        formula,
        share: room / parts.getBoundingClientRect().width,
        size: parseFloat(getComputedStyle(formula).fontSize)
      };
    });
    const tables = find_all(document, "table").map((table) => ({
      table,
      share: (table.parentElement?.clientWidth ?? 0) / width_of(table)
    }));
    for (const { formula, share, size } of formulas) if (share < 1) formula.style.fontSize = `${0.99 * share * size}px`;
    for (const { table, share } of tables) if (share < 1) table.style.zoom = String(0.995 * share);
  }

  /** @param {Element} element */
  function width_of(element) {
    return Math.max(element.getBoundingClientRect().width, element.scrollWidth);
  }
}

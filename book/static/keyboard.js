// A claim that a link leads to opens. What is too wide for its column scrolls in itself, and its edge fades while there
// is more: the Tab key then reaches it, and the arrow keys move it. On a phone a table that is too wide becomes a list. A
// formula that is copied is its TeX. A link to a theorem's card shows its statement when it is pointed at or has the focus.
"use strict";
(() => {
  const SCROLLS =
    "figure .pixels, div.math, pre, .pst-scrollable-table-container, .admonition, .claim, .theorem > p, .theorem details";
  const PHONE = matchMedia("(max-width: 600px)");
  const FOCUSABLE = "a[href], button, input, select, textarea, summary, [tabindex='0']";

  /** What a screen reader says on arriving: the figure's number, or what kind of thing it is. @param {Element} element */
  function name_of(element) {
    const number = element.closest("figure")?.querySelector(".caption-number")?.textContent.trim();
    return number || (element.matches(".math") ? "Formula" : "Text");
  }

  /** Letters that lean out of a formula are not more of it. @param {Element} element */
  const hidden = (element) => element.scrollWidth - element.clientWidth - 2;

  /** @param {Element} element */
  function needs_keys(element) {
    const scrolls = ["auto", "scroll"].includes(getComputedStyle(element).overflowX);
    return scrolls && hidden(element) > 0 && !element.querySelector(FOCUSABLE);
  }

  /** @param {Element} element @param {boolean} needed */
  function put_into_reach(element, needed) {
    if (needed === element.hasAttribute("data-in-reach")) return;
    const attributes = {
      tabindex: "0",
      role: "group",
      "aria-label": `${name_of(element)}, scrolls sideways`,
      "data-in-reach": ""
    };
    if (needed) set_attributes(element, attributes);
    else for (const name of Object.keys(attributes)) element.removeAttribute(name);
  }

  /** @param {Element} element */
  const has_more = (element) => element.scrollLeft < hidden(element);

  /** @param {Element} element */
  function fade(element, more = has_more(element)) {
    element.classList.toggle("more", more);
  }

  /** What got a size, which nothing has that is folded. All is read before any is changed, lest each is laid out by itself. */
  const sizes = new ResizeObserver((resized) => {
    const read = resized.map(({ target }) => ({ target, needed: needs_keys(target), more: has_more(target) }));
    for (const { target, needed, more } of read) {
      put_into_reach(target, needed);
      fade(target, more);
    }
  });

  /** Each row is an entry; a cell says what its column is called. @param {HTMLTableElement} table */
  function list(table) {
    if (table.offsetWidth <= (table.parentElement?.clientWidth ?? 0)) return;
    const names = Array.from(table.tHead?.rows[0].cells ?? [], (head) => head.textContent.trim());
    for (const cell of /** @type {HTMLTableCellElement[]} */ (find_all(table, "tbody td:not(:first-child)")))
      cell.dataset.column = cell.textContent.trim() && names[cell.cellIndex];
    table.classList.add("as-list");
  }

  /** @param {Element} page */
  function mend(page) {
    if (PHONE.matches) /** @type {HTMLTableElement[]} */ (find_all(page, "table.table:not(.as-list)")).forEach(list);
    for (const element of page.querySelectorAll(SCROLLS)) sizes.observe(element);
  }

  function watch() {
    open_claim();
    const page = document.getElementById("main-content");
    if (!page) return;
    const scrolled = (/** @type {Event} */ { target }) => target instanceof Element && fade(target);
    page.addEventListener("scroll", scrolled, { capture: true, passive: true });
    // A window's new width and an opened fold all change the page's size.
    new ResizeObserver(() => mend(page)).observe(page);
  }

  function open_claim() {
    const place = document.getElementById(location.hash.slice(1));
    place?.closest(".ledger-list > li")?.querySelector("details")?.setAttribute("open", "");
  }

  const { src } = /** @type {HTMLScriptElement} */ (document.currentScript);
  const note = make_element("div", { class: "theorem-note", popover: "manual", role: "tooltip" });
  /** @type {{ told: HTMLAnchorElement | null, before: HTMLAnchorElement | null }} */
  const links = { told: null, before: null };
  let is_finger = false;
  /** @type {Promise<unknown> | undefined} */
  let known;

  /** Show what the card says that a link under the pointer, or with the focus, leads to; else nothing. @param {Event} event */
  async function tell(event) {
    const { target } = event;
    if (event instanceof PointerEvent) {
      links.before = links.told;
      is_finger = event.pointerType === "touch";
    }
    if (!(target instanceof Element) || note.contains(target)) return;
    /** @type {HTMLAnchorElement | null} */
    const link = target.closest('a[href*="#theorem-"]');
    if (link === links.told) return;
    note.remove();
    links.told = link;
    if (!link) return;
    const card = document.querySelector(`${link.hash} > p`)?.cloneNode(true);
    if (!card) known ??= load_script(src.replace("keyboard", "statements"));
    await known;
    if (links.told !== link) return;
    note.replaceChildren(card ?? Statements[link.hash]);
    for (const named of find_all(note, "[id]")) named.removeAttribute("id");
    document.body.append(note);
    note.showPopover({ source: link }); // beside which the style sheet puts it
    link.ariaDescription = note.textContent;
  }

  /** @param {ClipboardEvent} event */
  function copy(event) {
    const chosen = getSelection();
    const copied = chosen?.rangeCount && chosen.getRangeAt(0).cloneContents();
    const formulas = copied ? copied.querySelectorAll("math") : [];
    for (const formula of formulas) formula.replaceWith(`$${formula.getAttribute("data-tex")}$`);
    if (!copied || !formulas.length) return;
    event.clipboardData?.setData("text/plain", copied.textContent);
    event.preventDefault();
  }

  addEventListener("hashchange", open_claim);
  document.addEventListener("copy", copy);
  // Not when the mouse is over it by a page's own motion.
  for (const kind of ["mousemove", "focusin", "pointerdown"]) document.addEventListener(kind, tell);
  document.addEventListener("keydown", ({ key }) => key === "Escape" && note.remove());
  // A finger's first tap shows what the second one follows.
  document.addEventListener("click", (event) => {
    if (is_finger && links.told && links.told !== links.before) event.preventDefault();
  });
  when_ready(watch);
})();

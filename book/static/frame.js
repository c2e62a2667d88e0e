// The frame around a page: light or dark, the search's field, the menus of a phone, the files to download, and where on the
// page the reader is. It stands in for the theme's own scripts, which bring Bootstrap's.
"use strict";
document.fonts.load('1em "Book Formulas"'); // before a formula is laid out, so that none moves
(() => {
  const root = document.documentElement;
  const dark = matchMedia("(prefers-color-scheme: dark)");
  // Who comes to a page's top finds what is below laid out when it is near, and all of it with the first click; who comes
  // back, or to a part of the page, finds all of it, lest what is above grows.
  const [{ type }] = /** @type {PerformanceNavigationTiming[]} */ (performance.getEntriesByType("navigation"));
  root.classList.toggle("embed", new URLSearchParams(location.search).has("embed")); // the simulator alone, in another page
  root.classList.toggle("begun", type === "navigate" && !location.hash);
  // Icons come once the text stands: drawn with it, they would be most of what its style takes.
  requestAnimationFrame(() => setTimeout(() => root.classList.add("drawn")));

  /** @param {string} mode */
  function colour(mode) {
    const theme = mode === "auto" ? (dark.matches ? "dark" : "light") : mode;
    Object.assign(root.dataset, { mode, theme });
    Object.assign(localStorage, { mode, theme });
  }

  /** The modes go round: first the one that is unlike the system's. */
  function next_colour() {
    const modes = dark.matches ? ["auto", "light", "dark"] : ["auto", "dark", "light"];
    colour(modes[(modes.indexOf(root.dataset.mode ?? "") + 1) % 3]);
  }

  /** @param {string} selector @param {() => void} work */
  function on_click(selector, work) {
    for (const button of document.querySelectorAll(selector)) button.addEventListener("click", work);
  }

  function search() {
    const field = document.querySelector(/** @type {"input"} */ (":not(dialog) > form.bd-search input"));
    const dialog = document.querySelector(/** @type {"dialog"} */ ("#pst-search-dialog"));
    if (!field && !dialog?.open) dialog?.showModal();
    (field ?? dialog?.querySelector("input"))?.select();
  }

  /** What stands beside the page on a wide screen opens as a dialog on a narrow one. @param {string} name @param {number} wide */
  function menu(name, wide) {
    const side = document.querySelector(`#pst-${name}-sidebar`);
    const dialog = document.querySelector(/** @type {"dialog"} */ (`#pst-${name}-sidebar-modal`));
    if (!side || !dialog) return;
    /** @param {Element} from @param {Element} to */
    function move(from, to) {
      to.append(...from.childNodes);
      [to.className, from.className] = [from.className, ""];
    }
    on_click(`.${name}-toggle`, () => {
      if (innerWidth >= wide) side.classList.toggle("pst-sidebar-hidden");
      else {
        move(side, dialog);
        dialog.showModal();
      }
    });
    dialog.addEventListener("close", () => move(dialog, side));
  }

  /** A menu of files opens and closes, and says so, as the browser has it. @param {HTMLButtonElement} button */
  function drop_down(button) {
    const menu = /** @type {HTMLElement} */ (button.nextElementSibling);
    menu.popover = "auto";
    button.popoverTargetElement = menu;
    button.ariaExpanded = null;
  }

  function mark_section() {
    const above = find_all(document, ".bd-article section > h2")
      .filter((title) => title.checkVisibility() && title.getBoundingClientRect().top < innerHeight / 3)
      .pop();
    for (const link of /** @type {HTMLAnchorElement[]} */ (find_all(document, "#pst-page-toc-nav a")))
      link.classList.toggle("active", link.hash.slice(1) === above?.parentElement?.id);
  }

  /** The contents fold where something wide reaches into their column. */
  function fold_contents() {
    const contents = document.querySelector(".bd-sidebar-secondary");
    contents?.classList.remove("folded");
    const end = contents?.getBoundingClientRect().bottom ?? 0;
    const wide = find_all(document, ".bd-article :is(.page-width, .full-width, .simulator)");
    const reaches = wide.some((part) => part.checkVisibility() && part.getBoundingClientRect().top < end);
    contents?.classList.toggle("folded", reaches);
  }

  function begin() {
    on_click(".theme-switch-button", next_colour);
    on_click(".search-button__button", search);
    for (const dialog of document.querySelectorAll("dialog")) dialog.closedBy = "any"; // by a click beside it
    /** @type {HTMLButtonElement[]} */ (find_all(document, ".dropdown-toggle")).forEach(drop_down);
    menu("primary", 992);
    menu("secondary", 1200);
    new ResizeObserver(() => {
      fold_contents();
      mark_section();
    }).observe(document.body);
  }

  colour(root.dataset.mode ?? "auto"); // before anything is in the page, which else gets its colours twice
  dark.addEventListener("change", () => root.dataset.mode === "auto" && colour("auto"));
  addEventListener("click", () => root.classList.remove("begun"));
  addEventListener("toggle", ({ target }) => unfold(/** @type {Element} */ (target)), true);
  addEventListener("keydown", (event) => {
    const { key } = event;
    if (!event.ctrlKey && !event.metaKey) return;
    if (key === "f") unfold(document); // the browser's own search reads what is there
    if (key !== "k") return;
    event.preventDefault();
    search();
  });
  addEventListener("scroll", () => requestAnimationFrame(mark_section), { passive: true });
  when_ready(begin);
})();

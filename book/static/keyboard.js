// A claim that a link leads to opens. What is too wide for its column scrolls in itself, and its edge fades while there
// is more: the Tab key then reaches it, and the arrow keys move it. On a phone a picture's panels stand one below the other,
// and a table that is too wide becomes a list.
// The theme does so for code and tables; here are figures, formulas, theorems and graphs.
"use strict";
(() => {
  const SCROLLS = "figure .pixels, mjx-container[display], .math, .admonition, .graph, .theorem > p, .theorem details";
  const PHONE = matchMedia("(max-width: 600px)");
  const FOCUSABLE = "a[href], button, input, select, textarea, summary, [tabindex='0']";

  // What a screen reader says on arriving: the figure's number, or what kind of thing it is.
  function name_of(element) {
    const number = element.closest("figure")?.querySelector(".caption-number")?.textContent.trim();
    return number || (element.matches(".graph") ? "Graph" : element.matches("mjx-container, .math") ? "Formula" : "Text");
  }

  // Letters that lean out of a formula are not more of it.
  const hidden = (element) => element.scrollWidth - element.clientWidth - 2;

  function put_into_reach(element) {
    const overflow = getComputedStyle(element).overflowX, scrolls = overflow === "auto" || overflow === "scroll";
    const needed = scrolls && hidden(element) > 0 && !element.querySelector(FOCUSABLE);
    if (needed === element.hasAttribute("data-in-reach")) return;
    const attributes = { tabindex: "0", role: "group", "aria-label": `${name_of(element)}, scrolls sideways`, "data-in-reach": "" };
    for (const [name, value] of Object.entries(attributes)) {
      if (needed) element.setAttribute(name, value); else element.removeAttribute(name);
    }
  }

  function fade(element) {
    element.classList.toggle("more", element.scrollLeft < hidden(element));
  }

  // Each panel is the whole picture in a window as wide as the panel.
  function stack(image) {
    let left = 0;
    for (const width of image.dataset.panels.split(" ").map(Number)) {
      const panel = document.createElement("div"), copy = image.cloneNode();
      panel.className = ["panel", ...image.classList].filter((name) => /^panel$|^only-/.test(name)).join(" ");
      panel.style.cssText = `aspect-ratio: ${width} / ${image.getAttribute("height")}; max-width: ${width}px`;
      copy.style.cssText = `margin-left: ${(-100 * left) / width}%; width: ${(100 * image.getAttribute("width")) / width}%`;
      copy.removeAttribute("data-panels");
      copy.alt = left ? "" : image.alt;
      panel.append(copy);
      image.parentElement.append(panel);
      left += width;
    }
    image.removeAttribute("data-panels");
  }

  // Each row is an entry; a cell says what its column is called.
  function list(table) {
    if (table.offsetWidth <= table.parentElement.clientWidth) return;
    const names = Array.from(table.tHead?.rows[0].cells ?? [], (head) => head.textContent.trim());
    for (const cell of table.querySelectorAll("tbody td:not(:first-child)")) cell.dataset.column = cell.textContent.trim() && names[cell.cellIndex];
    table.classList.add("as-list");
  }

  function watch() {
    const page = document.getElementById("main-content");
    open_claim();
    const all = () => {
      if (PHONE.matches) {
        page.querySelectorAll("img[data-panels][src]").forEach(stack);
        page.querySelectorAll("table.table:not(.as-list)").forEach(list);
      }
      page.querySelectorAll(SCROLLS).forEach(put_into_reach);
      page.querySelectorAll(`${SCROLLS}, .pst-scrollable-table-container, pre`).forEach(fade);
    };
    page?.addEventListener("scroll", ({ target }) => fade(target), { capture: true, passive: true });
    // Typesetting, a window's new width and an opened fold all change the page's size.
    if (page) new ResizeObserver(all).observe(page);
  }

  function open_claim() {
    const claim = document.getElementById(location.hash.slice(1))?.closest(".ledger-list > li")?.querySelector("details");
    if (claim) claim.open = true;
  }

  addEventListener("hashchange", open_claim);
  if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", watch); else watch();
})();

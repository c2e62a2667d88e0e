// A claim that a link leads to opens. What is too wide for its column scrolls in itself: the Tab key then reaches it,
// and the arrow keys move it.
// The theme does so for code and tables; here are figures, formulas, theorems and graphs.
"use strict";
(() => {
  const SCROLLS = "figure .pixels, mjx-container[display], div.math, .admonition, .graph, .theorem > p, .theorem details";
  const FOCUSABLE = "a[href], button, input, select, textarea, summary, [tabindex='0']";

  // What a screen reader says on arriving: the figure's number, or what kind of thing it is.
  function name_of(element) {
    const number = element.closest("figure")?.querySelector(".caption-number")?.textContent.trim();
    return number || (element.matches(".graph") ? "Graph" : element.matches("mjx-container, div.math") ? "Formula" : "Text");
  }

  function put_into_reach(element) {
    const overflow = getComputedStyle(element).overflowX, scrolls = overflow === "auto" || overflow === "scroll";
    const needed = scrolls && element.scrollWidth > element.clientWidth && !element.querySelector(FOCUSABLE);
    if (needed === element.hasAttribute("data-in-reach")) return;
    const attributes = { tabindex: "0", role: "group", "aria-label": `${name_of(element)}, scrolls sideways`, "data-in-reach": "" };
    for (const [name, value] of Object.entries(attributes)) {
      if (needed) element.setAttribute(name, value); else element.removeAttribute(name);
    }
  }

  function watch() {
    const page = document.getElementById("main-content");
    open_claim();
    const all = () => page.querySelectorAll(SCROLLS).forEach(put_into_reach);
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

// One page of the chapter at a time, as the site has it: the address says which. Dark pictures are made when their page is
// first shown. Without this script all pages stand one below the other.
"use strict";
(() => {
  const pages = find_all(document, ".chapter-page");
  const root = document.documentElement;
  const title = document.title;
  let current = pages[0];
  let is_shown = false;
  /** @type {number | null} */
  let back = null;

  // The element, or the page, that the address names. What follows a question mark is for the page's own scripts.
  function named() {
    const id = location.hash.slice(1).split("?")[0];
    return document.getElementById(id) ?? pages.find((page) => page.dataset.page === id);
  }

  /** A dark drawing is its light neighbour with some parts replaced. @param {Element} page */
  function darken(page) {
    if (root.dataset.theme !== "dark") return;
    /** @type {HTMLImageElement[]} */
    const images = find_all(page, "img[data-dark]");
    for (const image of images) {
      const parts = image.previousElementSibling?.getAttribute("src")?.split("<") ?? [];
      for (const change of (image.dataset.dark ?? "").matchAll(/(\d+) (\d+) (\d+) ([^<]*)/g)) {
        const [part, start, end] = change.slice(1, 4).map(Number);
        const old = parts[part];
        parts[part] = old.slice(0, start) + change[4] + old.slice(old.length - end);
      }
      image.src = parts.join("<");
      image.removeAttribute("data-dark");
    }
  }

  /** @param {HTMLElement} page */
  function show(page) {
    current = page;
    is_shown = true;
    for (const other of pages) {
      if (other === page) other.removeAttribute("hidden");
      else other.setAttribute("hidden", "until-found");
    }
    for (const part of document.querySelectorAll("[data-of]"))
      part.toggleAttribute("hidden", part.getAttribute("data-of") !== page.dataset.page);
    /** @type {HTMLAnchorElement[]} */
    const links = find_all(document, ".bd-docs-nav a");
    for (const link of links) {
      const here = page.contains(document.getElementById(link.hash.slice(1)));
      for (const name of ["current", "active"]) link.parentElement?.classList.toggle(name, here);
      link.classList.toggle("current", here);
    }
    document.title = page === pages[0] ? title : `${page.dataset.title} — ${title}`;
    darken(page);
    window.dispatchEvent(new Event("resize")); // what measured itself while hidden measures again
  }

  /** Go where the address says: to `height` if the reader comes back, else to the element. @param {number | null} height */
  function go(height) {
    const target = named();
    /** @type {HTMLElement} */
    const page = target?.closest(".chapter-page") ?? (target ? current : pages[0]);
    const top = !target || target.matches(".chapter-page, .bd-article > section");
    for (const dialog of document.querySelectorAll("dialog")) dialog.close();
    const turned = !is_shown || page !== current;
    if (turned) show(page);
    if (!turned && height === null) return;
    if (height === null && !top) target?.scrollIntoView({ behavior: "instant" });
    else scrollTo({ top: height ?? 0, behavior: "instant" });
  }

  /** @param {HTMLAnchorElement} link */
  async function unpack(link) {
    /** @type {HTMLAnchorElement} */
    const holder = link.hash ? find_element(document, link.hash) : link; // of files that are alike the first link holds one
    const blob = await unpacked(holder.href.split(",")[1]).blob();
    const href = URL.createObjectURL(blob);
    download(link.dataset.packed ?? "", href);
    setTimeout(() => URL.revokeObjectURL(href), 1000);
  }

  document.addEventListener("click", (event) => {
    const link = event.target instanceof Element ? event.target.closest("a") : null;
    const address = link?.getAttribute("href");
    if (!link || !address) return;
    if (link.dataset.packed) {
      event.preventDefault();
      unpack(link);
    } else if (address.startsWith("#")) {
      history.replaceState({ height: scrollY }, ""); // for the way back
      if (link.hash === location.hash) go(null); // no change of the address will tell
    }
  });
  window.addEventListener("popstate", (event) => {
    back = event.state ? event.state.height : null;
  });
  window.addEventListener("hashchange", () => {
    go(back);
    back = null;
  });
  for (const page of pages) page.addEventListener("beforematch", () => page !== current && show(page));
  new MutationObserver(() => is_shown && darken(current)).observe(root, { attributeFilter: ["data-theme"] });
  // After every other script has seen the whole document.
  document.addEventListener("DOMContentLoaded", () => go(null));
  window.Chapter = { pages, shown: () => current, show };
})();

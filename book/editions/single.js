// One page of the chapter at a time, as the site has it: the address says which. Formulas are typeset, and dark pictures
// made, when their page is first shown. Without this script all pages stand one below the other.
"use strict";
(() => {
  const pages = [...document.querySelectorAll(".chapter-page")], root = document.documentElement, title = document.title;
  const hiding = "onbeforematch" in root ? "until-found" : "";
  const typeset = new Map();
  let current = null, back = null;

  const plain = (text) => {
    try {
      return decodeURIComponent(text);
    } catch {
      return text;
    }
  };

  // The element, or the page, that the address names. What follows a question mark is for the page's own scripts.
  function named() {
    const id = plain(location.hash.slice(1).split("?")[0]);
    return document.getElementById(id) || pages.find((page) => page.dataset.page === id);
  }

  const unpacked = (base64) => {
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip")));
  };

  // MathJax is more than a tenth of the file, and is carried compressed.
  const typesetter = (async () => {
    const script = document.createElement("script");
    script.textContent = await unpacked(document.getElementById("packed-mathjax").textContent).text();
    document.head.append(script);
    await MathJax.startup.promise;
  })();

  function mathematics(page) {
    const before = [...typeset.values()].pop();
    if (!typeset.has(page)) typeset.set(page, Promise.all([typesetter, before]).then(() => MathJax.typesetPromise([page])));
    return typeset.get(page);
  }

  // A dark drawing is its light neighbour with some parts replaced.
  function darken(page) {
    if (root.dataset.theme !== "dark") return;
    for (const image of page.querySelectorAll("img[data-dark]")) {
      const parts = image.previousElementSibling.getAttribute("src").split("<");
      for (const change of image.dataset.dark.split("<").filter(Boolean)) {
        const [, part, start, end, text] = change.match(/^(\d+) (\d+) (\d+) ([^]*)$/), old = parts[part];
        parts[part] = old.slice(0, start) + text + old.slice(old.length - end);
      }
      image.src = parts.join("<");
      image.removeAttribute("data-dark");
    }
  }

  function show(page) {
    current = page;
    for (const other of pages) {
      if (other === page) other.removeAttribute("hidden");
      else other.setAttribute("hidden", hiding);
    }
    for (const part of document.querySelectorAll("[data-of]")) part.hidden = part.dataset.of !== page.dataset.page;
    for (const link of document.querySelectorAll(".bd-docs-nav a")) {
      const here = page.contains(document.getElementById(plain(link.hash.slice(1))));
      for (const name of ["current", "active"]) link.parentElement.classList.toggle(name, here);
      link.classList.toggle("current", here);
    }
    document.title = page === pages[0] ? title : `${page.dataset.title} — ${title}`;
    darken(page);
    window.dispatchEvent(new Event("resize")); // what measured itself while hidden measures again
    return mathematics(page);
  }

  // Go where the address says: to `height` if the reader comes back, else to the element.
  async function go(height) {
    const target = named(), page = (target ? target.closest(".chapter-page") || current : null) || pages[0];
    const top = !target || target.matches(".chapter-page, .bd-article > section");
    const arrive = () => (height === null && !top ? target.scrollIntoView({ behavior: "instant" }) : scrollTo({ top: height || 0, behavior: "instant" }));
    for (const dialog of document.querySelectorAll("dialog[open]")) dialog.close();
    const fresh = !typeset.has(page), turned = page !== current, ready = turned ? show(page) : null;
    if (turned || height !== null) arrive();
    const left = scrollY;
    if (!fresh) return;
    await ready;
    if (Math.abs(scrollY - left) < 2) arrive(); // formulas have moved the place, and the reader has not
  }

  async function unpack(link) {
    const holder = link.hash ? document.getElementById(link.hash.slice(1)) : link;
    const saved = document.createElement("a");
    saved.href = URL.createObjectURL(await unpacked(holder.href.split(",")[1]).blob());
    saved.download = link.dataset.packed;
    saved.click();
    setTimeout(() => URL.revokeObjectURL(saved.href), 1000);
  }

  document.addEventListener("click", (event) => {
    const link = event.target.closest("a[href]");
    if (link && link.dataset.packed && window.DecompressionStream) {
      event.preventDefault();
      unpack(link);
    } else if (link && link.getAttribute("href").startsWith("#")) {
      history.replaceState({ height: scrollY }, ""); // for the way back
      if (link.hash === location.hash) go(null); // no change of the address will tell
    }
  });
  window.addEventListener("popstate", (event) => (back = event.state ? event.state.height : null));
  window.addEventListener("hashchange", () => {
    go(back ?? null);
    back = null;
  });
  for (const page of pages) page.addEventListener("beforematch", () => page !== current && show(page));
  new MutationObserver(() => current && darken(current)).observe(root, { attributeFilter: ["data-theme"] });
  // After every other script has seen the whole document.
  document.addEventListener("DOMContentLoaded", () => go(null));
  window.Chapter = { pages, shown: () => current, ready: () => mathematics(current), show };
})();

// Under each page that the search has found: the first sentence with the most of its words, and a link to its section.
"use strict";
addEventListener("DOMContentLoaded", () => {
  const results = document.getElementById("search-results"), query = new URLSearchParams(location.search).get("q") ?? "";
  const stemmer = new Stemmer(), words = splitQuery(query.toLowerCase()).flatMap((word) => [word, stemmer.stemWord(word)]);
  const count = (text) => words.filter((word) => text.toLowerCase().includes(word)).length;
  const better = (best, found) => (found.count > best.count ? found : best);

  function sentence(page) {
    const found = (SearchText[page] ?? []).map(([id, text]) => ({ id, text, count: count(text) })).reduce(better, { count: 0 });
    if (!found.count) return null;
    const sentences = found.text.split(/(?<=[.!?]) (?=[\p{Lu}\\“(])/u).map((text) => ({ text, count: count(text) }));
    return { id: found.id, text: sentences.reduce(better).text };
  }

  function marked(text) {
    const paragraph = document.createElement("p");
    paragraph.className = "search-sentence";
    const parts = new RegExp(`\\\\\\(.*?\\\\\\)|${words.map(_escapeRegExp).join("|")}`, "giu");
    let end = 0;
    for (const { 0: part, index } of text.matchAll(parts)) {
      const element = document.createElement(part.startsWith("\\(") ? "span" : "mark");
      if (element.localName === "span") element.className = "math";
      element.textContent = part;
      paragraph.append(text.slice(end, index), element);
      end = index + part.length;
    }
    paragraph.append(text.slice(end));
    return paragraph;
  }

  function show(item) {
    const link = item.querySelector("a"), found = sentence(link.pathname.split("/").pop().replace(/\.html$/, ""));
    if (!found || item.querySelector(".search-sentence")) return;
    if (!link.hash && found.id) link.setAttribute("href", `${link.getAttribute("href")}#${found.id}`);
    const shown = item.appendChild(marked(found.text));
    window.MathJax?.typesetPromise?.([shown]);
  }

  const show_all = () => results.querySelectorAll("ul.search > li").forEach(show);
  new MutationObserver(show_all).observe(results, { childList: true, subtree: true });
  show_all();
});

// The search while one types, the chapter's pages first. Under each that is found: the first sentence with the most of its
// words, and a link to its section.
"use strict";
const SMALL = /^(a|an|and|by|for|in|is|its|of|on|the|to)$/;
/** The words that are typed, without those that are everywhere. */
function typed_words() {
  /** @type {HTMLInputElement} */
  const { value } = find_element(document, ".bd-search-container input");
  return splitQuery(value.toLowerCase()).filter((word) => !SMALL.test(word));
}
/** Whether a text has a word, or one that begins so. @param {string} text @param {string} word */
const has_word = (text, word) => new RegExp(`(?<!\\p{L})${_escapeRegExp(word)}`, "iu").test(text);
// Sphinx shows first what scores most: what has all words in its title, a theorem that is named, then §1 to §9, which have
// pages s1 to s9.
Scorer.score = ([page, title, place, , score]) =>
  score +
  (/^s\d\b|#theorem/.test(page + place) ? 100 : 0) +
  (typed_words().every((word) => has_word(title, word)) ? 200 : 0);
addEventListener("DOMContentLoaded", () => {
  const results = find_element(document, "#search-results");
  /** @type {HTMLInputElement} */
  const field = find_element(document, ".bd-search-container input");
  const words_typed = () => typed_words().flatMap((word) => [word, new Stemmer().stemWord(word)]);
  let words = words_typed();
  let typed = 0;

  /** A moment after the last letter, and when all that was found before stands. */
  function search() {
    if (Search.title?.textContent.startsWith("Searching")) return search_soon();
    words = words_typed();
    history.replaceState(null, "", `?q=${encodeURIComponent(field.value)}`);
    results.replaceChildren();
    Search.performSearch(field.value);
  }

  function search_soon() {
    clearTimeout(typed);
    typed = setTimeout(search, 200);
  }

  /** @param {string} text */
  const count = (text) => words.filter((word) => has_word(text, word)).length;

  /** The first text with the most words, of some with what belongs to them. @param {[string, string][]} texts */
  const best_of = (texts) => least_of([["", ""], ...texts], ([, text]) => -count(text));

  /** Of a place that was found the first, of a page the best. @param {HTMLAnchorElement} link */
  function best_sentence({ pathname, hash }) {
    const texts = SearchText[pathname.replace(/^.*\/|\.html$/g, "")] ?? [];
    const [id, paragraph] = texts.find(([id]) => `#${id}` === hash) ?? best_of(texts);
    const sentences = paragraph.split(/(?<=[.!?]) (?=[\p{Lu}“(|√])/u);
    const [, text] = best_of(sentences.map((sentence) => [id, sentence]));
    return { id, text };
  }

  /** @param {string} text */
  function marked(text) {
    const paragraph = make_element("p", { class: "search-sentence" });
    const parts = new RegExp(`(?<!\\p{L})(${words.map(_escapeRegExp).join("|")})`, "giu");
    let end = 0;
    for (const { 0: part, index } of text.matchAll(parts)) {
      paragraph.append(text.slice(end, index), make_element("mark", {}, part));
      end = index + part.length;
    }
    paragraph.append(text.slice(end));
    return paragraph;
  }

  /** @param {Element} item */
  function show(item) {
    /** @type {HTMLAnchorElement} */
    const link = find_element(item, "a");
    const { id, text } = best_sentence(link);
    if (!text || item.querySelector(".search-sentence")) return;
    if (!link.hash && id) link.setAttribute("href", `${link.getAttribute("href")}#${id}`);
    item.append(marked(text));
  }

  field.addEventListener("input", search_soon);
  // The title changes at the end, so that no result is missed.
  new MutationObserver(() => results.querySelectorAll("ul.search > li").forEach(show)).observe(results, {
    childList: true,
    subtree: true
  });
});

// Make what is wider than the page as narrow as the page: formulas and tables by their size, as little as may be.
"use strict";

/** Return the shares of their size that the elements keep which were made smaller. */
async function fitToPage() {
  await MathJax.startup.promise;
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
    const inner = formula.hasAttribute("display") ? (formula.querySelector("mjx-math") ?? formula) : formula;
    return { formula, share: room(formula) / width(inner), size: parseFloat(getComputedStyle(formula).fontSize) };
  });
  const tables = Array.from(document.querySelectorAll("table"), (table) => ({
    table,
    share: (table.parentElement?.clientWidth ?? 0) / width(table),
  }));
  for (const { formula, share, size } of formulas) if (share < 1) formula.style.fontSize = `${0.99 * share * size}px`;
  for (const { table, share } of tables) if (share < 1) table.style.zoom = String(0.995 * share);
  return [...formulas, ...tables].map(({ share }) => share).filter((share) => share < 1);
}

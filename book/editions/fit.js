// Make what is wider than the page as narrow as the page: formulas and tables by their size, as little as may be.
"use strict";
async function fitToPage() {
  await MathJax.startup.promise;
  await document.fonts.ready;
  await Promise.all([...document.images].map((image) => image.decode()));
  const room = (element) => {
    const block = element.closest("li, dd, td, th, p, figcaption, .theorem, div, section"), style = getComputedStyle(block);
    return block.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight);
  };
  const width = (element) => Math.max(element.getBoundingClientRect().width, element.scrollWidth);
  // Measured first and changed afterwards: the whole document is laid out once, not once for each formula.
  const formulas = [...document.querySelectorAll("mjx-container")].map((formula) => {
    const inner = formula.hasAttribute("display") ? formula.querySelector("mjx-math") : formula;
    return { formula, share: room(formula) / width(inner), size: parseFloat(getComputedStyle(formula).fontSize) };
  });
  const tables = [...document.querySelectorAll("table")].map((table) => ({ table, share: table.parentElement.clientWidth / width(table) }));
  for (const { formula, share, size } of formulas) if (share < 1) formula.style.fontSize = `${0.99 * share * size}px`;
  for (const { table, share } of tables) if (share < 1) table.style.zoom = 0.995 * share;
  return [...formulas, ...tables].map(({ share }) => share).filter((share) => share < 1);
}

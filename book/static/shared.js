// What the book's scripts share: elements, numbers as print has them, and a little arithmetic.
"use strict";

/**
 * Return the first element of a selector, which the page has; throw where it has none.
 * @template {Element} [E=HTMLElement]
 * @param {ParentNode} root
 * @param {string} selector
 * @returns {E}
 */
function find_element(root, selector) {
  const found = root.querySelector(selector);
  if (!found) throw new Error(`the page has no ${selector}`);
  return /** @type {E} */ (found);
}

/**
 * Return a new element: make_element("p", { class: "x" }, child, "text", …).
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {Record<string, string | number>} [attributes]
 * @param {...(Node | string)} children
 * @returns {HTMLElementTagNameMap[Tag]}
 */
function make_element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  set_attributes(made, attributes);
  made.append(...children);
  return made;
}

/** @param {Element} element @param {Record<string, string | number>} attributes */
function set_attributes(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
}

/** @param {number} low @param {number} number @param {number} high */
const clamp = (low, number, high) => Math.max(low, Math.min(high, number));

/**
 * Return so many float64 numbers, each made from its index.
 * @param {number} count
 * @param {(index: number) => number} make
 */
function float64s(count, make) {
  return Float64Array.from({ length: count }, (_, index) => make(index));
}

/** A power of ten with three digits, as the steps are that a slider gives. @param {number} exponent */
const power_of_ten = (exponent) => Number((10 ** exponent).toPrecision(3));

/** A text with a minus sign as print has it. @param {string} text */
const with_minus = (text) => text.replace("-", "−");

/** A number with one digit before the point, as print has it. @param {number} number @param {number} digits */
const scientific = (number, digits) => with_minus(number.toExponential(digits)).replace("+", "");

/** A whole number in raised digits. @param {number} number */
const raised = (number) => String(number).replace(/./g, (sign) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(sign)]);

/** Whether a key is pressed together with one that makes it the browser's own. @param {KeyboardEvent} event */
const is_shortcut = (event) => event.ctrlKey || event.altKey || event.metaKey;

/** What is said of what was thrown. @param {unknown} error */
const error_text = (error) => (error instanceof Error ? error.message : String(error));

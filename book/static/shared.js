// What the book's scripts share: elements, numbers as print has them, and a little arithmetic.
"use strict";

const PICTURES = ["numeric", "symbolic", "difference"];

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
 * Return all elements of a selector.
 * @template {Element} [E=HTMLElement]
 * @param {ParentNode} root
 * @param {string} selector
 * @returns {E[]}
 */
const find_all = (root, selector) => [...root.querySelectorAll(/** @type {any} */ (selector))];

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

/** Return a new button that has work done. @param {string} label @param {() => void} work */
function make_button(label, work) {
  const button = make_element("button", { type: "button" }, label);
  button.addEventListener("click", work);
  return button;
}

/** @param {Element} element @param {Record<string, string | number>} attributes */
function set_attributes(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
}

/** Where a number of one range is in another. @param {number} number @param {number} from @param {number} to @param {number} first @param {number} last */
const rescaled = (number, from, to, first, last) => first + ((number - from) / (to - from)) * (last - first);

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

/** A power of ten as print has it. @param {number} exponent */
const ten_to = (exponent) => `10${raised(exponent)}`;

/** A number as print has it, with a power of ten. @param {number} number @param {number} digits at most, after the point */
function in_powers(number, digits) {
  const [size, exponent] = number.toExponential(digits).split("e").map(Number);
  return size === 1 ? ten_to(exponent) : `${size} · ${ten_to(exponent)}`;
}

/** The sum of what is counted of each. @template Item @param {Item[]} items @param {(item: Item) => number} count */
const total = (items, count) => items.reduce((sum, item) => sum + count(item), 0);

/** The first for which a measure is least. @template Item @param {Item[]} items @param {(item: Item) => number} measure */
const least_of = (items, measure) => items.reduce((best, item) => (measure(item) < measure(best) ? item : best));

/** Where the pointer is in an element, and how large that is. @param {Element} element @param {Place} place */
function pointer_in(element, { clientX, clientY }) {
  const { left, top, width, height } = element.getBoundingClientRect();
  return { x: clientX - left, y: clientY - top, width, height };
}

/**
 * Tell of every place of a pressed pointer in an element, wherever it goes.
 * @param {HTMLElement} target what is pressed
 * @param {Element} origin
 * @param {Moved} moved
 */
function follow_pointer(target, origin, moved) {
  /** @param {PointerEvent} event @param {boolean} begins */
  function tell(event, begins) {
    const { x, y } = pointer_in(origin, event);
    moved(x, y, begins);
  }
  target.addEventListener("pointerdown", (event) => {
    if (event.button) return;
    event.stopPropagation();
    target.setPointerCapture(event.pointerId);
    target.focus({ preventScroll: true });
    tell(event, true);
  });
  target.addEventListener("pointermove", (event) => {
    if (target.hasPointerCapture(event.pointerId)) tell(event, false);
  });
}

/** Whether a key is pressed together with one that makes it the browser's own. @param {KeyboardEvent} event */
const is_shortcut = (event) => event.ctrlKey || event.altKey || event.metaKey;

/** Whether what happens is in a box to type into. @param {Event} event */
const is_typed = ({ target }) =>
  target instanceof Element && target.matches("input:not([type=range], [type=radio], [type=checkbox]), textarea");

/**
 * Tell of arrow keys, ten times as far with shift; of a slider also of those that lead as far, or to its ends.
 * @param {HTMLElement} target
 * @param {Stepped} stepped
 */
function follow_arrows(target, stepped) {
  /** @type {Record<string, Point>} */
  const arrows = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  /** @type {Record<string, Point>} */
  const ends = { PageUp: [10, 0], PageDown: [-10, 0], End: [Infinity, 0], Home: [-Infinity, 0] };
  const steps = target.role === "slider" ? { ...arrows, ...ends } : arrows;
  target.addEventListener("keydown", (event) => {
    const step = steps[event.key];
    if (!step || is_shortcut(event)) return;
    event.preventDefault();
    event.stopPropagation();
    const [right, up] = step.map((part) => part * (event.shiftKey ? 10 : 1));
    stepped(right, up);
  });
}

/**
 * Make an element a slider for a screen reader, for the pointer and for keys; return what says where it is.
 * @param {Element} own
 * @param {Element} origin what places are measured in
 * @param {string} label
 * @param {number[]} range of its values, the first and the last
 * @param {Moved} moved
 * @param {Stepped} stepped
 */
function as_slider(own, origin, label, [first, last], moved, stepped) {
  set_attributes(own, {
    tabindex: 0,
    role: "slider",
    "aria-label": label,
    "aria-valuemin": first,
    "aria-valuemax": last
  });
  follow_pointer(/** @type {any} */ (own), origin, moved);
  follow_arrows(/** @type {any} */ (own), stepped);
  /** @param {number} now @param {string} words */
  return (now, words) => set_attributes(own, { "aria-valuenow": now, "aria-valuetext": words });
}

/**
 * A worker that runs functions of the page: a file that is opened from a disk may load none by its address. The last
 * one is given what posts a reply, and returns what takes a message.
 * @param {...Function} functions
 */
function worker_of(...functions) {
  const begin = `const take = ${functions[functions.length - 1].name}(postMessage);`;
  const source = ['"use strict";', ...functions, begin, "onmessage = ({ data }) => take(data);"].join("\n");
  const address = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
  const worker = new Worker(address);
  URL.revokeObjectURL(address);
  return worker;
}

/**
 * Tell what a worker replies, or why it does not.
 * @param {Worker} worker
 * @param {(reply: any) => void} receive
 * @param {(why: string) => void} failed
 */
function listen(worker, receive, failed) {
  worker.onmessage = ({ data }) => receive(data);
  worker.onerror = (event) => {
    event.preventDefault();
    failed(event.message || "it did not start");
  };
}

/** The bytes that a text of the page carries, compressed. @param {string} base64 */
function unpacked(base64) {
  const letters = atob(base64);
  const packed = new Uint8Array(letters.length).map((_, n) => letters.charCodeAt(n));
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip")));
}

/** Bring in what a page's folds keep: its browser reads it when they open, and at once where no script runs. @param {ParentNode} part */
function unfold(part) {
  for (const kept of find_all(part, "details > noscript")) kept.outerHTML = kept.textContent;
}

/** Run a script of the site, once it is wanted. @param {string} src */
const load_script = (src) =>
  new Promise((onload, onerror) => {
    document.head.append(Object.assign(make_element("script"), { src, onload, onerror }));
  });

/** Save what stands at an address, under a name. @param {string} name @param {string} href */
const download = (name, href) => make_element("a", { href, download: name }).click();

/** Do some work when the page is there. @param {() => void} work */
function when_ready(work) {
  if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", work);
  else work();
}

/**
 * Do some work for each element, once: when it is less than a screen away, or so much.
 * @param {Iterable<HTMLElement>} elements
 * @param {(element: HTMLElement) => void} work
 */
function when_near(elements, work, rootMargin = "100%") {
  const far = new IntersectionObserver(
    (entries) => {
      for (const { isIntersecting, target } of entries) {
        if (!isIntersecting) continue;
        far.unobserve(target);
        work(/** @type {HTMLElement} */ (target));
      }
    },
    { rootMargin }
  );
  for (const element of elements) far.observe(element);
}

/** What is said of what was thrown. @param {unknown} error */
const error_text = (error) => (error instanceof Error ? error.message : String(error));

/** A line through points, with a gap where one is NaN. @param {Point[]} points */
function line_path(points) {
  let letter = "M";
  const parts = points.map(([x, y]) => {
    const part = Number.isNaN(y) ? "" : `${letter}${x.toFixed(2)} ${y.toFixed(2)}`;
    letter = part ? "L" : "M";
    return part;
  });
  return parts.join("");
}

/** @param {string} look @param {string} path */
const path_markup = (look, path) => `<path class="${look}" d="${path}"/>`;
/** @param {string} look @param {Point} middle @param {number} radius */
const circle_markup = (look, [x, y], radius) => `<circle class="${look}" cx="${x}" cy="${y}" r="${radius}"/>`;

/** A line through points. @param {string} look @param {Point[]} points */
const line_markup = (look, points) => path_markup(look, line_path(points));

/** @param {number} x @param {number} y @param {string} words */
const text_at = (x, y, words, look = "") =>
  `<text class="${look}" x="${x.toFixed(1)}" y="${y.toFixed(1)}">${words}</text>`;

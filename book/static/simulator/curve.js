// The U-curve: error against ε, of the gradient at the cursor and of the picture, with what the theorems allow behind.
// A slider lies over it, which sets ε by a click, a drag or a key; pointing at it reads it.
"use strict";

/** @param {HTMLElement} root @param {SimulatorModule} module */
function simulator_curve(root, module) {
  const box = find_element(root, ".sim-curve");
  /** @type {SVGSVGElement} */
  const svg = find_element(box, "svg");
  /** @type {HTMLCanvasElement} */
  const strip = find_element(box, "canvas");
  const slider = find_element(box, "input");
  const reading = find_element(root, "[data-reading]");
  const [pointer, now, dot] = ["hover", "now", "dot"].map((name) => find_element(box, `.sim-${name}`));
  const LEFT = -18; // powers of ten: of ε,
  const RIGHT = -1;
  const LOWEST = -16; // and of the error
  const HIGHEST = 2;
  const TOP = 10;
  const STILLS = 16; // each a power of ten wide, in the middle of the axis, where the style sheet puts them
  const LINE = 15;
  const NAMES_WIDE = 110; // beside the plot
  const FINE = Array.from({ length: 137 }, (_, n) => power_of_ten(LEFT + n / 8));
  const COARSE = Array.from({ length: 35 }, (_, n) => power_of_ten(-1 - n / 2));
  /** @type {Record<string, string>} */
  const NAMES = { numeric: "gradient here", bound: "proved bound", difference: "picture, RMS" };
  let width = 0;
  let height = 0;
  let bottom = 0;
  let at_rest = ""; // what is read while nothing is pointed at
  let inset = 0;
  /** @type {Lines} */
  let lines = {};
  /** @type {any[]} */
  let drawn = [];

  /**
   * The errors of the gradient at a pixel of A, and what is proved of them; no line elsewhere.
   * @param {State} state
   * @param {Raster} raster
   * @returns {Lines}
   */
  function at_pixel(state, raster) {
    const stage = module.stage_of_pixel(state, raster);
    if (!stage.count) return {};
    const [u, v] = module.chart(stage);
    const exact = module.gradients(state, stage);
    const numeric = FINE.map((eps) => {
      const slopes = module.gradients(state, stage, { name: state.method, eps });
      return { eps, size: Math.max(...slopes.map(([slope], axis) => Math.abs(slope - exact[axis][0]))) };
    });
    const name = module.bounds_of(state);
    if (!name) return { numeric };
    const [bounds] = module.kernel_over(name, u[0], v[0], state.ku, state.kv, Float64Array.from(FINE));
    return { bound: FINE.map((eps, n) => ({ eps, size: bounds[n] })), numeric };
  }

  // Where the proved bound is least, and where this pixel's own error is.
  function least() {
    const found = Object.entries({ bound: "best by theorem", numeric: "least here" }).flatMap(([name, words]) => {
      const points = lines[name] ?? [];
      if (!points.some(({ size }) => size > 0)) return [];
      const { eps, size } = least_of(points, (point) => point.size);
      const place = `translate(${x_of(eps).toFixed(1)} ${y_of(size).toFixed(1)})`;
      const markup = `<path class="least ${name}" transform="${place}" d="M0 -5L4 3H-4Z"/>`;
      return [{ markup, words: `${words}: ε = ${scientific(eps, 1)}` }];
    });
    at_rest = found.map(({ words }) => words).join(" · ");
    if (pointer.hidden) reading.textContent = at_rest;
    svg.setAttribute("aria-label", `Error against the step: ${at_rest || "no slope here"}`);
    return found.map(({ markup }) => markup).join("");
  }

  /** @param {number} eps */
  const x_of = (eps) => rescaled(Math.log10(eps), LEFT, RIGHT, inset, width - inset);
  /** @param {number} size */
  const y_of = (size) => rescaled(clamp(LOWEST, Math.log10(size), HIGHEST), HIGHEST, LOWEST, TOP, bottom);

  function axes() {
    let text = "";
    for (let n = LOWEST; n <= HIGHEST; n += 4) {
      const y = y_of(10 ** n);
      text += path_markup("grid", `M${inset} ${y}H${width - inset}`);
      text += text_at(inset - 8, y + 4, ten_to(n), "beside");
    }
    for (let n = LEFT; n <= RIGHT; n += width < 500 ? 5 : 3) {
      text += text_at(x_of(10 ** n), height - 4, ten_to(n), "below");
    }
    return text;
  }

  // Each line's name stands at its end, to the right of the plot, where no curve is; a line apart from the next name.
  function names() {
    const ends = Object.entries(lines).filter(([, points]) => points.some(({ size }) => size > 0));
    const placed = ends.map(([name, points]) => {
      const { size } = least_of(points, ({ eps }) => -eps);
      return { name, y: y_of(size || 1e-16) + 4 };
    });
    placed.sort((one, other) => one.y - other.y);
    let last = -Infinity;
    for (const label of placed) {
      label.y = Math.max(label.y, last + LINE);
      last = label.y;
    }
    const over = Math.max(0, last - bottom);
    const texts = placed.map(({ name, y }) => text_at(width + 2, y - over, NAMES[name], `name ${name}`));
    return texts.join("");
  }

  /** The difference at sixteen steps, each under its place on the axis. @param {Map<number, PicturePoint>} picture @param {Still} in_colour */
  function show_stills(picture, in_colour) {
    const context = strip.getContext("2d");
    strip.width = STILLS * strip.height;
    for (const { eps, still } of picture.values()) {
      const place = Math.log10(eps) - LEFT - 1;
      if (Number.isInteger(place) && place >= 0 && place < STILLS)
        context?.putImageData(in_colour(still, strip.height), strip.height * place, 0);
    }
  }

  /**
   * Draw what is known, where that is new.
   * @param {State} state
   * @param {Lines} pixel
   * @param {Map<number, PicturePoint>} picture
   * @param {Still} in_colour
   */
  function show(state, pixel, picture, in_colour) {
    const difference = [...picture.values()];
    const what = [pixel, picture, difference.length, svg.clientWidth, svg.clientHeight];
    if (what.every((part, n) => part === drawn[n])) return;
    drawn = what;
    width = svg.clientWidth;
    height = svg.clientHeight;
    bottom = height - 20;
    inset = 0.5 * parseFloat(getComputedStyle(root).getPropertyValue("--thumb")); // where the slider's thumb stops
    svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    lines = difference.length ? { ...pixel, difference } : pixel;
    const paths = Object.entries(lines).map(([name, points]) =>
      line_markup(
        name,
        points.map(({ eps, size }) => [x_of(eps), size > 0 ? y_of(size) : NaN])
      )
    );
    const dots = difference
      .filter(({ size }) => size > 0)
      .map(({ eps, size }) => circle_markup("difference", [x_of(eps), y_of(size)], 2));
    svg.innerHTML = axes() + paths.join("") + dots.join("") + least() + names();
    show_stills(picture, in_colour);
    mark(state.eps);
  }

  /** Move the mark of the present step, and nothing else: the plot is not drawn anew. @param {number} eps */
  function mark(eps) {
    const error = lines.numeric ? size_at(lines.numeric, eps) : 0;
    now.style.transform = `translateX(${x_of(eps)}px)`;
    dot.style.transform = `translate(${x_of(eps)}px, ${y_of(error || 1)}px)`;
    dot.hidden = !error;
    slider.setAttribute("aria-valuetext", read(eps));
  }

  /** The size at the step of a line that is nearest to a step. @param {LinePoint[]} points @param {number} eps */
  function size_at(points, eps) {
    return least_of(points, (point) => Math.abs(Math.log(point.eps / eps))).size;
  }

  /** @param {number} eps */
  function read(eps) {
    const sizes = Object.entries(lines).map(
      ([name, points]) => `${NAMES[name]} ${scientific(size_at(points, eps), 1)}`
    );
    return [`ε = ${scientific(eps, 1)}`, ...sizes].join(" · ");
  }

  // The plot as a picture of its own: what the style sheet says is written into it.
  function picture() {
    const copy = /** @type {SVGSVGElement} */ (svg.cloneNode(true));
    const [from, to] = [svg, copy].map((one) => one.querySelectorAll("*"));
    for (const [n, element] of from.entries()) {
      const style = getComputedStyle(element);
      const names = ["fill", "stroke", "stroke-width", "stroke-dasharray", "font", "text-anchor"];
      to[n].setAttribute("style", names.map((name) => `${name}:${style.getPropertyValue(name)}`).join(";"));
    }
    set_attributes(copy, {
      xmlns: "http://www.w3.org/2000/svg",
      width: width + NAMES_WIDE,
      height,
      viewBox: `0 0 ${width + NAMES_WIDE} ${height}`
    });
    return copy.outerHTML;
  }

  /** Read the step under the pointer. @param {PointerEvent} event */
  function hover(event) {
    const exponent = rescaled(pointer_in(box, event).x, inset, width - inset, LEFT, RIGHT);
    const eps = power_of_ten(clamp(LEFT, exponent, RIGHT));
    pointer.style.transform = `translateX(${x_of(eps)}px)`;
    pointer.hidden = false;
    reading.textContent = read(eps);
  }

  box.addEventListener("pointermove", hover);
  box.addEventListener("pointerleave", () => {
    pointer.hidden = true;
    reading.textContent = at_rest;
  });
  return { COARSE, at_pixel, show, mark, picture };
}

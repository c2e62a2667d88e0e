// The U-curve: error against ε, of the gradient at the cursor and of the picture, with what the theorems allow behind.
// It is a control too: a click, a drag or an arrow key sets ε, and pointing at it reads it.
"use strict";

Simulator.curve = function (root, data, module, act) {
  const box = root.querySelector(".sim-curve"), svg = box.querySelector("svg"), reading = root.querySelector("[data-reading]");
  const [pointer, now, dot] = ["hover", "now", "dot"].map((name) => box.querySelector(`.sim-${name}`));
  const X = [-16, -1], Y = [-16, 2], HEIGHT = 168, EDGE = { top: 10, bottom: 20 }, LINE = 15;
  const FINE = Array.from({ length: 121 }, (_, n) => Number((10 ** (-16 + n / 8)).toPrecision(3)));
  const COARSE = Array.from({ length: 31 }, (_, n) => Number((10 ** (-1 - n / 2)).toPrecision(3)));
  const NAMES = { numeric: "gradient here", bound: "proved bound", difference: "picture, RMS" };
  let width = 0, inset = 0, lines = {}, drawn = []; // name -> [{eps, size}]

  // [{eps, error, bound}] of the gradient at a pixel of A; null elsewhere. A bound is null where nothing is proved.
  function at_pixel(state, raster) {
    const stage = module.make_stage(state, { ...raster, left: state.column, top: state.row, wide: 1, high: 1 });
    if (!stage.count) return null;
    const [[u], [v]] = module.chart(stage), exact = module.gradient(state, { name: "exact" }, stage);
    const bounds = module.bounds(state, u, v, Float64Array.from(FINE))?.[0];
    return FINE.map((eps, n) => {
      const [h_u, h_v] = module.gradient(state, { name: state.method, eps }, stage);
      return { eps, error: Math.max(Math.abs(h_u - exact[0]), Math.abs(h_v - exact[1])), bound: bounds ? bounds[n] : null };
    });
  }

  const x_of = (eps) => inset + ((Math.log10(eps) - X[0]) / (X[1] - X[0])) * (width - 2 * inset);
  const y_of = (size) => EDGE.top + ((Y[1] - Math.max(Y[0], Math.min(Y[1], Math.log10(size)))) / (Y[1] - Y[0])) * (HEIGHT - EDGE.top - EDGE.bottom);

  function path(points) {
    let text = "", drawing = false;
    for (const { eps, size } of points) {
      if (size > 0) text += `${drawing ? "L" : "M"}${x_of(eps).toFixed(1)} ${y_of(size).toFixed(1)}`;
      drawing = size > 0;
    }
    return text;
  }

  const power = (n) => `10<tspan dy="-5" font-size="9">${String(n).replace("-", "−")}</tspan>`;

  function axes() {
    let text = "";
    for (let n = Y[0]; n <= Y[1]; n += 4) {
      const y = y_of(10 ** n);
      text += `<line class="grid" x1="${inset}" x2="${width - inset}" y1="${y}" y2="${y}"/>`;
      text += `<text class="tick" text-anchor="end" x="${inset - 8}" y="${y + 4}">${power(n)}</text>`;
    }
    for (let n = X[0]; n <= X[1]; n += width < 500 ? 5 : 3) {
      text += `<text class="tick" text-anchor="middle" x="${x_of(10 ** n)}" y="${HEIGHT - 4}">${power(n)}</text>`;
    }
    return text;
  }

  // Each line's name stands at its end, to the right of the plot, where no curve is; a line apart from the next name.
  function names() {
    const ends = Object.entries(lines).filter(([, points]) => points.some(({ size }) => size > 0));
    const placed = ends.map(([name, points]) => ({ name, y: y_of(points.reduce((last, p) => (p.eps > last.eps ? p : last)).size || 1e-16) + 4 }));
    placed.sort((one, other) => one.y - other.y);
    placed.forEach((label, n) => (label.y = n ? Math.max(label.y, placed[n - 1].y + LINE) : label.y));
    const over = placed.length ? Math.max(0, placed[placed.length - 1].y - (HEIGHT - EDGE.bottom)) : 0;
    return placed.map(({ name, y }) => `<text class="${name}-label" x="${width + 2}" y="${y - over}">${NAMES[name]}</text>`).join("");
  }

  // state; pixel: what at_pixel gave; picture: [{eps, rms}], as far as it is known.
  function show(state, pixel, picture) {
    const known = picture.filter(Boolean), what = [pixel, picture, known.length, box.clientWidth];
    if (what.every((part, n) => part === drawn[n])) return;
    drawn = what;
    width = box.clientWidth;
    inset = 0.5 * parseFloat(getComputedStyle(root).getPropertyValue("--thumb")); // where the slider's thumb stops
    svg.setAttribute("viewBox", `0 0 ${width} ${HEIGHT}`);
    lines = {};
    if (pixel && pixel[0].bound !== null) lines.bound = pixel.map(({ eps, bound }) => ({ eps, size: bound }));
    if (pixel) lines.numeric = pixel.map(({ eps, error }) => ({ eps, size: error }));
    if (known.length) lines.difference = known.map(({ eps, rms }) => ({ eps, size: rms }));
    const paths = Object.entries(lines).map(([name, points]) => `<path class="${name}" d="${path(points)}"/>`);
    const dots = known.filter((p) => p.rms > 0).map((p) => `<circle class="difference" cx="${x_of(p.eps)}" cy="${y_of(p.rms)}" r="2"/>`);
    svg.innerHTML = axes() + paths.join("") + dots.join("") + names();
    mark(state.eps);
  }

  // Move the mark of the present step, and nothing else: the plot is not drawn anew.
  function mark(eps) {
    const error = lines.numeric ? near(lines.numeric, eps).size : 0;
    now.style.transform = `translateX(${x_of(eps)}px)`;
    dot.style.transform = `translate(${x_of(eps)}px, ${y_of(error || 1)}px)`;
    dot.hidden = !error;
    box.setAttribute("aria-valuenow", Math.log10(eps).toFixed(2));
    box.setAttribute("aria-valuetext", read(eps));
  }

  const near = (points, eps) => points.reduce((best, p) => (Math.abs(Math.log(p.eps / eps)) < Math.abs(Math.log(best.eps / eps)) ? p : best));
  const say = (size) => Number(size).toExponential(1).replace("e-", "e−").replace("e+", "e");
  const read = (eps) => [`ε = ${say(eps)}`, ...Object.entries(lines).map(([name, points]) => `${NAMES[name]} ${say(near(points, eps).size)}`)].join(" · ");

  function csv(pixel, picture) {
    const rms = new Map(picture.filter(Boolean).map((p) => [p.eps, p]));
    const rows = FINE.map((eps, n) => [eps, pixel?.[n].error, pixel?.[n].bound, rms.get(eps)?.rms, rms.get(eps)?.max].join());
    return ["step,gradient_error_at_cursor,bound,rms_on_a,max_on_a", ...rows].join("\n") + "\n";
  }

  // The step under the pointer, or at an exponent.
  const step_at = (exponent) => Number((10 ** Math.max(X[0], Math.min(X[1], exponent))).toPrecision(3));
  function pointed(event) {
    const share = (event.clientX - box.getBoundingClientRect().left - inset) / (width - 2 * inset);
    return step_at(X[0] + share * (X[1] - X[0]));
  }

  function hover(event) {
    const eps = pointed(event);
    pointer.style.transform = `translateX(${x_of(eps)}px)`;
    pointer.hidden = false;
    reading.textContent = read(eps);
    if (event.buttons === 1) act.set({ eps });
  }

  function key(event) {
    const now = Math.log10(act.state().eps);
    const steps = { ArrowRight: now + 0.125, ArrowUp: now + 0.125, ArrowLeft: now - 0.125, ArrowDown: now - 0.125, PageUp: now + 1, PageDown: now - 1, Home: X[0], End: X[1] };
    if (!(event.key in steps) || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    act.set({ eps: step_at(steps[event.key]) });
  }

  box.addEventListener("pointerdown", (event) => {
    box.setPointerCapture(event.pointerId);
    act.set({ eps: pointed(event) });
    hover(event);
  });
  box.addEventListener("pointermove", hover);
  box.addEventListener("pointerleave", () => {
    pointer.hidden = true;
    reading.textContent = "";
  });
  box.addEventListener("keydown", key);
  return { COARSE, FINE, at_pixel, show, mark, csv };
};

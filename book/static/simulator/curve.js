// The U-curve: error against epsilon, of the gradient at the cursor and of the picture, with the proved bounds behind.
"use strict";
var Simulator = Simulator || {};

Simulator.curve = function (root, data, module) {
  const svg = root.querySelector(".sim-curve svg"), X = [-16, -1], Y = [-16, 2], HEIGHT = 230, EDGE = { top: 14, bottom: 24 };
  const FINE = Array.from({ length: 121 }, (_, n) => Number((10 ** (-16 + n / 8)).toPrecision(3)));
  const COARSE = Array.from({ length: 31 }, (_, n) => Number((10 ** (-1 - n / 2)).toPrecision(3)));
  // The standard model's parameters: unit roundoff; what a height is off by (a sine of a product is good to 2 ulp, as
  // verify/ measures; two of them and their product); what rounding u + epsilon moves it by.
  const UNIT = 2 ** -53, HEIGHT_ERROR = 3 * 2 ** -52, ARGUMENT_ERROR = 2 ** -53;


  // What the truncation of h_u and of h_v is at most: where nothing but a smooth piece of the field lies within eps;
  // at the pole, if the field is odd that far; else 2 pi k.
  function truncations(state, [a, b], { u, v }, eps) {
    const { creases } = data.fields[state.field];
    const nearest = (c, at) => Math.min(...creases.filter(([name]) => name === c).map(([, of_ku, of_kv]) => {
      const k = Math.abs(of_ku * state.ku + of_kv * state.kv);
      return Math.abs(k * at - Math.round(k * at)) - k * eps;
    }));
    const seamless = (u - eps >= 0 && u + eps < 1) || a % 2 === 0; // sine and ridges have the period 1 then
    const smooth = [nearest("u", u) >= 0 && seamless, nearest("v", v) >= 0 && v - eps >= 0 && v + eps <= 1];
    const odd = v < eps && v + eps <= 1 && (!creases.length || b * (v + eps) <= 1);
    return [a, b].map((k, n) => {
      const cap = module.kernel("crease_bound", k);
      if (smooth[n]) return Math.min(cap, module.kernel("truncation_bound", eps, k));
      return n === 1 && odd ? Math.min(cap, module.kernel("clamped_bound", eps, v, k)) : cap;
    });
  }

  // The largest error of h_u or h_v that is possible; waves: the wave numbers' sizes.
  function bound(state, waves, at, eps) {
    const cut = truncations(state, waves, at, eps);
    const rounding = (k) => module.kernel("rounding_bound", eps, module.kernel("slope_bound", k), UNIT, HEIGHT_ERROR, ARGUMENT_ERROR);
    return Math.max(...waves.map((k, n) => (k === 0 ? 0 : cut[n] + rounding(k))));
  }

  // [{eps, error, bound}] of the gradient at a pixel of A; null elsewhere.
  function at_pixel(state, raster) {
    const stage = module.make_stage(state, { ...raster, left: state.column, top: state.row, wide: 1, high: 1 });
    if (!stage.count) return null;
    const [[u], [v]] = module.chart(stage), exact = module.gradient(state, { name: "exact" }, stage);
    const waves = state.method === "central" ? module.wave_numbers(state)?.map(Math.abs) : null; // without them nothing is proved
    return FINE.map((eps) => {
      const [h_u, h_v] = module.gradient(state, { name: state.method, eps }, stage);
      const error = Math.max(Math.abs(h_u - exact[0]), Math.abs(h_v - exact[1]));
      return { eps, error, bound: waves ? bound(state, waves, { u, v }, eps) : null };
    });
  }

  let width = 0;
  const left = () => 0.5 * parseFloat(getComputedStyle(root).getPropertyValue("--thumb")) || 12; // where the slider's thumb stops
  const x_of = (eps) => left() + ((Math.log10(eps) - X[0]) / (X[1] - X[0])) * (width - 2 * left());
  const y_of = (size) => EDGE.top + ((Y[1] - Math.max(Y[0], Math.min(Y[1], Math.log10(size)))) / (Y[1] - Y[0])) * (HEIGHT - EDGE.top - EDGE.bottom);

  function path(points) {
    let text = "", drawing = false;
    for (const [eps, size] of points) {
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
      text += `<line class="grid" x1="${left()}" x2="${width - left()}" y1="${y}" y2="${y}"/>`;
      text += `<text class="tick" text-anchor="end" x="${left() - 8}" y="${y + 4}">${power(n)}</text>`;
    }
    for (let n = X[0]; n <= X[1]; n += width < 500 ? 5 : 3) {
      const anchor = n === X[0] ? "start" : n === X[1] ? "end" : "middle";
      text += `<text class="tick" text-anchor="${anchor}" x="${x_of(10 ** n)}" y="${HEIGHT - 6}">${power(n)}</text>`;
    }
    return text;
  }

  // A line's name stands beside it, `shift` pixels lower, at the step where it is `at`.
  function label(text, kind, { eps, size }, shift) {
    const y = Math.max(EDGE.top, Math.min(HEIGHT - EDGE.bottom - 6, y_of(size) + shift));
    return `<text class="${kind}-label" text-anchor="middle" x="${x_of(eps)}" y="${y}">${text}</text>`;
  }

  // state; pixel: what at_pixel gave; picture: [{eps, rms}], as far as it is known.
  function show(state, pixel, picture) {
    width = svg.parentElement.clientWidth;
    svg.setAttribute("viewBox", `0 0 ${width} ${HEIGHT}`);
    const known = picture.filter(Boolean);
    let text = axes() + `<line class="now" y1="${EDGE.top - 8}" y2="${HEIGHT - EDGE.bottom}"/><circle class="numeric" r="4"/>`;
    let names = "";
    if (pixel) {
      const errors = pixel.map((p) => [p.eps, p.error]), cliff = near(pixel, 1e-12);
      if (cliff.bound !== null) {
        text += `<path class="bound" d="${path(pixel.map((p) => [p.eps, p.bound]))}"/>`;
        names += label("proved bound", "bound", { eps: cliff.eps, size: cliff.bound }, -10);
      }
      text += `<path class="numeric" d="${path(errors)}"/>`;
      const floor = near(pixel, 1e-6);
      if (floor.error > 0) names += label("gradient, at the cursor", "numeric", { eps: floor.eps, size: floor.error }, 22);
    }
    if (known.some((p) => p.rms > 0)) {
      text += `<path class="difference" d="${path(known.map((p) => [p.eps, p.rms]))}"/>`;
      text += known.filter((p) => p.rms > 0).map((p) => `<circle class="difference" cx="${x_of(p.eps)}" cy="${y_of(p.rms)}" r="2"/>`).join("");
      const cliff = near(known, 1e-12);
      names += label("picture, RMS on A", "difference", { eps: cliff.eps, size: cliff.rms }, 24);
    }
    svg.innerHTML = text + names;
    mark(state.eps, pixel);
    svg.setAttribute("aria-label", summary(state, pixel, known));
  }

  // Move the mark of the present step, and nothing else.
  function mark(eps, pixel) {
    const line = svg.querySelector(".now"), dot = svg.querySelector("circle.numeric"), error = pixel ? near(pixel, eps).error : 0;
    for (const end of ["x1", "x2"]) line.setAttribute(end, x_of(eps));
    dot.setAttribute("cx", x_of(eps));
    dot.setAttribute("cy", error > 0 ? y_of(error) : -100);
  }

  const near = (points, eps) => points.reduce((best, p) => (Math.abs(Math.log(p.eps / eps)) < Math.abs(Math.log(best.eps / eps)) ? p : best));

  function summary(state, pixel, known) {
    const say = (size) => Number(size).toExponential(1);
    if (!pixel) return "Error against the step. The cursor is not on sphere A.";
    const least = pixel.reduce((best, p) => (p.error > 0 && p.error < best.error ? p : best));
    return `Error against the step. At the cursor the gradient's error is ${say(near(pixel, state.eps).error)} now and least, ` +
      `${say(least.error)}, at a step of ${say(least.eps)}.` + (known.length ? ` The picture is followed at ${known.length} steps.` : "");
  }

  function csv(pixel, picture) {
    const lines = ["step,gradient_error_at_cursor,bound,rms_on_a,max_on_a"];
    const rms = new Map(picture.filter(Boolean).map((p) => [p.eps, p]));
    const at = new Map((pixel || []).map((p) => [p.eps, p]));
    for (const eps of [...new Set([...at.keys(), ...rms.keys()])].sort((a, b) => a - b)) {
      lines.push([eps, at.get(eps)?.error ?? "", at.get(eps)?.bound ?? "", rms.get(eps)?.rms ?? "", rms.get(eps)?.max ?? ""].join(","));
    }
    return lines.join("\n") + "\n";
  }

  return { COARSE, FINE, at_pixel, show, mark, csv };
};

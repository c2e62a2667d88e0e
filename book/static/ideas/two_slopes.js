// One height, two slopes: the secant over a step and the tangent; under a microscope that magnifies by 1/ε, down to
// float64's own steps; and the error against the step. All numbers are float64's.
"use strict";

IDEAS.two_slopes = (stage, module, data) => {
  const { ku, kv } = data.scene;
  const FROM = 0.06;
  const TO = 0.25;
  const V = 1 / 8;
  const HIGH = 260;
  const BASE = 226;
  const TALL = 190;
  const LEAST = -17;
  const MOST = -1.3;
  const LINE = 232; // where the microscope's line of float64 numbers lies
  const SMALLEST = -14; // the exponents of the errors that the U has room for
  const LARGEST = 2;
  const across = float64s(401, (n) => n / 100 - 2); // what the microscope shows, in steps
  const steps = float64s(316, (n) => 10 ** (LEAST + n / 20));
  const curve = float64s(381, (n) => FROM + (n * (TO - FROM)) / 380);
  const RANGE = [FROM + 0.02, TO - 0.02];
  const STEPS = [10 ** LEAST, 10 ** MOST];
  let u = 0.139;
  let eps = 0.03;

  /** @param {number | Float64Array} at @param {number | Float64Array} step */
  const slopes = (at, step) => module.own.kernel_over("two_slopes", at, V, ku, kv, step);

  /** @param {number} to_u @param {number} to_eps */
  function set(to_u, to_eps) {
    u = clamp(RANGE[0], to_u, RANGE[1]);
    eps = clamp(STEPS[0], to_eps, STEPS[1]);
    put_eps(Math.log10(eps));
    stage.redraw();
  }

  const sides = add_element(stage.root, "div", { class: "idea-thirds" });
  const panel = stage.panel("The height across a crease, a tangent and a secant", HIGH, sides);
  const lens = stage.panel("The same point, magnified by 1/ε", HIGH, sides);
  const curve_of_errors = stage.panel("The error of the difference against the step", HIGH, sides);
  for (const { box } of [panel, lens]) box.classList.add("idea-clipped");
  const range = { min: LEAST, max: MOST, step: 0.01, value: Math.log10(eps) };
  const put_eps = stage.slider(
    "step ε",
    range,
    (to) => set(u, 10 ** to),
    (exponent) => in_powers(10 ** exponent, 1)
  );
  const says = stage.says();
  /** @param {number} at @param {number} height @returns {Point} */
  const place = (at, height) => [rescaled(at, FROM, TO, 0, panel.width()), BASE - TALL * height];
  /** @param {number} x */
  const at_x = (x) => rescaled(x, 0, panel.width(), FROM, TO);
  const put_step = panel.handle(
    "the step, ε",
    STEPS,
    (x) => set(u, at_x(x) - u),
    (right, up) => set(u, eps * 1.1 ** (right + up)),
    "step"
  );
  // Over the step's, which a slider moves, too: at a tiny step the two are in one place.
  const put_point = panel.handle(
    "the point, u",
    RANGE,
    (x) => set(Math.round(2000 * at_x(x)) / 2000, eps),
    (right) => set(u + right / 2000, eps)
  );

  /**
   * A line through a point of the drawing, so long to either side, whatever its slope.
   * @param {Point} point
   * @param {number} slope
   * @param {string} look
   * @param {number} reach
   */
  function through([x, y], slope, look, reach) {
    const run = panel.width() / (TO - FROM);
    const rise = -TALL * slope;
    const share = reach / Math.hypot(run, rise);
    const ends = [-share, share].map((part) => /** @type {Point} */ ([x + part * run, y + part * rise]));
    return line_markup(look, ends);
  }

  /** The staircase of h and the float64 numbers beside u, in units of the step. @param {number} h @param {number} exact @param {number[]} ends */
  function magnified(h, exact, ends) {
    const unit = lens.width() / 4;
    /** @param {number} x @param {number} height @returns {Point} */
    const at = (x, height) => [unit * (x + 2), clamp(18, 112 - (46 * (height - h)) / (Math.PI * ku * eps), 206)];
    const asked = across.map((x) => u + x * eps);
    const [, heights] = slopes(asked, eps);
    const spacing = 2 ** (Math.floor(Math.log2(u)) - 52);
    const few = Math.ceil((2 * eps) / spacing);
    const ticks = Array.from(
      float64s(few < 40 ? 2 * few + 1 : 0, (n) => unit * (2 + ((n - few) * spacing) / eps)),
      (x) => `M${x.toFixed(2)} ${LINE - 6}v12`
    );
    const samples = [-1, 1].map((side, n) => {
      const taken = unit * (2 + (u + side * eps - u) / eps);
      return (
        path_markup("guide", `M${unit * (2 + side)} 20V${LINE}L${taken} ${LINE}`) +
        circle_markup("end", at(side, ends[n]), 5) +
        circle_markup("end", [taken, LINE], 5)
      );
    });
    lens.show(
      text_at(0, 12, `a window of 4ε, magnified ${eps > 0.001 ? Math.round(1 / eps) : in_powers(1 / eps, 1)} times`) +
        line_markup(
          "height",
          Array.from(across, (x, n) => at(x, heights[n]))
        ) +
        line_markup("slope", [at(-2, h - 2 * exact * eps), at(2, h + 2 * exact * eps)]) +
        line_markup("secant", [at(-1, ends[0]), at(1, ends[1])]) +
        path_markup("few", `M0 ${LINE}H${4 * unit}${ticks.join("")}`) +
        samples.join("") +
        text_at(
          0,
          HIGH - 6,
          ticks.length ? "the float64 numbers beside u" : "float64 numbers, closer than this line shows"
        )
    );
  }

  /** The U of this point, the proved bounds of its three parts, and where the step is. @param {number} exact @param {number} apart */
  function errors(exact, apart) {
    const wide = curve_of_errors.width() - 38;
    /** @param {number} step @param {number} size @returns {Point} */
    const at = (step, size) => [
      rescaled(Math.log10(step), LEAST, MOST, 34, 34 + wide),
      rescaled(clamp(SMALLEST, Math.log10(size), LARGEST), LARGEST, SMALLEST, 20, 220)
    ];
    const found = slopes(u, steps)[3].map((numeric) => Math.abs(numeric - exact));
    const parts = module.own.kernel_over("slope_parts", u, V, ku, kv, steps);
    const bounds = parts.map((sizes) =>
      line_markup(
        "bound",
        Array.from(steps, (step, n) => at(step, sizes[n])).filter(([, y]) => y < 219)
      )
    );
    const [turn, up] = at(3e-14, 0.06);
    const [foot, down] = at(1e-13, 1e-13);
    const names =
      text_at(turn, up, "rounded <tspan class='i'>u</tspan> ± ε, rounded <tspan class='i'>h</tspan>") +
      text_at(foot, down, "too far");
    const grid = [-12, -8, -4, 0].map((power) => {
      const [, y] = at(1, 10 ** power);
      return path_markup("few", `M34 ${y}h${wide}`) + text_at(0, y + 4, ten_to(power), "tick");
    });
    const feet = [-16, -12, -8, -4].map((power) => text_at(at(10 ** power, 1)[0] - 12, 240, ten_to(power), "tick"));
    const dots = Array.from(found, (size, n) => (size ? circle_markup("end", at(steps[n], size), 1.3) : ""));
    const now = at(eps, apart);
    curve_of_errors.show(
      text_at(34, 12, "the error against ε") +
        grid.join("") +
        feet.join("") +
        bounds.join("") +
        names +
        dots.join("") +
        circle_markup("met", now, 6)
    );
  }

  return () => {
    const [, heights] = slopes(curve, eps);
    const [left, h, right, numeric, exact, straddles] = slopes(u, eps).map(([number]) => number);
    const point = place(u, h);
    const start = place(u - eps, left);
    const end = place(u + eps, right);
    const [crease] = place(1 / ku, 0);
    const points = Array.from(curve, (at, n) => place(at, heights[n]));
    const reach = Math.max(80, Math.hypot(end[0] - start[0], end[1] - start[1]) / 2);
    panel.show(
      path_markup("guide", `M${crease} 12V${HIGH}`) +
        text_at(crease + (u * ku < 1 ? -44 : 6), BASE + 24, "crease") + // on the side that no line through u meets below
        line_markup("height", points) +
        through(place(u, (left + right) / 2), numeric, "secant", 24 + reach) +
        through(point, exact, "slope", 100) +
        circle_markup("end", start, 5)
    );
    magnified(h, exact, [left, right]);
    const apart = Math.abs(numeric - exact);
    errors(exact, apart);
    const digits = apart < 0.01 ? 8 : 3;
    says.innerHTML =
      `The difference over 2ε is <b class="numeric">${decimal(numeric, digits)}</b>, ` +
      `the slope is <b class="symbolic">${decimal(exact, digits)}</b>: they are ` +
      `<b class="difference">${apart < 0.01 ? in_powers(apart, 1) : decimal(apart)}</b> apart` +
      `${straddles ? ", since the step reaches across the crease" : ""}${u + eps === u ? ": float64 takes no step" : ""}.`;
    put_point(point, u, `u ${decimal(u, 4)}, slope ${decimal(exact)}`);
    put_step(end, eps, `ε ${in_powers(eps, 1)}, difference ${decimal(numeric)}`);
  };
};

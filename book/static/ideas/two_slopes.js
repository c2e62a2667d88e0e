// One height, two slopes: the secant over a step and the tangent, at a smooth point and beside a crease.
"use strict";

IDEAS.two_slopes = (stage, module, data) => {
  const { ku, kv } = data.scene;
  const FROM = 0.06;
  const TO = 0.25;
  const V = 1 / 8;
  const HIGH = 260;
  const TOP = 12;
  const BASE = 226;
  const TALL = 190;
  const LEAST = -15;
  const MOST = -1.3;
  const curve = float64s(381, (n) => FROM + (n * (TO - FROM)) / 380);
  let u = 0.139;
  let eps = 0.03;

  /** @param {number} number */
  function in_powers(number) {
    const [digits, power] = number.toExponential(1).split("e");
    return `${digits} · 10${raised(Number(power))}`;
  }

  /** @param {number} to_u @param {number} to_eps */
  function set(to_u, to_eps) {
    u = clamp(FROM + 0.02, to_u, TO - 0.02);
    eps = clamp(10 ** LEAST, to_eps, 10 ** MOST);
    put_eps(Math.log10(eps));
    stage.redraw();
  }

  const panel = stage.panel("The height across a crease, a tangent and a secant", HIGH);
  const range = { min: LEAST, max: MOST, step: 0.01, value: Math.log10(eps) };
  const put_eps = stage.slider(
    "step ε",
    range,
    (to) => set(u, 10 ** to),
    (exponent) => in_powers(10 ** exponent)
  );
  const says = stage.says();
  /** @param {number} at @param {number} height @returns {Point} */
  const place = (at, height) => [((at - FROM) / (TO - FROM)) * panel.width(), BASE - TALL * height];
  /** @param {number} x */
  const at_x = (x) => FROM + (x / panel.width()) * (TO - FROM);
  const put_point = panel.handle(
    "the point, u",
    (x) => set(Math.round(2000 * at_x(x)) / 2000, eps),
    (right) => set(u + right / 2000, eps)
  );
  const put_step = panel.handle(
    "the step, ε",
    (x) => set(u, at_x(x) - u),
    (right, up) => set(u, eps * 1.1 ** (right + up)),
    "step"
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

  return () => {
    const [, heights] = module.own.kernel_over("two_slopes", curve, V, ku, kv, eps);
    const [left, h, right, numeric, exact, straddles] = module.own.kernel("two_slopes", u, V, ku, kv, eps);
    const point = place(u, h);
    const start = place(u - eps, left);
    const end = place(u + eps, right);
    const [crease] = place(1 / ku, 0);
    const points = Array.from(curve, (at, n) => place(at, heights[n]));
    const reach = Math.max(80, Math.hypot(end[0] - start[0], end[1] - start[1]) / 2);
    panel.show(
      path_markup("guide", `M${crease} ${TOP}V${BASE + 8}`) +
        text_at(crease - 20, BASE + 24, "crease") +
        line_markup("height", points) +
        through(place(u, (left + right) / 2), numeric, "secant", 24 + reach) +
        through(point, exact, "slope", 100) +
        circle_markup("end", start, 5)
    );
    const apart = Math.abs(numeric - exact);
    const digits = apart && apart < 0.01 ? 8 : 2;
    says.innerHTML =
      `The difference over 2ε is <b class="numeric">${decimal(numeric, digits)}</b>, ` +
      `the slope is <b class="symbolic">${decimal(exact, digits)}</b>: they are ` +
      `<b class="difference">${apart < 0.01 ? in_powers(apart) : decimal(apart)}</b> apart` +
      `${straddles ? ", since the step reaches across the crease" : ""}.`;
    put_point(point, u, `u ${decimal(u, 4)}, slope ${decimal(exact)}`);
    put_step(end, eps, `ε ${in_powers(eps)}, difference ${decimal(numeric)}`);
  };
};

// One height, two slopes: the secant over a step and the tangent, at a smooth point and beside a crease.
"use strict";
var Ideas = Ideas || {};

Ideas.two_slopes = function (figure, module, data) {
  const { scene } = data, { say, line, text } = Ideas, [FROM, TO, V, HIGH, TOP, BASE, TALL] = [0.06, 0.25, 1 / 8, 260, 12, 226, 190], EXPONENTS = [-15, -1.3];
  const curve = Float64Array.from({ length: 381 }, (_, n) => FROM + (n * (TO - FROM)) / 380);
  let u = 0.139, eps = 0.03;

  const power = (number) => Number(number).toExponential(1).replace("-", "−").replace("e", " · 10^").replace(/\^(.*)/, (_, n) => n.replace(/./g, (digit) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["−0123456789".indexOf(digit)]));
  const stage = Ideas.stage(figure, draw), panel = stage.panel("The height across a crease, a tangent and a secant", HIGH);
  const give_eps = stage.slider("step ε", { min: EXPONENTS[0], max: EXPONENTS[1], step: 0.01, value: Math.log10(eps) }, (to) => set(u, 10 ** to), (exponent) => power(10 ** exponent)), says = stage.says();
  const x_of = (at) => ((at - FROM) / (TO - FROM)) * panel.width, at_x = (x) => FROM + (x / panel.width) * (TO - FROM), y_of = (h) => BASE - TALL * h;
  const on_point = panel.handle("the point, u", (x) => set(Math.round(2000 * at_x(x)) / 2000, eps), (right) => set(u + right / 2000, eps));
  const on_step = panel.handle("the step, ε", (x) => set(u, at_x(x) - u), (right, up) => set(u, eps * 1.1 ** (right + up)), "step");

  function set(to_u, to_eps) {
    [u, eps] = [Math.max(FROM + 0.02, Math.min(TO - 0.02, to_u)), Math.max(10 ** EXPONENTS[0], Math.min(10 ** EXPONENTS[1], to_eps))];
    give_eps(Math.log10(eps));
    stage.redraw();
  }
  const at = (along) => module.kernel("two_slopes", along, V, scene.ku, scene.kv, eps);

  // A line through a point of the drawing, so long to either side, whatever its slope.
  function through(along, height, slope, look, reach) {
    const rise = [x_of(FROM + 1) - x_of(FROM), -TALL * slope], share = reach / Math.hypot(...rise), [x, y] = [x_of(along), y_of(height)];
    return `<path class="${look}" d="${line([[x - share * rise[0], y - share * rise[1]], [x + share * rise[0], y + share * rise[1]]])}"/>`;
  }

  function draw() {
    const [, heights] = at(curve), [left, h, right, numeric, exact, straddles] = at(u), ends = [[x_of(u - eps), y_of(left)], [x_of(u + eps), y_of(right)]], crease = x_of(1 / scene.ku);
    panel.show(
      `<path class="guide" d="M${crease} ${TOP}V${BASE + 8}"/>` + text(crease - 20, BASE + 24, "crease") + `<path class="height" d="${line(Array.from(curve, (a, n) => [x_of(a), y_of(heights[n])]))}"/>` +
        through(u, (left + right) / 2, numeric, "secant", 24 + Math.max(80, Math.hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]) / 2)) + through(u, h, exact, "slope", 100) + `<circle class="end" cx="${ends[0][0]}" cy="${ends[0][1]}" r="5"/>`,
    );
    const apart = Math.abs(numeric - exact), digits = apart && apart < 0.01 ? 8 : 2;
    says.innerHTML = `The difference over 2ε is <b class="numeric">${say(numeric, digits)}</b>, the slope is <b class="symbolic">${say(exact, digits)}</b>: they are <b class="difference">${apart < 0.01 ? power(apart) : say(apart)}</b> apart${straddles ? ", since the step reaches across the crease" : ""}.`;
    on_point([x_of(u), y_of(h)], u, `u ${say(u, 4)}, slope ${say(exact)}`);
    on_step(ends[1], eps, `ε ${power(eps)}, difference ${say(numeric)}`);
  }

  stage.begin();
};

// A height field along a circle of the sphere, the normals that its slope tilts, and the light that they catch:
// the surface's own, which no height changes.
"use strict";

IDEAS.slope_is_texture = (stage, module, data) => {
  const { ku, kv, radius, lights } = data.scene;
  const V = 1 / 8;
  const HIGH = 336;
  const EDGE = 8;
  const HEIGHTS = { top: 70, high: 72 };
  const FLAT = 222;
  const all = float64s(513, (n) => n / 512);
  const between = float64s(512, (n) => (n + 0.5) / 512);
  const few = float64s(2 * ku, (n) => (n + 0.65 - 0.3 * (n % 2)) / (2 * ku)); // so near the tops that they do not cross
  const RANGE = [0, 1 - 1 / 4096];
  let u = 0.453;
  let { beta } = data.balls;
  let raised = 0;

  /** @param {number} to_u @param {number} to_beta */
  function set(to_u, to_beta) {
    u = clamp(RANGE[0], to_u, RANGE[1]);
    beta = clamp(0, to_beta, 0.5);
    put_beta(beta);
    stage.redraw();
  }
  /** @type {Stepped} */
  const step = (right, up) => set(u + right / 256, beta + up / 200);
  /** @param {number} x */
  const u_at = (x) => Math.round((1024 * (x - EDGE)) / (profile.width() - 2 * EDGE)) / 1024;

  const profile = stage.panel("The height along the circle, and its slope", HIGH);
  const range = { min: 0, max: 0.5, step: 0.005 };
  const put_beta = stage.slider("bump β", { ...range, value: beta }, (to) => set(u, to));
  stage.slider("raised by", { ...range, value: raised }, (to) => {
    raised = to;
  });
  const says = stage.says();
  const on_profile = profile.handle("the point on the circle, u", RANGE, (x) => set(u_at(x), beta), step);

  /** @param {number | Float64Array} along @param {number} amount */
  const over = (along, amount) =>
    module.own.kernel_over("bump_at", along, V, ku, kv, amount, radius, ...lights[0].position);
  /** @param {number} amount */
  const at_point = (amount) => over(u, amount).map(([number]) => number);

  /** What light each place between two of the circle catches, in a row. @param {number} top @param {number} high @param {Float64Array} cosines */
  function strip(top, high, cosines) {
    const colors = Array.from(cosines, (mu) => `color(srgb-linear${` ${mu.toFixed(4)}`.repeat(3)})`);
    const wide = (profile.width() - 2 * EDGE) / cosines.length;
    return (
      `<foreignObject x="${EDGE + wide / 2}" y="${top}" width="${wide * (cosines.length - 1)}" height="${high}">` +
      `<div style="height: 100%; background: linear-gradient(to right, ${colors})"></div></foreignObject>`
    );
  }

  /**
   * The normal of the flat surface, tilted: its foot, how long it is, and how far it leans to the right.
   * @param {number} x
   * @param {number} slope
   * @param {number} tilt
   * @param {number} length
   * @param {string} look
   */
  function normal(x, slope, tilt, length, look) {
    const turn = (-Math.sign(slope * beta) * tilt * Math.PI) / 180;
    return arrow_path([x, FLAT], [x + length * Math.sin(turn), FLAT - length * Math.cos(turn)], look, length / 5);
  }

  return () => {
    const width = profile.width() - 2 * EDGE;
    /** @param {number} along @param {number} h @returns {Point} */
    const at = (along, h) => [EDGE + along * width, HEIGHTS.top + (1 - h - raised) * HEIGHTS.high];
    const [heights] = over(all, beta);
    const [, slopes, , tilts] = over(few, beta);
    const [, , , , cosines] = over(between, beta);
    const [, , , , plain] = over(between, 0);
    const [h, steep, slope, tilt, mu] = at_point(beta);
    const [, , , , before] = at_point(0);
    const point = at(u, h);
    const points = Array.from(all, (along, n) => at(along, heights[n]));
    const reach = 26 / Math.hypot(width, steep * HEIGHTS.high);
    const tangent = [at(u - reach, h - reach * steep), at(u + reach, h + reach * steep)];
    const normals = Array.from(few, (along, n) => normal(at(along, 0)[0], slopes[n], tilts[n], 24, "few"));
    profile.show(
      text_at(EDGE, 16, "the height <tspan class='i'>h</tspan>, and its slope at the point") +
        line_markup("height", points) +
        line_markup("slope", tangent) +
        line_markup("guide", [point, [point[0], HIGH]]) +
        text_at(EDGE, 170, "the surface stays flat; its normals lean") +
        path_markup("height", `M${EDGE} ${FLAT}h${width}`) +
        normals.join("") +
        normal(point[0], slope, tilt, 40, "slope") +
        text_at(EDGE, 256, "the light without the bump") +
        strip(262, 18, plain) +
        text_at(EDGE, 298, "and with it") +
        strip(304, 32, cosines)
    );
    const words = `slope ${decimal(slope)}, tilt ${decimal(tilt, 1)}°`;
    on_profile(point, u, words);
    says.innerHTML =
      `slope <b class="symbolic">${decimal(slope)}</b> × β ${decimal(beta, 3)} = ${decimal(slope * beta)}: ` +
      `the normal leans by <b class="symbolic">${decimal(tilt, 1)}°</b>, ` +
      `and the light there goes from ${decimal(before)} to <b>${decimal(mu)}</b>.`;
  };
};

// A height field along a circle of the sphere, the normals that its slope tilts, and the light that they catch.
"use strict";

IDEAS.slope_is_texture = (stage, module, data) => {
  const { ku, kv, radius, eye, beta: first_beta, lights } = data.scene;
  const V = 1 / 8;
  const SIZE = 300;
  const EDGE = 8;
  const HEIGHTS = { top: 34, high: 72 };
  const FLAT = 186;
  const raster = { width: 360, height: 360, left: 30, top: 4, wide: SIZE, high: SIZE };
  const all = float64s(513, (n) => n / 512);
  const between = float64s(512, (n) => (n + 0.5) / 512);
  const few = float64s(2 * ku, (n) => (n + 0.25 + 0.5 * (n % 2)) / (2 * ku)); // beside the creases: they do not cross
  const RANGE = [0, 1 - 1 / 4096];
  let u = 0.453;
  let beta = first_beta;
  let drawn = NaN;

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

  const sides = add_element(stage.root, "div", { class: "idea-sides" });
  const profile = stage.panel("The height along the circle, and its slope", SIZE, sides);
  const sphere = stage.panel("The sphere", SIZE, sides);
  sphere.box.classList.add("idea-picture");
  const paint = stage.picture(sphere.box, SIZE, "the sphere with its bump under the first light");
  const range = { min: 0, max: 0.5, step: 0.005, value: beta };
  const put_beta = stage.slider("bump β", range, (to) => set(u, to));
  const says = stage.says();
  const on_profile = profile.handle("the point on the circle, u", RANGE, (x) => set(u_at(x), beta), step);
  const on_sphere = sphere.handle("the point on the sphere, u", RANGE, (x, y) => set(nearest(x, y), beta), step);

  /** @param {number | Float64Array} along @param {number} amount */
  const over = (along, amount) =>
    module.own.kernel_over("bump_at", along, V, ku, kv, amount, radius, ...lights[0].position);
  /** @param {number} amount */
  const at_point = (amount) => over(u, amount).map(([number]) => number);

  // Where a point of the circle is in the picture.
  const place_in_picture = module.placing_in(raster);
  /** @param {number} along */
  function place(along) {
    const [x, y] = module.kernel("crease_point", 1, 0, along, V, eye, radius);
    return place_in_picture(x, y);
  }
  const [xs, ys] = module.kernel_over("crease_point", 1, 0, all, V, eye, radius);
  const circle = Array.from(xs, (x, n) => place_in_picture(x, ys[n]));

  /** @param {number} x @param {number} y */
  function nearest(x, y) {
    return all[circle.indexOf(least_of(circle, ([a, b]) => Math.hypot(a - x, b - y)))];
  }

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
    const turn = (Math.sign(slope * beta) * tilt * Math.PI) / 180;
    return arrow_path([x, FLAT], [x + length * Math.sin(turn), FLAT - length * Math.cos(turn)], look, length / 5);
  }

  return () => {
    const width = profile.width() - 2 * EDGE;
    /** @param {number} along @param {number} h @returns {Point} */
    const at = (along, h) => [EDGE + along * width, HEIGHTS.top + (1 - h) * HEIGHTS.high];
    const [heights] = over(all, beta);
    const [, slopes, , tilts] = over(few, beta);
    const [, , , , cosines] = over(between, beta);
    const [, , , , plain] = over(between, 0);
    const [h, slope, , tilt, mu] = at_point(beta);
    const [, , , , before] = at_point(0);
    const point = at(u, h);
    const points = Array.from(all, (along, n) => at(along, heights[n]));
    const reach = 26 / Math.hypot(width, slope * HEIGHTS.high);
    const tangent = [at(u - reach, h - reach * slope), at(u + reach, h + reach * slope)];
    const normals = Array.from(few, (along, n) => normal(at(along, 0)[0], slopes[n], tilts[n], 24, "few"));
    profile.show(
      text_at(EDGE, 16, "the height <tspan class='i'>h</tspan>, and its slope at the point") +
        line_markup("height", points) +
        line_markup("slope", tangent) +
        line_markup("guide", [point, [point[0], SIZE]]) +
        text_at(EDGE, 134, "the surface stays flat; its normals lean") +
        path_markup("height", `M${EDGE} ${FLAT}h${width}`) +
        normals.join("") +
        normal(point[0], slope, tilt, 40, "slope") +
        text_at(EDGE, 220, "the light without the bump") +
        strip(226, 18, plain) +
        text_at(EDGE, 262, "and with it") +
        strip(268, 32, cosines)
    );
    sphere.show(line_markup("circle", circle));
    if (drawn !== beta) paint(module, scene_state(data, { beta, ball: 0, lights: [true, false] }), raster);
    drawn = beta;
    const words = `slope ${decimal(slope)}, tilt ${decimal(tilt, 1)}°`;
    on_profile(point, u, words);
    on_sphere(place(u), u, words);
    says.innerHTML =
      `slope <b class="symbolic">${decimal(slope)}</b> × β ${decimal(beta, 3)} = ${decimal(slope * beta)}: ` +
      `the normal leans by <b class="symbolic">${decimal(tilt, 1)}°</b>, ` +
      `and the light there goes from ${decimal(before)} to <b>${decimal(mu)}</b>.`;
  };
};

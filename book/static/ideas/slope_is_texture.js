// A height field along a circle of the sphere, the normals that its slope tilts, and the light that they catch.
"use strict";
var Ideas = Ideas || {};

Ideas.slope_is_texture = function (figure, module, data) {
  const { scene } = data, V = 1 / 8, SIZE = 300, RASTER = { width: 360, height: 360, left: 30, top: 4, wide: SIZE, high: SIZE };
  const { say, line, arrow, text } = Ideas, COUNT = 513, light = scene.lights[0].position;
  const spread = (count, from, over) => Float64Array.from({ length: count }, (_, n) => (n + from) / over);
  const all = spread(COUNT, 0, COUNT - 1), between = spread(COUNT - 1, 0.5, COUNT - 1), few = spread(4 * scene.ku, 0.5, 4 * scene.ku);
  let u = 0.453, beta = scene.beta, drawn = null;

  const stage = Ideas.stage(figure, draw), sides = Ideas.make(stage.root, "div", { class: "idea-sides" });
  const profile = stage.panel("The height along the circle, and its slope", SIZE, sides), sphere = stage.panel("The sphere", SIZE, sides);
  sphere.box.classList.add("idea-picture");
  const paint = stage.picture(sphere.box, SIZE, "the sphere with its bump under the first light");
  const give_beta = stage.slider("bump β", { min: 0, max: 0.5, step: 0.005, value: beta }, (to) => set(u, to), (b) => say(b, 3)), says = stage.says();
  const on_profile = profile.handle("the point on the circle, u", (x) => set(Math.round((1024 * (x - EDGE)) / (profile.width - 2 * EDGE)) / 1024, beta), step);
  const on_sphere = sphere.handle("the point on the sphere, u", (x, y) => set(nearest(x, y), beta), step);
  const EDGE = 8, H = { top: 34, high: 72 }, FLAT = 186, STRIPS = [[226, 18], [268, 32]];

  function set(to_u, to_beta) {
    [u, beta] = [Math.max(0, Math.min(1 - 1 / 4096, to_u)), Math.max(0, Math.min(0.5, to_beta))];
    give_beta(beta);
    stage.redraw();
  }
  function step(right, up) {
    set(u + right / 256, beta + up / 200);
  }

  const at = (along, amount) => module.kernel("bump_at", along, V, scene.ku, scene.kv, amount, scene.radius, ...light);
  // Where a point of the circle is in the picture.
  const [[x0, x1], [y0, y1]] = module.image_points({ ...RASTER, wide: 2, high: 2 });
  function place(along) {
    const [x, y] = module.kernel("crease_point", 1, 0, along, V, scene.eye, scene.radius);
    return [(x - x0) / (x1 - x0) + 0.5, (y - y0) / (y1 - y0) + 0.5];
  }
  const circle = Array.from(all, place), near = ([a, b], x, y) => Math.hypot(a - x, b - y);
  const nearest = (x, y) => all[circle.reduce((best, point, n) => (near(point, x, y) < near(circle[best], x, y) ? n : best), 0)];

  const grey = (mu) => `color(srgb-linear ${mu} ${mu} ${mu})`;
  function strip([top, high], lights, width) {
    const wide = width / lights.length;
    return Array.from(lights, (mu, n) => `<rect x="${(EDGE + n * wide).toFixed(2)}" y="${top}" width="${(wide + 0.6).toFixed(2)}" height="${high}" fill="${grey(mu)}"/>`).join("");
  }

  // The normal of the flat surface, tilted: its foot, how long it is, and how far it leans to the right.
  function normal(x, slope, tilt, length, look) {
    const turn = (Math.sign(slope * beta) * tilt * Math.PI) / 180;
    return arrow([x, FLAT], [length * Math.sin(turn), -length * Math.cos(turn)], look, length / 5);
  }

  function draw() {
    const wide = profile.width, width = wide - 2 * EDGE, x_of = (along) => EDGE + along * width, y_of = (h) => H.top + (1 - h) * H.high;
    const [heights] = at(all, beta), [, , , , lights] = at(between, beta), [, , , , plain] = at(between, 0), [h, slope, , tilt, mu] = at(u, beta), [, , , , before] = at(u, 0);
    const [, slopes, , tilts] = at(few, beta);
    const reach = 26 / Math.hypot(width, slope * H.high), tangent = [-1, 1].map((side) => [x_of(u + side * reach), y_of(h + side * reach * slope)]);
    profile.show(
      text(EDGE, 16, "the height <tspan class='i'>h</tspan>, and its slope at the point") + `<path class="height" d="${line(Array.from(all, (a, n) => [x_of(a), y_of(heights[n])]))}"/><path class="slope" d="${line(tangent)}"/>` +
        `<path class="guide" d="M${x_of(u)} ${y_of(h)}V${SIZE}"/>` + text(EDGE, 134, "the surface stays flat; its normals lean") +
        `<path class="height" d="M${EDGE} ${FLAT}h${width}"/>` + Array.from(few, (a, n) => normal(x_of(a), slopes[n], tilts[n], 24, "few")).join("") + normal(x_of(u), slope, tilt, 40, "slope") +
        text(EDGE, 220, "the light without the bump") + strip(STRIPS[0], plain, width) + text(EDGE, 262, "and with it") + strip(STRIPS[1], lights, width),
    );
    sphere.show(`<path class="circle" d="${line(circle)}"/>`);
    if (drawn !== beta) paint(module, Ideas.state(data, { beta, ball: false, lights: [true, false] }), RASTER);
    drawn = beta;
    const words = `slope ${say(slope)}, tilt ${say(tilt, 1)}°`;
    on_profile([x_of(u), y_of(h)], u, words);
    on_sphere(place(u), u, words);
    says.innerHTML = `slope <b class="symbolic">${say(slope)}</b> × β ${say(beta, 3)} = ${say(slope * beta)}: the normal leans by <b class="symbolic">${say(tilt, 1)}°</b>, and the light there goes from ${say(before)} to <b>${say(mu)}</b>.`;
  }

  stage.begin();
};

// N, the tangent vector βg and M = N + βg at a point of the sphere, in a drawing that can be turned and pulled.
"use strict";
var Ideas = Ideas || {};

Ideas.tilted_frame = function (figure, module, data) {
  const { scene } = data, { say, line, arrow, text, vector } = Ideas, HIGH = 400, MOST = 0.5, WHOLE = 2 * Math.PI;
  let u = 0.53, v = 0.2, beta = 0.07, turn = 0.95, tip = 0.42; // the eye: how far around, how far up
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2], within = (low, number, high) => Math.max(low, Math.min(high, number));
  const along = (at, ...parts) => at.map((p, n) => p + parts.reduce((sum, [share, d]) => sum + share * d[n], 0));

  const stage = Ideas.stage(figure, draw), sides = Ideas.make(stage.root, "div", { class: "idea-sides" });
  const panel = stage.panel("The normal at a point, and what the slope makes of it", HIGH, sides), list = Ideas.make(sides, "dl", { class: "idea-values" });
  const give_beta = stage.slider("bump β", { min: 0, max: MOST, step: 0.005, value: beta }, (to) => set({ beta: to }), (b) => say(b, 3));
  panel.box.classList.add("idea-turned");
  let from = [0, 0];
  const turned = panel.backdrop("the view: drag, or press arrow keys, to turn it", (x, y, begins) => {
    if (!begins) look(turn - (x - from[0]) / 150, tip + (y - from[1]) / 150);
    from = [x, y];
  }, (right, up) => look(turn - right / 20, tip - up / 20));
  const on_point = panel.handle("the point of the sphere, u and v", pulled, (right, up) => set({ u: u + right / 256, v: v - up / 256 }));
  const on_tip = panel.handle("the tip of M, that is β", stretched, (right, up) => set({ beta: beta + (right + up) / 200 }), "second");

  function look(to_turn, to_tip) {
    [turn, tip] = [((to_turn % WHOLE) + WHOLE) % WHOLE, within(-0.2, to_tip, 1.5)];
    stage.redraw();
  }
  function set(to) {
    u = (((to.u ?? u) % 1) + 1) % 1;
    v = within(0.01, to.v ?? v, 0.99);
    beta = within(0, to.beta ?? beta, MOST);
    give_beta(beta);
    stage.redraw();
  }

  // The directions to the right of the drawing, up in it, and towards the eye; where a point is in it.
  function view() {
    const [c, s, ct, st] = [Math.cos(turn), Math.sin(turn), Math.cos(tip), Math.sin(tip)], right = [-s, c, 0], up = [-st * c, -st * s, ct], toward = [ct * c, ct * s, st];
    const size = Math.min(150, 0.3 * panel.width), middle = [0.5 * panel.width, HIGH - size - 14];
    return { right, up, toward, size, middle, place: (p) => [middle[0] + size * dot(p, right), middle[1] - size * dot(p, up)] };
  }

  function pulled(x, y) {
    const { right, up, toward, size, middle } = view(), a = (x - middle[0]) / size, b = (middle[1] - y) / size, far = Math.hypot(a, b), in_reach = far > 0.999 ? 0.999 / far : 1;
    const p = along([0, 0, 0], [a * in_reach, right], [b * in_reach, up], [Math.sqrt(1 - (far * in_reach) ** 2), toward]);
    const [to_u, to_v] = module.kernel("chart", p[0], p[1], p[2], Math.hypot(p[0], p[1]));
    set({ u: to_u, v: to_v });
  }

  function stretched(x, y) {
    const { place } = view(), { normal, g } = values(), [foot, end] = [place(along(normal, [1, normal])), place(along(normal, [1, normal], [1, g]))];
    const d = [end[0] - foot[0], end[1] - foot[1]], length = Math.hypot(...d);
    if (length > 1) set({ beta: ((x - foot[0]) * d[0] + (y - foot[1]) * d[1]) / length ** 2 });
  }

  function values() {
    const [h, h_u, h_v, tilt] = module.kernel("bump_at", u, v, scene.ku, scene.kv, beta, scene.radius, ...scene.lights[0].position);
    const [cos_theta, sin_theta, cos_phi, sin_phi] = module.kernel("angles_at", u, v), lines = Ideas.lines(module, data, "bump_lines", { cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta });
    const vectors = ["normal", "e_theta", "e_phi", "g", "m", "bumped"].map((name) => [name, vector(lines, name)]);
    return { h, h_u, h_v, tilt, length: lines.m_length, ...Object.fromEntries(vectors) };
  }

  // The lines of the chart on which ridges is creased, where the eye sees them.
  function net({ place, toward }) {
    const steps = Float64Array.from({ length: 97 }, (_, n) => n / 96), curves = [];
    for (let m = 0; m < scene.ku; m++) curves.push([steps.map(() => m / scene.ku), steps]);
    for (let m = 1; m < scene.kv; m++) curves.push([steps, steps.map(() => m / scene.kv)]);
    return curves.map(([us, vs]) => {
      const xyz = module.kernel("point_on_a", ...module.kernel("angles_at", us, vs), 1), points = Array.from(us, (_, n) => xyz.map((part) => part[n]));
      return points.slice(1).map((p, n) => (dot(p, toward) > 0 && dot(points[n], toward) > 0 ? line([place(points[n]), place(p)]) : "")).join("");
    }).join("");
  }

  function draw() {
    const eye = view(), { place, size, middle } = eye, now = values(), { normal: p, e_theta, e_phi, g, m, bumped } = now, at = place(p), to = (...parts) => place(along(p, ...parts));
    const arrow_to = (end, look, head) => arrow(at, [end[0] - at[0], end[1] - at[1]], look, head), corner = (a, b) => to([0.34 * a, e_theta], [0.34 * b, e_phi]);
    const name = (end, words, look) => text(end[0] + 8 * Math.sign(end[0] - at[0]) - (end[0] < at[0] ? 14 : 0), end[1] - 6, words, `i ${look}`);
    const [n, tangent, end, unit] = [to([1, p]), to([beta, g]), to([1, m]), to([1, bumped])];
    panel.show(
      `<circle class="ball" cx="${middle[0]}" cy="${middle[1]}" r="${size}"/><path class="net" d="${net(eye)}"/>` +
        `<path class="plane" d="${line([corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)])}Z"/>` + arrow_to(to([0.34, e_theta]), "few", 5) + arrow_to(to([0.34, e_phi]), "few", 5) + name(to([0.34, e_theta]), "e<tspan dy='3' font-size='9'>θ</tspan>", "") + name(to([0.34, e_phi]), "e<tspan dy='3' font-size='9'>φ</tspan>", "") +
        `<path class="guide" d="${line([n, end, tangent])}"/>` + arrow_to(end, "few", 7) + arrow_to(n, "", 9) + arrow_to(tangent, "slope", 9) + arrow_to(unit, "bumped", 10) +
        name(n, "N", "") + name(tangent, "βg", "blue") + name(end, "M", "") + text(unit[0] - 30, unit[1] + 6, "N′", "i bold"),
    );
    const three = (d) => `(${d.map((part) => say(part, 3)).join(", ")})`;
    const rows = { "u, v": `${say(u, 3)}, ${say(v, 3)}`, "h<sub>u</sub>, h<sub>v</sub>": `${say(now.h_u)}, ${say(now.h_v)}`, N: three(p), g: three(g), M: three(m), "|M|": say(now.length, 3), "N′": three(bumped), tilt: `${say(now.tilt, 1)}°` };
    list.innerHTML = Object.entries(rows).map(([key, value]) => `<div><dt>${key}</dt><dd>${value}</dd></div>`).join("");
    on_point(at, u, `u ${say(u, 3)}, v ${say(v, 3)}, slopes ${say(now.h_u)} and ${say(now.h_v)}`);
    on_tip(end, beta, `β ${say(beta, 3)}, tilt ${say(now.tilt, 1)}°`);
    turned(turn, `turned by ${Math.round((turn * 180) / Math.PI)}°, from ${Math.round((tip * 180) / Math.PI)}° above`);
  }

  stage.begin();
};

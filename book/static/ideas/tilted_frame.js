// N, the tangent vector βg and M = N + βg at a point of the sphere, in a drawing that can be turned and pulled.
"use strict";

IDEAS.tilted_frame = (stage, module, data) => {
  const { scene } = data;
  const { own } = module;
  const HIGH = 400;
  const MOST = 0.5;
  const WHOLE = 2 * Math.PI;
  let u = 0.53;
  let v = 0.2;
  let beta = 0.07;
  let turn = 0.95; // the eye: how far around,
  let tip = 0.42; // how far up
  let from = [0, 0];

  /** @param {number[]} a @param {number[]} b */
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  /** A sum of so many times a vector each. @param {...[number, number[]]} parts */
  const sum = (...parts) => [0, 1, 2].map((n) => parts.reduce((total, [share, part]) => total + share * part[n], 0));
  /** @param {number} number @param {number} whole */
  const modulo = (number, whole) => ((number % whole) + whole) % whole;

  /** @param {number} to_turn @param {number} to_tip */
  function look(to_turn, to_tip) {
    turn = modulo(to_turn, WHOLE);
    tip = clamp(-0.2, to_tip, 1.5);
    stage.redraw();
  }
  /** @param {{ u?: number, v?: number, beta?: number }} to */
  function set(to) {
    u = modulo(to.u ?? u, 1);
    v = clamp(0.01, to.v ?? v, 0.99);
    beta = clamp(0, to.beta ?? beta, MOST);
    put_beta(beta);
    stage.redraw();
  }

  const sides = add_element(stage.root, "div", { class: "idea-sides" });
  const panel = stage.panel("The normal at a point, and what the slope makes of it", HIGH, sides);
  const list = add_element(sides, "dl", { class: "idea-values" });
  const put_beta = stage.slider("bump β", { min: 0, max: MOST, step: 0.005, value: beta }, (to) => set({ beta: to }));
  panel.box.classList.add("idea-turned");
  /** @type {Moved} */
  function drag(x, y, begins) {
    if (!begins) look(turn - (x - from[0]) / 150, tip + (y - from[1]) / 150);
    from = [x, y];
  }
  const put_view = panel.backdrop("the view: drag, or press arrow keys, to turn it", drag, (right, up) =>
    look(turn - right / 20, tip - up / 20)
  );
  const put_point = panel.handle("the point of the sphere, u and v", pull, (right, up) =>
    set({ u: u + right / 256, v: v - up / 256 })
  );
  const stretched = panel.handle(
    "the tip of M, that is β",
    stretch,
    (right, up) => set({ beta: beta + (right + up) / 200 }),
    "second"
  );

  // The directions to the right of the drawing, up in it, and towards the eye; where a point is in it.
  function view() {
    const [c, s, ct, st] = [Math.cos(turn), Math.sin(turn), Math.cos(tip), Math.sin(tip)];
    const right = [-s, c, 0];
    const up = [-st * c, -st * s, ct];
    const size = Math.min(150, 0.3 * panel.width());
    /** @type {Point} */
    const middle = [0.5 * panel.width(), HIGH - size - 14];
    /** @param {number[]} p @returns {Point} */
    const place = (p) => [middle[0] + size * dot(p, right), middle[1] - size * dot(p, up)];
    return { right, up, toward: [ct * c, ct * s, st], size, middle, place };
  }

  /** Put the point where the pointer is. @param {number} x @param {number} y */
  function pull(x, y) {
    const { right, up, toward, size, middle } = view();
    const [a, b] = [(x - middle[0]) / size, (middle[1] - y) / size];
    const far = Math.hypot(a, b);
    const inside = far > 0.999 ? 0.999 / far : 1;
    const p = sum([a * inside, right], [b * inside, up], [Math.sqrt(1 - (far * inside) ** 2), toward]);
    const [to_u, to_v] = own.kernel("chart", p[0], p[1], p[2], Math.hypot(p[0], p[1]));
    set({ u: to_u, v: to_v });
  }

  /** Let the tip of M follow the pointer along g. @param {number} x @param {number} y */
  function stretch(x, y) {
    const { place } = view();
    const { normal, g } = values();
    const [foot, end] = [place(sum([2, normal])), place(sum([2, normal], [1, g]))];
    const d = [end[0] - foot[0], end[1] - foot[1]];
    const length = Math.hypot(...d);
    if (length > 1) set({ beta: ((x - foot[0]) * d[0] + (y - foot[1]) * d[1]) / length ** 2 });
  }

  function values() {
    const { ku, kv, radius, lights } = scene;
    const [, h_u, h_v, tilt] = own.kernel("bump_at", u, v, ku, kv, beta, radius, ...lights[0].position);
    const [cos_theta, sin_theta, cos_phi, sin_phi] = own.kernel("angles_at", u, v);
    const inputs = { cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta };
    const lines = program_lines(module, data, "bump_lines", inputs);
    const [normal, e_theta, e_phi, g, m, bumped] = ["normal", "e_theta", "e_phi", "g", "m", "bumped"].map((name) =>
      vector_of(lines, name)
    );
    return { h_u, h_v, tilt, length: lines.m_length, normal, e_theta, e_phi, g, m, bumped };
  }

  /** The lines of the chart on which the field is creased, where the eye sees them. @param {ReturnType<typeof view>} view */
  function net({ place, toward }) {
    const steps = float64s(97, (n) => n / 96);
    const lines = module.crease_lines(scene_state(data)).map(({ a, b, level }) => {
      const [us, vs] = [steps.map((at) => (a ? (level - b * at) / a : at)), steps.map((at) => (a ? at : level / b))];
      const xyz = module.kernel_over("point_on_a", ...own.kernel_over("angles_at", us, vs), 1);
      const points = Array.from(us, (_, n) => xyz.map((part) => part[n]));
      const parts = points.slice(1).map((p, n) => {
        const is_seen = dot(p, toward) > 0 && dot(points[n], toward) > 0;
        return is_seen ? line_path([place(points[n]), place(p)]) : "";
      });
      return parts.join("");
    });
    return lines.join("");
  }

  return () => {
    const eye = view();
    const { place, size, middle } = eye;
    const { h_u, h_v, tilt, length, normal, e_theta, e_phi, g, m, bumped } = values();
    const at = place(normal);
    /** @param {...[number, number[]]} parts */
    const to = (...parts) => place(sum([1, normal], ...parts));
    /** @param {number} a @param {number} b */
    const corner = (a, b) => to([0.34 * a, e_theta], [0.34 * b, e_phi]);
    /** @param {Point} end @param {string} words @param {string} look */
    const name = (end, words, look) => text_at(end[0] + (end[0] < at[0] ? -22 : 8), end[1] - 6, words, `i ${look}`);
    /** @param {Point} end @param {string} letter */
    const axis = (end, letter) =>
      arrow_path(at, end, "few", 5) + name(end, `e<tspan dy='3' font-size='9'>${letter}</tspan>`, "");
    const [n, tangent, end, unit] = [to([1, normal]), to([beta, g]), to([1, m]), to([1, bumped])];
    panel.show(
      circle_markup("ball", middle, size) +
        path_markup("net", net(eye)) +
        path_markup("plane", `${line_path([corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)])}Z`) +
        axis(corner(1, 0), "θ") +
        axis(corner(0, 1), "φ") +
        line_markup("guide", [n, end, tangent]) +
        arrow_path(at, end, "few", 7) +
        arrow_path(at, n, "", 9) +
        arrow_path(at, tangent, "slope", 9) +
        arrow_path(at, unit, "bumped", 10) +
        name(n, "N", "") +
        name(tangent, "βg", "blue") +
        name(end, "M", "") +
        text_at(unit[0] - 30, unit[1] + 6, "N′", "i bold")
    );
    /** @param {number[]} parts */
    const in_brackets = (parts) => `(${parts.map((part) => decimal(part, 3)).join(", ")})`;
    const rows = {
      "u, v": `${decimal(u, 3)}, ${decimal(v, 3)}`,
      "h<sub>u</sub>, h<sub>v</sub>": `${decimal(h_u)}, ${decimal(h_v)}`,
      N: in_brackets(normal),
      g: in_brackets(g),
      M: in_brackets(m),
      "|M|": decimal(length, 3),
      "N′": in_brackets(bumped),
      tilt: `${decimal(tilt, 1)}°`
    };
    list.innerHTML = Object.entries(rows)
      .map(([name, value]) => entry_markup(name, value))
      .join("");
    put_point(at, u, `u ${decimal(u, 3)}, v ${decimal(v, 3)}, slopes ${decimal(h_u)} and ${decimal(h_v)}`);
    stretched(end, beta, `β ${decimal(beta, 3)}, tilt ${decimal(tilt, 1)}°`);
    const [around, above] = [turn, tip].map((angle) => Math.round((angle * 180) / Math.PI));
    put_view(turn, `turned by ${around}°, from ${above}° above`);
  };
};

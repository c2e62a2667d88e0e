// The scene in the upright plane through the eye and sphere B: a ray to be dragged, what it meets, what the lights reach.
"use strict";

IDEAS.scene_from_the_side = (stage, module, data) => {
  const { eye, radius, ball_radius, ball_center, lights } = data.scene;
  const across = Math.hypot(ball_center[0], ball_center[1]);
  const way = [ball_center[0] / across, ball_center[1] / across];
  const FURTHEST = 2.2;
  const LIGHTS = ["first light", "second light"]; // also what style sheets know them by
  /** @type {Vector} */
  const ORIGIN = [0, 0, 0];
  let s = 0.52;

  /** A point's place in the plane: along it, and how high. @param {number[]} point @returns {Point} */
  const flat = ([x, y, z]) => [x * way[0] + y * way[1], z];

  const panel = stage.panel("The eye, a ray, the spheres, the floor and the lights, from the side", 430);
  const says = stage.says();
  panel.box.classList.add("idea-clipped");
  const on_floor = panel.handle(
    "where the ray meets the picture's plane",
    [-FURTHEST, FURTHEST],
    (x) => set((x - panel.width() / 2) / scale_of()),
    (right) => set(s + right / 100)
  );
  const scale_of = () => Math.min(96, panel.width() / 4.6);
  /** @param {number} to */
  function set(to) {
    s = clamp(-FURTHEST, to, FURTHEST);
    stage.redraw();
  }

  /**
   * Where neither of the other bodies lets a light reach the floor, A or B, each drawn a little beside it.
   * @param {number} light
   * @param {(point: Point) => Point} place
   * @param {number} beside
   */
  function shadows(light, place, beside) {
    /**
     * What is dark of a curve in the plane.
     * @param {number} count of its points
     * @param {(n: number, beside: number) => Point} point where each is, and where it is drawn
     * @param {(point: Point) => boolean} is_open whether it is outside of every body
     * @param {...Vector} bodies the centres of those that may stand before it
     */
    function dark(count, point, is_open, ...bodies) {
      const points = Array.from({ length: count }, (_, n) => point(n, 0));
      const [x, y] = way.map((part) => float64s(count, (n) => points[n][0] * part));
      const z = float64s(count, (n) => points[n][1]);
      const hidden = bodies.map((center) => {
        const size = center === ball_center ? ball_radius : radius;
        return module.own.kernel_over("shadow", x, y, z, ...lights[light].position, ...center, size)[0];
      });
      /** @type {Point[]} */
      const line = points.map((at, n) => {
        const is_dark = is_open(at) && hidden.some((flags) => flags[n]);
        return is_dark ? place(point(n, beside)) : [NaN, NaN];
      });
      return line_markup(`dark ${LIGHTS[light]}`, line);
    }

    /** @param {Vector} center @param {number} size @returns {(n: number, beside: number) => Point} */
    function circle(center, size) {
      const [middle, height] = flat(center);
      return (n, beside) => {
        const angle = (n * Math.PI) / 120;
        return [middle + (size - beside) * Math.cos(angle), height + (size - beside) * Math.sin(angle)];
      };
    }
    /** @param {Point} point */
    const is_up = ([, height]) => height >= 0;
    return (
      dark(
        401,
        (n, beside) => [(n / 200 - 1) * FURTHEST, -beside],
        ([along]) => Math.abs(along) >= radius,
        ORIGIN,
        ball_center
      ) +
      dark(241, circle(ORIGIN, radius), is_up, ball_center) +
      dark(241, circle(ball_center, ball_radius), is_up, ORIGIN)
    );
  }

  return () => {
    const scale = scale_of();
    const ground = 20 + scale * eye;
    const middle = panel.width() / 2;
    /** @param {Point} point @returns {Point} */
    const place = ([along, height]) => [middle + scale * along, ground - scale * height];
    const found = program_lines(module, data, "pixel_lines", { ...data.given, x: s * way[0], y: s * way[1] });
    const hit = place(flat(["x", "y", "z"].map((axis) => found[`point_${axis}`])));
    const top = place([0, eye]);
    const foot = place([s, 0]);
    const ball = place(flat(ball_center));
    const is_hidden = LIGHTS.map((_, n) => found[`occluded_${n}`] > 0);
    const arrows = lights.map(({ position }, n) => {
      const end = place(flat(position));
      const reach = 120 / Math.hypot(end[0] - hit[0], end[1] - hit[1]);
      /** @type {Point} */
      const near = [hit[0] + reach * (end[0] - hit[0]), hit[1] + reach * (end[1] - hit[1])];
      const name = text_at(near[0] + (near[0] > hit[0] ? 6 : -76), near[1] - 4, LIGHTS[n]);
      return arrow_path(hit, near, is_hidden[n] ? "blocked" : `shine ${LIGHTS[n]}`, 8) + name;
    });
    const wide = radius * scale;
    panel.svg.setAttribute("height", String(ground + 24));
    panel.show(
      path_markup("height", `M0 ${ground}H${panel.width()}`) +
        path_markup("body", `M${middle - wide} ${ground}A${wide} ${wide} 0 0 1 ${middle + wide} ${ground}`) +
        circle_markup("body", ball, ball_radius * scale) +
        LIGHTS.map((_, n) => shadows(n, place, (5 + 6 * n) / scale)).join("") +
        line_markup("slope", [top, hit]) +
        line_markup("guide", [hit, foot]) +
        arrows.join("") +
        circle_markup("eye", top, 5) +
        circle_markup("met", hit, 4.5) +
        text_at(top[0] + 10, top[1] + 5, "the eye, <tspan class='i'>t</tspan> = 0") +
        text_at(middle - 4, ground - 0.45 * scale, "A", "i bold") +
        text_at(ball[0] - 4, ball[1] + 5, "B", "i bold") +
        text_at(hit[0] - 18, hit[1] - 8, "P", "i bold") +
        text_at(6, ground - 6, "the floor, <tspan class='i'>t</tspan> = 1")
    );
    const met = Object.entries({ A: found.t_a, B: found.t_b, "the floor": found.t_floor })
      .filter(([, at]) => Number.isFinite(at))
      .map(([name, at]) => `${name} at <i>t</i> = ${decimal(at, 3)}`);
    const reached = LIGHTS.map((name, n) => `he ${name} ${is_hidden[n] ? "is hidden there" : "reaches it"}`);
    const surface = SURFACES[found.surface];
    says.innerHTML = `The ray meets ${met.join(", ")}: it shows <b>${surface}</b>. T${reached.join(", t")}.`;
    on_floor(foot, s, `${decimal(s)}: ${surface}; t${reached.join(", t")}`);
  };
};

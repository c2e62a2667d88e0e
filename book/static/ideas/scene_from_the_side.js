// The scene in the upright plane through the eye and sphere B: a ray to be dragged, what it meets, what the lights reach.
"use strict";
var Ideas = Ideas || {};

Ideas.scene_from_the_side = function (figure, module, data) {
  const { scene, given } = data, { say, line, arrow, text, vector, lines } = Ideas, { eye, radius, ball_radius, ball_center, lights } = scene;
  const across = Math.hypot(ball_center[0], ball_center[1]), way = [ball_center[0] / across, ball_center[1] / across], FURTHEST = 2.2;
  const flat = ([x, y, z]) => [x * way[0] + y * way[1], z], at_floor = (s) => [s * way[0], s * way[1]], NAMES = ["nothing", "sphere A", "sphere B", "the floor"], LIGHTS = ["first light", "second light"];
  let s = 0.52;

  const stage = Ideas.stage(figure, draw), panel = stage.panel("The eye, a ray, the spheres, the floor and the lights, from the side", 430), says = stage.says();
  panel.box.classList.add("idea-clipped");
  const on_floor = panel.handle("where the ray meets the picture's plane", (x) => set((x - view().middle) / view().scale), (right) => set(s + right / 100));
  function view() {
    const scale = Math.min(96, panel.width / 4.6), ground = 20 + scale * eye;
    return { scale, ground, middle: panel.width / 2 };
  }
  const set = (to) => {
    s = Math.max(-FURTHEST, Math.min(FURTHEST, to));
    stage.redraw();
  };

  const seen = (along) => {
    const [x, y] = at_floor(along), found = lines(module, data, "pixel_lines", { ...given, x, y });
    return { ...found, point: vector(found, "point"), hidden: lights.map((_, n) => found[`occluded_${n}`] > 0) };
  };

  // Where points of the plane, arrays of their places along it and heights, are not reached by a light for a sphere.
  function in_shadow(along, heights, light, center, size) {
    const [x, y] = way.map((part) => along.map((a) => a * part));
    return module.kernel("shadow", x, y, heights, ...lights[light].position, ...center, size);
  }
  const dark = (flags, places) => places.map((p, n) => (flags[n] ? (n && flags[n - 1] ? "L" : "M") + `${p[0].toFixed(1)} ${p[1].toFixed(1)}` : "")).join("");

  // What neither of the other bodies lets a light reach: of the floor, of A, of B, each drawn a little beside it.
  function shadows(light, place, scale) {
    const origin = [0, 0, 0], off = (5 + 6 * light) / scale, floor = Float64Array.from({ length: 401 }, (_, n) => -FURTHEST + (n * FURTHEST) / 200), ground = floor.map(() => 0);
    const by_a = in_shadow(floor, ground, light, origin, radius), by_b = in_shadow(floor, ground, light, ball_center, ball_radius), angles = Float64Array.from({ length: 241 }, (_, n) => (n * Math.PI) / 120);
    const round = (center, size) => [angles.map((a) => center[0] + size * Math.cos(a)), angles.map((a) => center[1] + size * Math.sin(a))], parts = [[floor, ground.map(() => -off), by_a.map((a, n) => Math.abs(floor[n]) >= radius && (a || by_b[n]))]];
    for (const [center, size, other, body] of [[[0, 0], radius, ball_center, ball_radius], [flat(ball_center), ball_radius, origin, radius]]) {
      const [a, z] = round(center, size), [b, c] = round(center, size - off), hidden = in_shadow(a, z, light, other, body);
      parts.push([b, c, hidden.map((flag, n) => flag && z[n] >= 0)]);
    }
    return parts.map(([a, z, flags]) => `<path class="dark light-${light}" d="${dark(flags, Array.from(a, (_, n) => place([a[n], z[n]])))}"/>`).join("");
  }

  function draw() {
    const { scale, middle, ground } = view(), place = ([a, z]) => [middle + scale * a, ground - scale * z], found = seen(s), hit = place(flat(found.point)), top = place([0, eye]), foot = place([s, 0]);
    const ball = place(flat(ball_center)), half = `M${middle - radius * scale} ${ground}A${radius * scale} ${radius * scale} 0 0 1 ${middle + radius * scale} ${ground}`;
    const to_light = lights.map(({ position }, n) => {
      const end = place(flat(position)), length = Math.hypot(end[0] - hit[0], end[1] - hit[1]), reach = 120 / length, near = [hit[0] + reach * (end[0] - hit[0]), hit[1] + reach * (end[1] - hit[1])];
      return arrow(hit, [near[0] - hit[0], near[1] - hit[1]], found.hidden[n] ? "blocked" : `shine light-${n}`, 8) + text(near[0] + (near[0] > hit[0] ? 6 : -76), near[1] - 4, LIGHTS[n]);
    });
    panel.svg.setAttribute("height", ground + 24);
    panel.show(
      `<path class="height" d="M0 ${ground}H${panel.width}"/><path class="body" d="${half}"/><circle class="body" cx="${ball[0]}" cy="${ball[1]}" r="${ball_radius * scale}"/>` + [0, 1].map((n) => shadows(n, place, scale)).join("") +
        `<path class="slope" d="${line([top, hit])}"/><path class="guide" d="${line([hit, foot])}"/>` + to_light.join("") + `<circle class="eye" cx="${top[0]}" cy="${top[1]}" r="5"/><circle class="met" cx="${hit[0]}" cy="${hit[1]}" r="4.5"/>` +
        text(top[0] + 10, top[1] + 5, "the eye, <tspan class='i'>t</tspan> = 0") + text(middle - 4, ground - 0.45 * scale, "A", "i bold") + text(ball[0] - 4, ball[1] + 5, "B", "i bold") + text(hit[0] - 18, hit[1] - 8, "P", "i bold") + text(6, ground - 6, "the floor, <tspan class='i'>t</tspan> = 1"),
    );
    const t = { A: found.t_a, B: found.t_b, "the floor": found.t_floor }, met = Object.entries(t).filter(([, at]) => Number.isFinite(at)).map(([name, at]) => `${name} at <i>t</i> = ${say(at, 3)}`);
    const reached = found.hidden.map((is, n) => `the ${LIGHTS[n]} ${is ? "is hidden there" : "reaches it"}`);
    says.innerHTML = `The ray meets ${met.join(", ")}: it shows <b>${NAMES[found.surface]}</b>. ${reached[0][0].toUpperCase()}${reached[0].slice(1)}, ${reached[1]}.`;
    on_floor(foot, s, `${say(s)}: ${NAMES[found.surface]}; ${reached.join(", ")}`);
  }

  stage.begin();
};

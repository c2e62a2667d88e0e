// Three pitfalls by hand: both pictures of a part of the scene and their difference, and one number to move.
"use strict";

/** @param {Pitfall} pitfall @returns {Idea} */
const pitfall_of =
  ({ label, range, name, changes, eps, zoom, at, words }) =>
  (stage, module, data) => {
    const show = stage.three(...PICTURES);
    let { value } = range;
    stage.slider(
      label,
      range,
      (to) => {
        value = to;
      },
      name
    );
    const says = stage.says();
    return () => {
      const state = scene_state(data, { field: "sine", ...changes(value) });
      const whole = Math.round(SIDE * zoom(value));
      const raster = raster_of(whole);
      const middle = module.placing_in(raster)(at * module.radius_of_a, 0);
      const [left, top] = middle.map((to) => clamp(0, Math.round(to) - SIDE / 2, whole - SIDE));
      const part = module.make_stage(state, { ...raster, left, top });
      module.draw_pair(state, { numeric: { name: "central", eps: eps(value) }, symbolic: EXACT }, part);
      show(module, part);
      says.textContent = words(value, module.gradients(state, part)[1]);
    };
  };

IDEAS.pitfall_seam = pitfall_of({
  label: "waves around, k",
  range: { min: 6, max: 8, step: 0.1, value: 7 },
  name: (k) => decimal(k, 1),
  changes: (ku) => ({ ku }),
  eps: () => 0.01,
  zoom: () => 8,
  at: -0.6,
  words: (k) =>
    k % 1
      ? "Between whole numbers the height itself jumps at the seam, and the wrapped difference takes the jump for a slope."
      : k % 2
        ? "Odd: the height comes back to where it began, with its slope turned round. That is a crease."
        : "Even: the chart closes, and nothing is seen."
});

IDEAS.step_taken = pitfall_of({
  label: "step ε",
  range: { min: -18, max: -1, step: 0.1, value: -6 },
  name: (exponent) => in_powers(10 ** exponent, 1),
  changes: () => ({}),
  eps: (exponent) => 10 ** exponent,
  zoom: () => 1,
  at: 0,
  words(exponent) {
    const eps = 10 ** exponent;
    const taken = 0.3 + eps - (0.3 - eps);
    const off = scientific(Math.abs(taken / (2 * eps) - 1), 1);
    return `Around u = 0.3 the samples lie ${scientific(taken, 3)} apart, and 2ε is ${scientific(2 * eps, 3)}: this alone puts the slope off by ${off} of itself.`;
  }
});

IDEAS.around_pole = pitfall_of({
  label: "magnified",
  range: { min: 0, max: 16, step: 1, value: 6 },
  name: (steps) => `${(2 ** (steps / 2)).toPrecision(3)} times`,
  changes: () => ({}),
  eps: () => 1e-6,
  zoom: (steps) => 2 ** (steps / 2),
  at: 0,
  words(_, slopes) {
    const [least, most] = [Math.min(...slopes), Math.max(...slopes)].map((slope) => decimal(slope, 2));
    return `In what is seen, the slope along the meridian runs from ${least} to ${most}, however near the pole: which it is depends on the way one comes.`;
  }
});

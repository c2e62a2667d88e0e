// The bump found again: the reader sets a target, and a sphere goes to it by Gauss and Newton's steps, which the exact
// slopes of its picture give.
"use strict";

IDEAS.derivative_fit = (stage, module, data) => {
  const MOST = 24; // pictures
  const PAUSE = 400; // milliseconds from one to the next
  const NOTHING = 1e-9; // that is left
  const target = { beta: 0.2, ku: 8.2 };
  /** @type {{ beta: number, ku: number }} */
  let now = data.scene;
  let timer = 0;

  const show = stage.three("the target", "the sphere", "difference");
  stage.slider("target β", { min: 0.05, max: 1, step: 0.01, value: target.beta }, (to) => {
    target.beta = to;
  });
  stage.slider("target kᵤ", { min: 6, max: 10, step: 0.05, value: target.ku }, (to) => {
    target.ku = to;
  });
  stage.root.append(make_button("Find it", find), make_button("One step", step));
  const says = stage.says();
  says.role = "status";
  const steps = add_element(stage.root, "ol");

  /** Draw both, write down how far apart they are, and go where the slopes by β and by k_u lead. */
  function look() {
    const { beta, ku } = now;
    /** @type {any} */
    const state = scene_state(data, { field: "sine", beta, ku });
    const part = module.make_stage(state, raster_of(SIDE));
    const pair = module.draw_pair(state, { numeric: { ...EXACT, scene: target }, symbolic: EXACT }, part);
    show(module, part);
    const slopes = ["by_beta", "by_ku"].map((view) => module.picture_slopes({ ...state, view }, part, EXACT) ?? []);
    const [wanted, drawn, b, k] = [...pair, ...slopes].map((planes) => planes.flatMap((plane) => [...plane]));
    const off = wanted.map((color, i) => color - drawn[i]);
    const products = [
      [b, b],
      [b, k],
      [k, k],
      [b, off],
      [k, off],
      [off, off]
    ];
    const [bb, bk, kk, b_off, k_off, squares] = products.map(([one, other]) =>
      one.reduce((sum, number, i) => sum + number * other[i], 0)
    );
    const scale = bb * kk - bk ** 2;
    now = { beta: beta + (kk * b_off - bk * k_off) / scale, ku: ku + (bb * k_off - bk * b_off) / scale };
    const rms = Math.sqrt(squares / off.length);
    add_element(steps, "li", {}, `β ${decimal(beta, 9)}, kᵤ ${decimal(ku, 9)}, RMS ${scientific(rms, 1)}`);
    if (rms < NOTHING) says.textContent = "Found.";
    else if (steps.childElementCount === MOST || !(Math.abs(now.beta) < 2))
      says.textContent = "It did not converge from here.";
    if (says.textContent) clearInterval(timer);
  }

  function begin() {
    clearInterval(timer);
    now = data.scene;
    says.textContent = "";
    steps.replaceChildren();
    look();
  }

  function step() {
    if (says.textContent) begin();
    else look();
  }

  function find() {
    begin();
    timer = setInterval(step, PAUSE);
  }
  return begin;
};

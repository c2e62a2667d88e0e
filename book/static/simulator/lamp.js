// The lamp on every picture: it stands where its light comes from, seen from above, and is dragged or moved by keys.
"use strict";

/** @param {HTMLElement} root @param {States} states @param {SimulatorModule} module @param {Act} act */
function simulator_lamp(root, states, module, act) {
  const LOWEST = 0.05; // how far up, as a share of its distance from the sphere's centre
  const STEP = 0.02;
  /** @type {HTMLElement[]} */
  const handles = find_all(root, ".sim-lamp");
  let held = 0; // its distance while it is dragged: rounding would else change it

  /** Where it comes from: x and y of a direction, its length. @param {State} state */
  function direction({ lamp: [x, y, z] }) {
    const far = Math.hypot(x, y, z) || 1;
    return { x: x / far, y: y / far, far };
  }

  /** Let the light come from elsewhere, at the same distance. @param {number} x @param {number} y @param {number} far */
  function turn(x, y, far) {
    const outer = Math.max(1, Math.hypot(x, y) / Math.sqrt(1 - LOWEST ** 2));
    const [east, north] = [x / outer, y / outer];
    const up = Math.sqrt(1 - east ** 2 - north ** 2);
    act.set({ lamp: /** @type {Vector} */ ([east, north, up].map((part) => Number((far * part).toFixed(2)))) });
  }

  const tells = handles.map((handle) => {
    const frame = /** @type {HTMLElement} */ (handle.parentElement);
    return as_slider(
      handle,
      frame,
      "lamp, where the first light comes from; arrow keys move it",
      [3, 90],
      (right, down, begins) => {
        const state = act.state();
        if (begins) held = direction(state).far;
        const { clientWidth, clientHeight } = frame;
        const [middle, rim] = places(state);
        const reach = rim[0] - middle[0];
        const [across, along] = [right / clientWidth, down / clientHeight];
        turn((across - middle[0]) / reach, (middle[1] - along) / reach, held);
      },
      (right, up) => {
        const { x, y, far } = direction(act.state());
        if (right === Infinity) return turn(0, 0, far); // overhead
        if (right === -Infinity) return turn(1e9 * (x || Number(!y)), 1e9 * y, far); // on the floor
        turn(x + STEP * clamp(-10, right, 10), y + STEP * clamp(-10, up, 10), far);
      }
    );
  });

  /** Where sphere A's middle and its right rim are, as shares of the picture. @param {State} state */
  function places(state) {
    const place = module.placing_in(states.crop(state));
    return [place(0, 0), place(module.radius_of_a, 0)].map((point) => point.map((pixels) => pixels / state.size));
  }

  /** @param {State} state */
  function show(state) {
    const { x, y } = direction(state);
    const [middle, rim] = places(state);
    const reach = rim[0] - middle[0];
    const [across, down] = [middle[0] + reach * x, middle[1] - reach * y];
    root.style.setProperty("--lamp-across", `${100 * across}%`);
    root.style.setProperty("--lamp-down", `${100 * down}%`);
    const height = Math.round((Math.acos(Math.min(1, Math.hypot(x, y))) * 180) / Math.PI);
    for (const [n, tell] of tells.entries()) {
      tell(height, `${height}° up, at ${state.lamp.join(", ")}`);
      handles[n].hidden = !state.lights[0] || Math.min(across, down) < 0 || Math.max(across, down) > 1;
    }
  }
  return { show };
}

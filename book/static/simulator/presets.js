// The four experiments of the page: a state to begin with, and one quantity that then moves.
"use strict";

/** @param {States} states @param {Act} act */
function simulator_presets(states, act) {
  const no_motion = window.matchMedia("(prefers-reduced-motion: reduce)");
  /** @param {number} exponent */
  const step = (exponent) => ({ eps: power_of_ten(exponent) });
  /** @type {Record<string, Experiment>} */
  const experiments = {
    sweep: {
      says: "Sine, ε from 10⁻¹ down to 10⁻¹⁶. The difference darkens, and then comes back as grain: where is it darkest?",
      begin: { field: "sine", eps: 0.1 },
      seconds: 12,
      from: -1,
      to: -16,
      at: step,
      still: -6
    },
    creases: {
      says: "Ridges, with their crease lines. As ε falls, the glow along them gets narrower, and hardly fainter.",
      begin: { field: "ridges", view: "loci", eps: 0.1 },
      seconds: 6,
      from: -1,
      to: -3.5,
      at: step,
      still: -2
    },
    pole: {
      says: "Rings, magnified at the pole. The pinch is in both pictures, so the difference has nothing to say about it.",
      begin: { field: "rings", eps: 1e-3 },
      seconds: 5,
      from: 0,
      to: 10,
      at: (zoom) => act.to_pole(Math.round(zoom)),
      still: 10
    },
    flat: {
      says: "β falls to 0. The two pictures become one plain sphere, and the difference is zero, not merely dark.",
      begin: { field: "ridges", eps: 1e-2 },
      seconds: 4,
      from: 0.35,
      to: 0,
      at: (beta) => ({ beta: Number(beta.toFixed(3)) }),
      still: 0
    }
  };
  let running = 0;

  function stop() {
    cancelAnimationFrame(running);
    running = 0;
  }

  /** @param {string} name */
  function run(name) {
    stop();
    const { begin, seconds, from, to, at, still } = experiments[name];
    const { size, column, row } = states.zoomed(act.state(), { zoom: 0 });
    act.replace({ ...states.start(), size, column, row, ...begin });
    if (no_motion.matches) return act.change(at(still));
    let first = 0;
    /** @param {number} now */
    const tick = (now) => {
      first ||= now;
      const share = Math.min(1, (now - first) / 1000 / seconds);
      act.change(at(from + (to - from) * share));
      running = share < 1 && !document.hidden ? requestAnimationFrame(tick) : 0;
    };
    running = requestAnimationFrame(tick);
  }

  return { run, stop, says: (/** @type {string} */ name) => experiments[name].says, running: () => running !== 0 };
}

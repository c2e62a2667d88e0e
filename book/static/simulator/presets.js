// The four experiments of the page: a state to begin with, and one quantity that then moves.
"use strict";

Simulator.presets = function (states, act) {
  const still = window.matchMedia("(prefers-reduced-motion: reduce)");
  const step = (exponent) => ({ eps: Number((10 ** exponent).toPrecision(3)) });
  const experiments = {
    sweep: { says: "Sine, ε from 10⁻¹ down to 10⁻¹⁶. The difference darkens, and then comes back as grain: where is it darkest?",
      begin: { field: "sine", eps: 0.1 }, seconds: 12, from: -1, to: -16, at: step, still: -6 },
    creases: { says: "Ridges, with their crease lines. As ε falls, the glow along them gets narrower, and hardly fainter.",
      begin: { field: "ridges", view: "loci", eps: 0.1 }, seconds: 6, from: -1, to: -3.5, at: step, still: -2 },
    pole: { says: "Rings, magnified at the pole. The pinch is in both pictures, so the difference has nothing to say about it.",
      begin: { field: "rings", eps: 1e-3 }, seconds: 5, from: 0, to: 10, at: (z) => act.to_pole(Math.round(z)), still: 10 },
    flat: { says: "β falls to 0. The two pictures become one plain sphere, and the difference is zero, not merely dark.",
      begin: { field: "ridges", eps: 1e-2 }, seconds: 4, from: 0.35, to: 0, at: (b) => ({ beta: Number(b.toFixed(3)) }), still: 0 },
  };
  let running = 0;

  function stop() {
    cancelAnimationFrame(running);
    running = 0;
  }

  function run(name) {
    stop();
    const { begin, seconds, from, to, at, still: rest } = experiments[name];
    const { size, column, row } = states.zoomed(act.state(), { zoom: 0 });
    act.replace({ ...states.start(), size, column, row, ...begin });
    if (still.matches) return act.change(at(rest));
    let first = 0;
    const tick = (now) => {
      first = first || now;
      const share = Math.min(1, (now - first) / 1000 / seconds);
      act.change(at(from + (to - from) * share));
      running = share < 1 && !document.hidden ? requestAnimationFrame(tick) : 0;
    };
    running = requestAnimationFrame(tick);
  }

  return { run, stop, says: (name) => experiments[name].says, running: () => running !== 0 };
};

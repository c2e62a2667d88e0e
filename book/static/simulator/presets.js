// The four experiments of the page: a state to begin with, and one quantity that then moves.
"use strict";

/** @param {HTMLElement} root @param {States} states @param {Act} act */
function simulator_presets(root, states, act) {
  const no_motion = window.matchMedia("(prefers-reduced-motion: reduce)");
  /** @param {number} exponent */
  const of_power = (exponent) => ({ eps: power_of_ten(exponent) });
  /** @type {Record<string, Experiment>} */
  const experiments = {
    sweep: {
      says: "Sine, ε from 10⁻¹ down to 10⁻¹⁸. The difference darkens, and then comes back as grain: where is it darkest?",
      begin: { field: "sine", eps: 0.1 },
      seconds: 14,
      from: -1,
      to: -18,
      at: of_power,
      still: -6
    },
    creases: {
      says: "Ridges. As ε falls, the glow along the creases gets narrower, and hardly fainter. Hold C to see where they are.",
      begin: { field: "ridges", eps: 0.1 },
      seconds: 6,
      from: -1,
      to: -3.5,
      at: of_power,
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
  const says = find_element(root, ".sim-says");
  const play = find_element(root, ".sim-play");
  const pause_button = find_element(play, "[data-pause]");
  /** @type {HTMLInputElement} */
  const bar = find_element(play, "input");
  const START = says.textContent;
  const STEPS = 20;
  /** @type {Experiment | null} */
  let now = null;
  let share = 0; // of the experiment that has gone by
  let frame = 0;

  /** @param {number} to */
  function put(to) {
    if (!now) return;
    share = clamp(0, to, 1);
    bar.value = String(share);
    act.change(now.at(rescaled(share, 0, 1, now.from, now.to)));
  }

  function pause() {
    cancelAnimationFrame(frame);
    frame = 0;
    pause_button.textContent = "▶";
    pause_button.setAttribute("aria-label", "go on");
  }

  function go_on() {
    if (!now) return;
    const { seconds } = now;
    const first = share < 1 ? share : 0;
    let begun = 0;
    /** @param {number} time */
    const tick = (time) => {
      begun ||= time;
      put(first + (time - begun) / 1000 / seconds);
      if (share < 1 && !document.hidden) frame = requestAnimationFrame(tick);
      else pause();
    };
    frame = requestAnimationFrame(tick);
    pause_button.textContent = "❚❚";
    pause_button.setAttribute("aria-label", "pause");
  }

  // The experiment is over, and the state stays as it is.
  function stop() {
    pause();
    now = null;
    play.hidden = true;
    root.classList.remove("sim-running");
  }

  /** @param {string} name */
  function run(name) {
    stop();
    now = experiments[name];
    says.textContent = now.says;
    const { size, column, row } = states.zoomed(act.state(), { zoom: 0 });
    act.replace({ ...states.start(), size, column, row, ...now.begin });
    play.hidden = false;
    root.classList.add("sim-running");
    if (!no_motion.matches) {
      share = 0;
      return go_on();
    }
    put(rescaled(now.still, now.from, now.to, 0, 1));
  }

  function reset() {
    stop();
    says.textContent = START;
  }

  const toggle = () => (frame ? pause() : go_on());

  /** A step by hand. @param {number} steps */
  function step(steps) {
    pause();
    put(share + steps / STEPS);
  }

  /** @param {KeyboardEvent} event */
  function press(event) {
    if (!now || is_typed(event) || is_shortcut(event)) return;
    const target = /** @type {Element} */ (event.target);
    const is_ours = frame !== 0 || root.contains(target);
    if (event.key === "Escape") stop();
    else if (
      event.key === " " &&
      is_ours &&
      !target.closest("button, a, select, summary, [type=radio], [type=checkbox]")
    )
      toggle();
    else return;
    event.preventDefault();
  }

  document.addEventListener("keydown", press);
  bar.addEventListener("input", () => {
    pause();
    put(Number(bar.value));
  });
  return { run, stop, reset, toggle, step, running: () => frame !== 0 };
}

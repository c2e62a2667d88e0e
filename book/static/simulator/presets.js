// The experiments of the page, each in its button: a state to begin with, and one quantity that then moves.
"use strict";

/** @param {HTMLElement} root @param {States} states @param {Act} act */
function simulator_presets(root, states, act) {
  const no_motion = window.matchMedia("(prefers-reduced-motion: reduce)");
  /** What each quantity changes that moves. @type {Record<string, (number: number) => Partial<State>>} */
  const moves = {
    eps: (exponent) => ({ eps: power_of_ten(exponent) }),
    zoom: (zoom) => act.to_pole(Math.round(zoom)),
    beta: (beta) => ({ beta: Number(beta.toFixed(3)) }),
    ku: (ku) => ({ ku: Number(ku.toFixed(2)) }),
    kv: (kv) => ({ kv: Number(kv.toFixed(2)) }),
    // Around the sphere, by parts of a turn.
    lamp(turn) {
      const [x, y, z] = lamp;
      const [c, s] = [Math.cos(2 * Math.PI * turn), Math.sin(2 * Math.PI * turn)];
      const next = [Number((c * x - s * y).toFixed(2)), Number((s * x + c * y).toFixed(2)), z];
      return states.parameters.lamp.holds(next) ? { lamp: /** @type {Vector} */ (next) } : {};
    }
  };
  let lamp = act.state().lamp; // where a turn begins
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
  /** @type {HTMLElement} */
  let asked_by; // the experiment's button

  /** @type {Experiment} */
  const OPENING = { says: "", begin: {}, moves: "eps", from: -1, to: -6, still: -3, seconds: 25 };

  // What a reader sees first moves, until the first touch.
  function open() {
    if (no_motion.matches || now) return;
    now = OPENING;
    share = 0;
    go_on();
  }

  /** @param {number} to */
  function put(to) {
    if (!now) return;
    share = clamp(0, to, 1);
    bar.value = String(share);
    act.change(moves[now.moves](rescaled(share, 0, 1, now.from, now.to)));
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
      try {
        put(first + (time - begun) / 1000 / seconds);
      } catch (error) {
        says.textContent = error_text(error); // a formula that is not finite here
        return pause();
      }
      if (share < 1 && !document.hidden) frame = requestAnimationFrame(tick);
      else pause();
    };
    frame = requestAnimationFrame(tick);
    pause_button.textContent = "‖";
    pause_button.setAttribute("aria-label", "pause");
  }

  // The experiment is over, and the state stays as it is.
  function stop() {
    pause();
    now = null;
    if (play.contains(document.activeElement)) asked_by.focus({ preventScroll: true });
    play.hidden = true;
  }

  /** @param {string} experiment @param {HTMLElement} button */
  function run(experiment, button) {
    stop();
    asked_by = button;
    /** @type {Experiment} */
    const begun = JSON.parse(experiment);
    now = begun;
    says.textContent = begun.says;
    const { size, column, row } = states.zoomed(act.state(), { zoom: 0 });
    act.replace({ ...states.start(), size, column, row, ...begun.begin });
    play.hidden = false;
    pause_button.focus({ preventScroll: true }); // a space bar would begin anew
    if (!no_motion.matches) {
      share = 0;
      return go_on();
    }
    put(rescaled(begun.still, begun.from, begun.to, 0, 1));
  }

  /** Let one quantity run through its range, from where it is. @param {string} name @param {HTMLElement} button */
  function play_alone(name, button) {
    const is_same = now?.moves === name && now.says === "";
    if (is_same && now !== OPENING) return toggle();
    stop();
    asked_by = button;
    lamp = act.state().lamp;
    const { dataset } = button;
    const [from, to] = [Number(dataset.from), Number(dataset.to)];
    now = { says: "", begin: {}, moves: name, from, to, still: from, seconds: 10 };
    play.hidden = false;
    const value = name === "eps" ? Math.log10(act.state().eps) : act.state()[name];
    share = name === "lamp" ? 0 : clamp(0, rescaled(value, from, to, 0, 1), 1);
    if (!no_motion.matches) go_on();
    else bar.value = String(share);
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
  for (const kind of ["pointerdown", "keydown", "focusin", "wheel"])
    root.addEventListener(kind, () => now === OPENING && stop(), { passive: true });
  root.addEventListener("focusin", (event) => is_typed(event) && pause()); // what moves would write into the box
  bar.addEventListener("input", () => {
    pause();
    put(Number(bar.value));
  });
  return { open, run, play_alone, pause, stop, reset, toggle, step, running: () => frame !== 0 };
}

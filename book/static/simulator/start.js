// Joins the parts: one state, shown everywhere, changed through `set`.
"use strict";

/** @param {HTMLElement} root @param {WebAssembly.Module} compiled @param {SimulatorModule} module */
function simulator_start(root, compiled, module) {
  const data = Simulator.data;
  /** @param {string} selector */
  const $ = (selector) => find_element(root, selector);
  const AT_REST = 100; // milliseconds after the last change the panels follow,
  const MOVING = 500; // or so long after the first
  const sizes = Array.from(/** @type {HTMLSelectElement} */ ($("#sim-size")).options, ({ value }) => Number(value));
  // Every field and every model of light that the renderer knows; the page has the chapter's models already.
  for (const name of [...Object.keys(data.fields), "own"]) {
    const button = make_element("input", { type: "radio", name: "sim-field", value: name });
    $("[data-parameter=field]").append(make_element("label", {}, button, ` ${name}`), "\n");
  }
  for (const name of Object.keys(data.models)) {
    if (!root.querySelector(`#sim-model [value="${name}"]`)) $("#sim-model").append(new Option(name, name));
  }
  const states = simulator_states(root, data, (of) => module.own_of(of)?.has_seam ?? false);
  let state = states.start();
  /** @type {State | null} */
  let shown = null;
  /** @type {Lines} */
  let pixel_curve = {};
  /** @type {Map<number, PicturePoint>} */
  let picture = new Map();
  /** @type {typeof picture} */
  const none = new Map();
  let picture_of = "";
  let pixel_of = "";
  let counted_of = "";
  let addressed = state;
  let wanted = 0;
  let saved = 0;
  let shown_panels = 0;
  let moved_since = 0;
  let is_sized = false; // by the reader, and not by the screen
  /** @type {State[]} */
  const past = [];
  /** @type {State[]} */
  const undone = [];
  let drawn_size = state.size;
  /** @type {{ ready: number }[]} */
  const frames = []; // milliseconds from a change to its pictures in the canvases

  /** @param {string} left_out */
  function key_without(left_out) {
    const names = Object.keys(states.parameters).filter((name) => !`axis ${left_out}`.split(" ").includes(name));
    /** @param {State} of */
    return (of) => names.map((name) => of[name]).join();
  }
  const drawn_key = key_without("column row");
  const pixel_key = key_without("eps view scale model lights lamp ball beta");
  const curve_key = key_without("eps view scale column row");
  const chambers_key = key_without("eps view scale column row model method");

  function panels_soon() {
    moved_since ||= performance.now();
    clearTimeout(wanted);
    wanted = setTimeout(panels, clamp(0, moved_since + MOVING - performance.now(), AT_REST));
  }

  /** Take a checked state, and show it: the pictures as soon as the workers can, the panels at a slower pace. @param {State} next */
  function take(next) {
    const redraw = drawn_key(next) !== drawn_key(state);
    module.own_of(next); // which refuses what is not finite
    state = next;
    if (redraw) engine.ask(state);
    else pictures.decorate(state);
    controls.show(state);
    lamp.show(state);
    root.classList.toggle("sim-zoomed", state.zoom > 0); // a finger then moves the part that is shown, and not the page
    if (shown_panels) curve.mark(state.eps);
    panels_soon();
    root.dispatchEvent(new Event("state")); // for bounds, which are of one state alone
    clearTimeout(saved);
    saved = setTimeout(put_into_address, 300);
  }

  // What changes the pictures is a step that can be undone; where the cursor is, is none, and leaves the address of another
  // place as it is. The browser's Back leaves the page.
  function put_into_address(is_asked = false) {
    const is_step = drawn_key(state) !== drawn_key(addressed);
    if (is_asked || is_step || /^(#sim|$)/.test(location.hash)) history.replaceState(null, "", states.fragment(state));
    if (!is_step) return;
    past.push(addressed);
    undone.length = 0;
    addressed = state;
    offer();
  }

  function offer() {
    for (const [name, list] of Object.entries({ undo: past, redo: undone }))
      $(`[data-${name}]`).toggleAttribute("disabled", list.length === 0);
  }

  /** Go to the last state of one list, and put this one on the other. @param {State[]} from @param {State[]} to */
  function go(from, to) {
    if (state !== addressed) put_into_address();
    const next = from.pop();
    if (!next) return;
    to.push(state);
    presets.stop();
    is_sized = true;
    act.replace(next);
    addressed = state;
    offer();
  }

  /** @type {Act} */
  const act = {
    state: () => state,
    // What the reader's hand does; it ends an experiment.
    set(changes) {
      const next = "size" in changes ? states.zoomed(state, changes) : state;
      is_sized ||= "size" in changes;
      take(states.changed(next, changes));
      presets.stop();
      say(root, "");
    },
    change: (changes) => take(states.changed(state, changes)),
    replace(next) {
      controls.clear();
      say(root, "");
      take(states.changed(next, {}));
    },
    // The shown part, or the cursor, as near to a place as may be.
    put: (place) => take(states.within({ ...state, ...place })),
    move: (by) => take(states.moved(state, by)),
    zoom(steps, at = states.share_of_cursor(state)) {
      presets.stop();
      take(states.zoomed(state, { zoom: clamp(0, state.zoom + steps, states.FURTHEST) }, at));
    },
    // The part of the raster around the pole, at a zoom.
    to_pole(zoom) {
      const next = { ...state, zoom };
      const pole = module.placing_in({ ...states.crop(next), left: 0, top: 0 })(0, 0);
      const [left, top] = pole.map((at) => at - state.size / 2);
      const [column, row] = pole.map(Math.floor);
      return states.within({ ...next, left, top, column, row });
    }
  };

  const controls = simulator_controls(root, states, act);
  const presets = simulator_presets(root, states, act);
  const readouts = simulator_readouts(root, data, module);
  const pictures = simulator_pictures(root, states, data, module);
  const layout = simulator_layout(root, pictures.resized);
  const theorem = document.querySelector('.bd-article a[href*="#theorem-bump_moves_no_boundary"]:not(.simulator *)');
  $("[data-theorem]").textContent = theorem ? `(${theorem.textContent})` : "";
  const hand = simulator_hand(pictures, act);
  const lamp = simulator_lamp(root, states, module, act);
  const curve = simulator_curve(root, module);
  const cursor = simulator_cursor(root, states, data, module);

  // The raster has about as many pixels as the screen has for it, unless the reader chose.
  function fit() {
    const size = layout.size_of_screen(sizes);
    if (!is_sized && size !== state.size) take(states.zoomed(state, { size }));
    layout.fit(state.size);
  }

  function panels() {
    wanted = 0;
    moved_since = 0;
    if (document.hidden) return;
    if (pixel_key(state) !== pixel_of) pixel_curve = curve.at_pixel(state, states.crop(state));
    pixel_of = pixel_key(state);
    curve.show(state, pixel_curve, picture_of === curve_key(state) ? picture : none, pictures.still);
    readouts.captions(state);
    cursor.show(state); // after the curve, which asks how wide it is
    root.dispatchEvent(new CustomEvent("pixel", { detail: state })); // for what shows more of it, such as the loupe
    shown_panels = performance.now();
  }

  /** What the workers found of their bands, of all of them. @param {(Drawn | Followed)[]} replies */
  function apart(replies) {
    const count = total(replies, (reply) => reply.count);
    const rms = count && Math.sqrt(total(replies, (reply) => reply.squares) / 3 / count);
    return { count, max: Math.max(...replies.map(({ largest }) => largest)), size: rms };
  }

  /** @type {Handlers} */
  const handlers = {
    painted: pictures.paint,
    drawn(of, replies, asked, by_page, is_whole) {
      if (of.size !== drawn_size) layout.fit(of.size);
      drawn_size = of.size;
      pictures.show(of, by_page);
      pictures.decorate(state);
      const ready = performance.now() - asked;
      readouts.apart(apart(replies), is_whole, replies[0].end);
      if (is_whole) shown = of;
      if (counted_of !== chambers_key(of)) readouts.counted(null);
      requestAnimationFrame(() => {
        frames.push({ ready });
        // Seen first in a frame of its own: what gets its place and is shown in one frame counts as moved.
        requestAnimationFrame(() => (root.hidden = false));
      });
    },
    // What the workers do while nothing moves.
    resting(of) {
      counted_of = chambers_key(of);
      if (picture_of === curve_key(of) && picture.size === curve.COARSE.length) return null;
      picture = new Map();
      picture_of = curve_key(of);
      return curve.COARSE;
    },
    counted(all) {
      const attached = all[0].attached.map((_, n) => total(all, (reply) => reply.attached[n]));
      readouts.counted({ count: total(all, ({ count }) => count), flips: total(all, ({ flips }) => flips), attached });
    },
    followed(all) {
      const eps = curve.COARSE[all[0].index];
      const still = all[0].still.map((level, cell) => Math.max(level, ...all.map((one) => one.still[cell])));
      picture.set(eps, { eps, ...apart(all), still });
      panels_soon();
    },
    failed: (why) =>
      say(root, `The browser’s workers draw nothing here (${why}): the page draws alone, and answers more slowly.`)
  };
  const engine = simulator_engine(data, compiled, states, module, handlers);

  /** @type {HTMLSelectElement} */
  const examples = find_element(root, "#sim-example");
  examples.addEventListener("change", () => {
    if (examples.value) act.set({ field: "own", h: examples.value });
    examples.value = "";
  });

  /** @param {string} text @param {Element} element */
  async function copy(text, element) {
    const told = $(".sim-copied");
    try {
      await navigator.clipboard.writeText(text);
      told.textContent = "copied";
    } catch {
      getSelection()?.selectAllChildren(element);
      told.textContent = "selected: copy it with the keyboard";
    }
  }

  /** What each button does, by its name: told the button's value. @type {Record<string, (value: string, button: HTMLElement) => void>} */
  const buttons = {
    preset: presets.run,
    play: presets.play_alone,
    pause: presets.toggle,
    step: (steps) => presets.step(Number(steps)),
    stop: presets.stop,
    apart: layout.toggle_apart,
    large: layout.toggle_large,
    save: (name) => download(`${state.field}-eps${state.eps}-${name}.png`, pictures.file(name, state)),
    undo: () => go(past, undone),
    redo: () => go(undone, past),
    svg: () => download("u-curve.svg", `data:image/svg+xml,${encodeURIComponent(curve.picture())}`),
    zoom: (steps) => act.zoom(Number(steps)),
    reset() {
      presets.reset();
      hand.release();
      is_sized = false;
      act.replace(states.start());
      fit();
    },
    copy: () => copy(states.python(state), $(".sim-python code")),
    link(_, button) {
      put_into_address(true);
      copy(location.href, button);
    }
  };

  // The loupe and the certified bounds are fetched when they are first in sight; the one file has them.
  let is_close = false;
  async function look_closer() {
    if (is_close) return;
    is_close = true;
    const parts = await closer_parts(data, compiled);
    const [all, ...programs] = parts;
    const loupe = simulator_loupe(root, states, all, await simulator_module(all, ...programs), act);
    const certified = simulator_certified(root, states, parts, pictures.show_bounds);
    function show() {
      loupe.show(state);
      certified.ask(state);
    }
    root.addEventListener("pixel", show);
    root.addEventListener("state", () => certified.ask(state));
    show();
  }

  // Take the state of the address, if it has one; say what is wrong with it, if anything is.
  function from_address(hash = location.hash) {
    try {
      const next = states.from_fragment(hash);
      if (next) {
        presets.stop();
        is_sized = true; // 256 where the address says nothing
        act.replace(next);
        addressed = state;
      }
      return next !== null;
    } catch (error) {
      history.replaceState(null, "", states.fragment(state));
      say(root, `${error_text(error)}. Nothing was changed.`);
      return true;
    }
  }

  for (const [name, work] of Object.entries(buttons)) {
    for (const button of find_all(root, `button[data-${name}]`))
      button.addEventListener("click", () => work(button.getAttribute(`data-${name}`) ?? "", button));
  }
  when_near(["#loupe", "#certified"].map($), look_closer, "0%");
  controls.show(state);
  lamp.show(state);
  fit(); // before anything is drawn in it, which else moves once more
  if (from_address()) root.scrollIntoView();
  addressed = state;
  engine.start();
  if (!location.hash || root.closest(":target")) when_near([root], presets.open, "0%");
  document.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || is_typed(event) || !"zy".includes(event.key.toLowerCase())) return;
    event.preventDefault();
    if (event.key.toLowerCase() === "z" && !event.shiftKey) go(past, undone);
    else go(undone, past);
  });
  window.addEventListener("hashchange", ({ newURL }) => from_address(new URL(newURL || location.href).hash));
  const fitting = new ResizeObserver(fit);
  for (const part of [layout.page, layout.room]) fitting.observe(part); // the page is still sliding when the window tells
  new ResizeObserver(panels_soon).observe($(".sim-curve")); // also what stands beside it changes its width
  window.addEventListener("resize", fit);
  document.addEventListener("visibilitychange", () => {
    if (document.hidden) {
      presets.pause();
      engine.stop();
    } else {
      engine.start();
      panels();
    }
  });
  return {
    act,
    states,
    module,
    cursor,
    curve,
    frames,
    presets,
    pictures,
    shown: () => shown && states.fragment(shown)
  };
}

/**
 * What a module of both programs is made of, once the scripts that wait are there.
 * @param {SimulatorData} data
 * @param {WebAssembly.Module} compiled
 * @returns {Promise<CloserParts>}
 */
async function closer_parts(data, compiled) {
  /** @type {HTMLScriptElement[]} */
  const later = find_all(document, "script[data-later][src]");
  for (const { src } of later) await load_script(src);
  const { program, kernels, ...more } = Simulator.closer;
  return [{ ...data, ...more, kernels: { ...data.kernels, ...kernels } }, compiled, await compiled_program(program)];
}

/** @param {HTMLElement} root @param {string} text */
function say(root, text) {
  find_element(root, ".sim-message").textContent = text; // hidden while it is empty
}

when_ready(async () => {
  const root = document.getElementById("simulator");
  if (!root) return;
  try {
    const compiled = await compiled_program(Simulator.program);
    Simulator.running = simulator_start(root, compiled, await simulator_module(Simulator.data, compiled));
  } catch (error) {
    root.classList.add("sim-failed");
    root.hidden = false;
    say(root, `The simulator could not start (${error_text(error)}). The figure below shows the three fields.`);
  }
});

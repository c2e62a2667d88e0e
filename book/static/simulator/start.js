// Joins the parts: one state, shown everywhere, changed through `set`.
"use strict";

Simulator.start = function (root, compiled, module) {
  const data = Simulator.data, states = Simulator.state(data), $ = (selector) => root.querySelector(selector);
  const PANELS_EVERY = 100; // milliseconds
  add_choices();
  let state = states.start(), shown = null, wanted = 0, saved = 0, picture = [], picture_of = "", pixel_curve = null, pixel_of = "", shown_panels = 0;
  const none = [];
  let counting = "", counted_of = "", timed_of = "";
  const frames = []; // milliseconds from a change to its pictures in the canvases, and to the end of the frame that shows them

  // Every field and every model of light that the renderer knows; the page has the chapter's models already.
  function add_choices() {
    const models = $("#sim-model"), labels = Object.keys(data.fields).map((name) => `<label><input type="radio" name="sim-field" value="${name}"> ${name}</label>`);
    $("[data-parameter=field]").insertAdjacentHTML("beforeend", labels.join("\n"));
    for (const name of Object.keys(data.models)) if (!models.querySelector(`[value="${name}"]`)) models.add(new Option(name, name));
  }

  function message(text) {
    $(".sim-message").textContent = text;
    $(".sim-message").hidden = !text;
  }

  const names = Object.keys(states.parameters);
  const key_without = (...left_out) => (of) => names.filter((name) => !left_out.includes(name)).map((name) => of[name]).join();
  const drawn_key = key_without("column", "row"), pixel_key = key_without("eps", "view", "scale", "model", "lights", "ball", "beta");
  const curve_key = key_without("eps", "view", "scale", "column", "row");
  const chambers_key = key_without("eps", "view", "scale", "column", "row", "model", "method"), times_key = key_without("eps", "view", "scale", "column", "row", "beta");
  const panels_soon = (after = 0) => (wanted = wanted || setTimeout(panels, Math.max(after, shown_panels + PANELS_EVERY - performance.now())));

  // Take a checked state, and show it: the pictures as soon as the workers can, the panels at a slower pace.
  function take(next) {
    const redraw = drawn_key(next) !== drawn_key(state);
    state = next;
    if (redraw) engine.ask(state);
    else pictures.decorate(state);
    controls.show(state);
    if (shown_panels) curve.mark(state.eps);
    panels_soon();
    clearTimeout(saved);
    saved = setTimeout(() => history.replaceState(null, "", states.fragment(state)), 300);
  }

  const act = {
    state: () => state,
    // What the reader's hand does; it ends an experiment.
    set(changes) {
      const next = "size" in changes ? states.zoomed(state, changes) : state;
      take(states.changed(next, changes));
      presets.stop();
      message("");
    },
    change: (changes) => take(states.changed(state, changes)),
    replace(next) {
      controls.clear();
      message("");
      take(states.changed(next, {}));
    },
    cursor: (column, row) => take(states.within({ ...state, column, row })),
    move: (dx, dy) => take(states.moved(state, dx, dy)),
    zoom(steps, across, down) {
      presets.stop();
      const zoom = Math.max(0, Math.min(states.FURTHEST, state.zoom + steps));
      const at = [(state.column - state.left + 0.5) / state.size, (state.row - state.top + 0.5) / state.size];
      take(states.zoomed(state, { zoom }, across ?? at[0], down ?? at[1]));
    },
    pan: (left, top) => take(states.within({ ...state, left, top })),
    // The part of the raster around the pole, at a zoom.
    to_pole(zoom) {
      const next = { ...state, zoom }, { across, down } = pictures.frame(next), half = state.size / 2, share = zoom / 10;
      const place = { left: (across - half) * share, top: (down - half) * share, column: across, row: down };
      const { left, top, column, row } = states.within({ ...next, ...place, column: Math.floor(across), row: Math.floor(down) });
      return { zoom, left, top, column, row };
    },
  };

  const controls = Simulator.controls(root, states, act), presets = Simulator.presets(states, act), readouts = Simulator.readouts(root, data);
  const pictures = Simulator.pictures(root, states, data, module, act);
  const curve = Simulator.curve(root, data, module, act), cursor = Simulator.cursor(root, states, data, module);
  const engine = Simulator.engine(data, compiled, states, module, { drawn, resting, counted, followed, timed, failed });

  function panels() {
    wanted = 0;
    if (document.hidden) return;
    if (pixel_key(state) !== pixel_of) pixel_curve = curve.at_pixel(state, states.crop(state));
    pixel_of = pixel_key(state);
    curve.show(state, pixel_curve, picture_of === curve_key(state) ? picture : none);
    readouts.captions(state);
    cursor.show(state); // after the curve, which asks how wide it is
    shown_panels = performance.now();
  }

  const total = (replies, name) => replies.reduce((sum, reply) => sum + reply[name], 0);

  function drawn(of, replies, asked) {
    pictures.paint(of, replies);
    pictures.decorate(state);
    const ready = performance.now() - asked;
    readouts.apart({ count: total(replies, "count"), largest: Math.max(...replies.map((r) => r.largest)), squares: total(replies, "squares") });
    if (counted_of !== chambers_key(of)) readouts.counted(null);
    if (timed_of !== times_key(of)) readouts.forget_times();
    timed_of = times_key(of);
    requestAnimationFrame((at) => frames.push({ ready, at, painted: performance.now() - asked }));
    shown = of;
  }

  // What the workers do while nothing moves.
  function resting(of) {
    counting = chambers_key(of);
    if (picture_of === curve_key(of) && picture.filter(Boolean).length === curve.COARSE.length) return null;
    picture = [];
    picture_of = curve_key(of);
    return curve.COARSE;
  }

  // What the workers found, each of its band.
  function counted(all) {
    counted_of = counting;
    const attached = all[0].attached.map((_, n) => all.reduce((sum, { attached }) => sum + attached[n], 0));
    readouts.counted({ count: total(all, "count"), flips: total(all, "flips"), attached });
  }

  function followed(all) {
    const [{ index }] = all, count = total(all, "count");
    picture[index] = { eps: curve.COARSE[index], rms: count ? Math.sqrt(total(all, "squares") / 3 / count) : 0, max: Math.max(...all.map((r) => r.largest)) };
    panels_soon();
  }

  function timed(all) {
    readouts.timed(...["numeric", "symbolic"].map((name) => Math.max(...all.map((r) => r[name]))));
  }

  function failed(text) {
    engine.stop();
    Simulator.fail(root, text);
  }

  const download = (name, href) => Object.assign(document.createElement("a"), { href, download: name }).click();

  async function copy(text, element) {
    try {
      await navigator.clipboard.writeText(text);
      $(".sim-copied").textContent = "copied";
    } catch {
      getSelection().selectAllChildren(element);
      $(".sim-copied").textContent = "selected: copy it with the keyboard";
    }
  }

  const on = (selector, work) => root.querySelectorAll(selector).forEach((button) => button.addEventListener("click", () => work(button.dataset, button)));

  function buttons() {
    on("[data-preset]", ({ preset }) => {
      presets.run(preset);
      $(".sim-says").textContent = presets.says(preset);
    });
    on("[data-save]", ({ save }) => download(`${save}.png`, pictures.canvas(save).toDataURL()));
    on("[data-zoom]", ({ zoom }) => act.zoom(Number(zoom)));
    on("[data-reset]", () => (presets.stop(), pictures.release(), act.replace(states.start())));
    on("[data-csv]", () => download("u-curve.csv", `data:text/csv,${encodeURIComponent(curve.csv(pixel_curve, picture))}`));
    on("[data-copy]", () => copy(states.python(state), $(".sim-python code")));
    on("[data-link]", (_, button) => {
      history.replaceState(null, "", states.fragment(state));
      copy(location.href, button);
    });
  }

  // Take the state of the address, if it has one; say what is wrong with it, if anything is.
  function from_address() {
    try {
      const next = states.from_fragment(location.hash);
      if (next) act.replace(next);
      return next !== null;
    } catch (error) {
      message(`${error.message}. Nothing was changed.`);
      return true;
    }
  }

  buttons();
  engine.start();
  controls.show(state);
  engine.ask(state);
  panels();
  if (from_address()) root.scrollIntoView();
  window.addEventListener("hashchange", from_address);
  window.addEventListener("resize", () => panels_soon());
  document.addEventListener("visibilitychange", () => (document.hidden ? (presets.stop(), engine.stop()) : (engine.start(), panels())));
  return { act, states, module, cursor, curve, frames, presets, shown: () => shown && states.fragment(shown) };
};

Simulator.fail = function (root, text) {
  root.classList.add("sim-failed");
  root.querySelector(".sim-message").textContent = `The simulator could not start (${text}). The figure below shows the three fields.`;
  root.querySelector(".sim-message").hidden = false;
};

document.addEventListener("DOMContentLoaded", async () => {
  const root = document.getElementById("simulator");
  if (!root) return;
  root.hidden = false;
  try {
    const compiled = await Simulator.compiled(Simulator.program);
    Simulator.running = Simulator.start(root, compiled, await Simulator.module(Simulator.data, compiled));
  } catch (error) {
    Simulator.fail(root, error.message);
  }
});

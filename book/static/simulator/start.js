// Joins the parts: one state, shown everywhere, changed through `set`.
"use strict";
var Simulator = Simulator || {};

Simulator.start = function (root, compiled, module) {
  const data = Simulator.data, states = Simulator.state(data), $ = (selector) => root.querySelector(selector);
  add_fields($("[data-parameter=field]"));
  add_models($("#sim-model"));
  let state = states.start(), wanted = 0, saved = 0, picture = [], picture_of = "", pixel_curve = null;
  let pixel_key = "", shown_panels = 0;
  const PANELS_EVERY = 100; // milliseconds
  const times = { numeric: [], symbolic: [], of: "" }, sums = {};

  // The page has the chapter's three fields; any other that the renderer knows gets a button too.
  function add_fields(menu) {
    for (const name of Object.keys(data.fields)) {
      if (menu.querySelector(`input[value="${name}"]`)) continue;
      menu.insertAdjacentHTML("beforeend", `<label><input type="radio" name="sim-field" value="${name}"> ${name}</label>`);
    }
  }

  // So do the models of light: the menu has the names of two.
  function add_models(menu) {
    for (const name of Object.keys(data.models)) {
      if (![...menu.options].some(({ value }) => value === name)) menu.add(new Option(name, name));
    }
  }

  function message(text) {
    $(".sim-message").textContent = text;
    $(".sim-message").hidden = !text;
  }

  // Take a checked state, and show it: the panels at the next frame, the pictures as soon as the workers can.
  function take(next) {
    const drawn = ({ column, row, ...rest }) => JSON.stringify(rest);
    const redraw = drawn(next) !== drawn(state);
    state = next;
    controls.show(state);
    if (redraw) engine.ask(state);
    else pictures.decorate(state);
    if (shown_panels) curve.mark(state.eps, pixel_curve);
    wanted = wanted || setTimeout(panels, Math.max(0, shown_panels + PANELS_EVERY - performance.now()));
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
      controls.forgive();
      message("");
      take(states.changed(next, {}));
    },
    cursor: (column, row) => take(states.within({ ...state, column, row })),
    move(dx, dy) {
      const left = state.left + Math.min(0, state.column + dx - state.left);
      const top = state.top + Math.min(0, state.row + dy - state.top);
      const right = Math.max(0, state.column + dx - state.left - state.size + 1);
      const down = Math.max(0, state.row + dy - state.top - state.size + 1);
      const last = states.side(state) - 1, clamp = (x) => Math.max(0, Math.min(last, x));
      take(states.within({ ...state, left: left + right, top: top + down, column: clamp(state.column + dx), row: clamp(state.row + dy) }));
    },
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

  const controls = Simulator.controls(root, states, act), presets = Simulator.presets(states, act);
  const pictures = Simulator.pictures(root, states, data, module, act);
  const curve = Simulator.curve(root, data, module), cursor = Simulator.cursor(root, states, module);
  const engine = Simulator.engine(data, compiled, states, module, { drawn, resting, counted, followed, timed, failed });

  // What is written beside the pictures follows at a slower pace, so that they are not kept waiting.
  function panels() {
    wanted = 0;
    if (document.hidden) return;
    cursor.show(state);
    const { eps, view, scale, ...rest } = state, key = JSON.stringify(rest);
    if (key !== pixel_key) pixel_curve = curve.at_pixel(state, states.crop(state));
    pixel_key = key;
    show_curve();
    captions();
    shown_panels = performance.now();
  }

  // The picture's curve belongs to everything but epsilon and what does not change |dI|.
  const curve_key = ({ eps, view, scale, column, row, ...rest }) => JSON.stringify(rest);
  const show_curve = () => curve.show(state, pixel_curve, picture_of === curve_key(state) ? picture : []);

  function captions() {
    const names = { central: "central difference", forward: "forward difference", central4: "fourth-order difference" };
    $("[data-title=numeric]").textContent = `${names[state.method]}, ε = ${short(state.eps)}`;
    $("[data-title=symbolic]").textContent = "exact gradient";
    $("[data-title=difference]").textContent = state.scale === "log" ? "|ΔI|, logarithmic" : state.scale === "1e0" ? "|ΔI|" : `|ΔI| × ${short(Number(state.scale))}`;
    root.classList.toggle("sim-linear", state.scale !== "log");
    const none = state.view === "loci" && !data.fields[state.field].creases.length;
    const zoomed = state.zoom ? `${(2 ** (state.zoom / 2)).toPrecision(3)} ×` : "1 ×";
    $(".sim-zoom output").textContent = zoomed;
    $(".sim-remark").textContent = none ? `${state.field} has no creases: there is nothing to draw over it.` : "";
  }

  function short(x) {
    const [digits, power] = x.toExponential().split("e").map(Number), up = [..."⁰¹²³⁴⁵⁶⁷⁸⁹"];
    if (x >= 0.01 && x < 1000) return String(x);
    const exponent = (power < 0 ? "⁻" : "") + [...String(Math.abs(power))].map((d) => up[d]).join("");
    return digits === 1 ? `10${exponent}` : `${Number(digits.toPrecision(3))} · 10${exponent}`;
  }

  const number = (x) => (x === 0 ? "0" : x.toExponential(2).replace("e-", "e−").replace("e+", "e"));
  const put = (name, text) => ($(`[data-readout=${name}]`).textContent = text);
  const median = (list) => list.slice().sort((a, b) => a - b)[list.length >> 1];

  function drawn(of, replies, asked) {
    pictures.paint(of, replies);
    pictures.decorate(state);
    const count = replies.reduce((n, r) => n + r.count, 0), sum = replies.reduce((s, r) => s + r.sum, 0);
    put("max", count ? number(Math.max(...replies.map((r) => r.max))) : "—");
    put("rms", count ? number(Math.sqrt(sum / 3 / count)) : "—");
    const kind = JSON.stringify([of.size, of.field, of.method, of.ku, of.kv, of.model, of.zoom, of.lights, of.ball]);
    if (times.of !== kind) Object.assign(times, { numeric: [], symbolic: [], of: kind });
    for (const name of ["numeric", "symbolic"]) {
      const taken = replies.map((r) => r.times[name]).filter((t) => t !== undefined);
      if (taken.length) keep_time(name, Math.max(...taken));
    }
    show_times();
    const old = root.dataset.counted !== chambers_key(of);
    if (old) for (const name of ["flips", "attached"]) put(name, "…");
    const ready = performance.now() - asked;
    requestAnimationFrame(() => setTimeout(() => frames.push({ ready, painted: performance.now() - asked })));
    root.dataset.drawn = states.fragment(of);
  }

  const frames = []; // milliseconds from a change to its pictures in the canvases, and to the end of the frame that shows them
  const chambers_key = ({ size, zoom, left, top, lights, ball, field, ku, kv, beta }) => JSON.stringify([size, zoom, left, top, lights, ball, field, ku, kv, beta]);

  function keep_time(name, time) {
    times[name].push(time);
    if (times[name].length > 15) times[name].shift();
  }

  function show_times() {
    if (!times.numeric.length || !times.symbolic.length) return;
    const [a, b] = [median(times.numeric), median(times.symbolic)];
    put("numeric", `${a.toFixed(1)} ms`);
    put("symbolic", `${b.toFixed(1)} ms`);
    put("ratio", b > 0 ? (a / b).toFixed(2) : "—");
  }

  // What the workers do while nothing moves.
  function resting(of) {
    for (const name of Object.keys(sums)) delete sums[name];
    root.dataset.counting = chambers_key(of);
    if (picture_of === curve_key(of) && picture.filter(Boolean).length === curve.COARSE.length) return null;
    picture = [];
    picture_of = curve_key(of);
    return curve.COARSE;
  }

  // Add up what the bands report, and return it when all have.
  function joined(name, data, bands) {
    (sums[name] = sums[name] || []).push(data);
    return sums[name].length === bands ? sums[name] : null;
  }

  function counted(data, bands) {
    const all = joined("counted", data, bands);
    if (!all) return;
    const count = all.reduce((n, d) => n + d.count, 0);
    root.dataset.counted = root.dataset.counting;
    put("flips", String(all.reduce((n, d) => n + d.flips, 0)));
    const shares = all[0].attached.map((_, n) => {
      const whole = all.reduce((sum, d) => sum + d.attached[n], 0);
      return `${whole.toLocaleString("en")} (${count ? Math.round((100 * whole) / count) : 0} %)`;
    });
    put("attached", shares.join(", ") || "no light is on");
  }

  function followed(data, bands) {
    const all = joined(`eps ${data.index}`, data, bands);
    if (!all) return;
    const count = all.reduce((n, d) => n + d.count, 0);
    const rms = count ? Math.sqrt(all.reduce((s, d) => s + d.sum, 0) / 3 / count) : 0;
    picture[data.index] = { eps: curve.COARSE[data.index], rms, max: Math.max(...all.map((d) => d.max)) };
    wanted = wanted || setTimeout(panels, PANELS_EVERY);
  }

  function timed(data, bands) {
    const all = joined("timed", data, bands);
    if (!all) return;
    for (const name of ["numeric", "symbolic"]) all[0].times[name].forEach((_, n) => keep_time(name, Math.max(...all.map((d) => d.times[name][n]))));
    show_times();
  }

  function failed(text) {
    engine.stop();
    Simulator.fail(root, text);
  }

  function download(name, blob) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }

  async function copy() {
    const code = $(".sim-python code");
    try {
      await navigator.clipboard.writeText(code.textContent);
      $(".sim-copied").textContent = "copied";
    } catch {
      getSelection().selectAllChildren(code);
      $(".sim-copied").textContent = "selected: copy it with the keyboard";
    }
  }

  function buttons() {
    for (const button of root.querySelectorAll("[data-preset]")) button.addEventListener("click", () => presets.run(button.dataset.preset));
    for (const button of root.querySelectorAll("[data-save]")) {
      const name = button.dataset.save;
      button.addEventListener("click", () => pictures.canvas(name).toBlob((blob) => download(`${name}.png`, blob)));
    }
    for (const button of root.querySelectorAll("[data-zoom]")) button.addEventListener("click", () => act.zoom(Number(button.dataset.zoom)));
    $("[data-reset]").addEventListener("click", () => (presets.stop(), pictures.release(), act.replace(states.start())));
    $("[data-csv]").addEventListener("click", () => download("u-curve.csv", new Blob([curve.csv(pixel_curve, picture)], { type: "text/csv" })));
    $("[data-copy]").addEventListener("click", copy);
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

  function color_bar() {
    const canvas = $(".sim-bar canvas"), context = canvas.getContext("2d"), row = new ImageData(256, 1);
    for (let i = 0; i < 256; i++) {
      for (let c = 0; c < 3; c++) row.data[4 * i + c] = parseInt(data.inferno.slice(6 * i + 2 * c, 6 * i + 2 * c + 2), 16);
      row.data[4 * i + 3] = 255;
    }
    context.putImageData(row, 0, 0);
  }

  color_bar();
  buttons();
  engine.start();
  controls.show(state);
  engine.ask(state);
  panels();
  if (from_address()) root.scrollIntoView();
  window.addEventListener("hashchange", from_address);
  window.addEventListener("resize", () => (wanted = wanted || setTimeout(panels, 0)));
  document.addEventListener("visibilitychange", () => (document.hidden ? (presets.stop(), engine.stop()) : (engine.start(), panels())));
  window.addEventListener("pagehide", () => engine.stop());
  window.addEventListener("pageshow", (event) => event.persisted && engine.start());
  return { act, states, module, cursor, curve, frames, presets };
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

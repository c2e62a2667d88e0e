// What a worker does, or the page itself: draw and paint a band of rows for a state; when nothing is asked, time both pipelines, count
// flips, and follow the U-curve of the band. Only what a change touches is computed anew.
"use strict";

Simulator.worker = function (port) {
  const ROUNDS = 12, exact = { name: "exact" };
  let kept = {}; // name -> {key, value, fresh, version}
  let module, pending = null, timer = 0, versions = 0; // pending: the idle work that is left

  // What was made for this key, or what is made now. A key is a list of numbers and names.
  function keep(name, key, make = () => null) {
    const old = kept[name], fresh = !old || old.key.length !== key.length || key.some((part, n) => part !== old.key[n]);
    if (fresh) kept[name] = { key, value: make(), version: ++versions };
    return Object.assign(kept[name], { fresh });
  }

  const difference = (state) => ({ name: state.method, eps: state.eps });

  // The chambers and the chart, and what is around A: what no bump changes.
  function staged(state, { left, top, wide, high, width }) {
    const raster = { left, top, wide, high, width, height: width };
    const stage = keep("stage", [state.ball, ...state.lights, left, top, wide, high, width], () => module.make_stage(state, raster));
    keep("around", [stage.version, state.model], () => {
      for (const name of ["numeric", "symbolic", "spare"]) module.draw_elsewhere(state, stage.value, name);
    });
    return stage.value;
  }

  // Draw A by one method, if anything that it depends on has changed.
  function drawn(name, method, state, stage) {
    const key = [kept.around.version, state.field, state.ku, state.kv, state.beta, method.name, method.eps];
    keep(name, key, () => module.draw_a(state, method, stage, name));
  }

  // What a view shows of A's pixels, one after another: null for the image itself.
  function shown(name, { view, field, ku, kv, eps, ...state }, stage) {
    if (["image", "loci"].includes(view)) return null;
    const [u, v] = module.chart(stage);
    if (view === "straddle") return module.kernel(`straddling_${field}`, u, v, ku, kv, eps);
    if (view === "kink") return module.kernel(`kink_${field}`, module.angles_of(stage)[3], u, v, ku, kv);
    if (view === "terms") return name === "numeric" ? module.bounds({ ...state, field, ku, kv }, u, v, eps)?.[1] : null;
    const method = name === "numeric" ? { name: state.method, eps } : exact;
    return module.kernel("slope", ...module.gradients({ ...state, field, ku, kv }, method, stage));
  }

  function paint_view(name, state, stage, whole) {
    const values = shown(name, state, stage);
    if (values) module.fill(stage, values);
    if (values && state.view === "terms") module.paint("paint_levels", stage, name, { whole, palette: "terms" });
    else if (values && state.view === "slope") {
      const waves = module.wave_numbers(state) || [state.ku, state.kv], steepest = module.kernel("slope_bound", Math.max(...waves.map(Math.abs)));
      module.paint("paint_levels", stage, name, { whole, gain: steepest > 0 ? 255 / steepest : 0 });
    } else {
      module.paint("paint_colors", stage, name, { whole });
      if (values) module.paint("paint_flags", stage, name, { whole });
    }
  }

  function paint_difference({ scale }, stage, into, whole) {
    const way = scale === "log" ? ["paint_difference_logarithmic", { table: "sizes", palette: "inferno" }] : ["paint_difference_linear", { gain: Number(scale) }];
    return module.paint(way[0], stage, into, { ...way[1], whole, of: "numeric", other: "symbolic" });
  }

  function draw({ id, state, band, buffers, anew }) {
    if (anew) kept = {};
    const stage = staged(state, band), new_stage = kept.stage.fresh, images = {}, moved = [];
    drawn("numeric", difference(state), state, stage);
    drawn("symbolic", exact, state, stage);

    // Paint a picture if what it shows has changed: all of it if what is around A has, too.
    function picture(name, around, on_a, paint) {
      const whole = keep(`around ${name}`, around).fresh, part = keep(`${name} on A`, [...around, ...on_a], () => paint(whole));
      if (!part.fresh) return;
      const rows = whole ? [0, band.high] : stage.rows, bytes = module.bytes(stage, name, rows);
      const buffer = buffers[name]?.byteLength === bytes.length ? buffers[name] : new ArrayBuffer(bytes.length);
      images[name] = { top: rows[0], bytes: new Uint8ClampedArray(buffer) };
      images[name].bytes.set(bytes);
      moved.push(buffer);
    }

    for (const name of ["numeric", "symbolic"]) {
      const by_step = ["straddle", "terms"].includes(state.view) && [state.eps, state.method].join();
      picture(name, [kept.around.version, state.view], [kept[name].version, by_step], (whole) => paint_view(name, state, stage, whole));
    }
    const pair = [kept.around.version, state.scale, kept.numeric.version, kept.symbolic.version];
    picture("difference", pair.slice(0, 1), pair.slice(1), (whole) => (kept.apart = paint_difference(state, stage, "difference", whole)));
    const codes = new_stage ? stage.codes.slice() : null;
    port.postMessage({ kind: "drawn", id, band, images, ...kept.apart, count: stage.count, codes }, codes ? [...moved, codes.buffer] : moved);
  }

  // How long A takes by a method, drawn again from nothing.
  function time_of(method, state, stage) {
    const begin = performance.now();
    module.draw_a(state, method, stage, "spare");
    return performance.now() - begin;
  }

  // Flips: pixels whose chamber, computed afresh for either side, is not the one that was drawn with. Attached: pixels
  // of A that the bump turns to the other side of a light.
  function count_flips(state, stage) {
    let flips = 0;
    for (const side of [state, { ...state, beta: 0 }]) {
      const codes = module.chambers_of(side, stage, stage.code_again);
      for (let i = 0; i < codes.length; i++) if (codes[i] !== stage.codes[i]) flips++;
    }
    return { flips, attached: module.turned(state, stage, "symbolic") };
  }

  // One piece of idle work a turn, so that a new state never waits longer than that.
  function* idle({ id, state, band, steps }) {
    const stage = staged(state, band);
    drawn("symbolic", exact, state, stage);
    yield { kind: "counted", id, ...count_flips(state, stage), count: stage.count };
    for (const [index, eps] of (steps || []).entries()) {
      module.draw_a(state, { name: state.method, eps }, stage, "spare");
      const found = module.paint("paint_difference_logarithmic", stage, "spare", { other: "symbolic", table: "sizes", palette: "inferno" });
      yield { kind: "followed", id, index, ...found, count: stage.count };
    }
    for (let index = 0; index < ROUNDS; index++) {
      yield { kind: "timed", id, index, numeric: time_of(difference(state), state, stage), symbolic: time_of(exact, state, stage) };
    }
  }

  function go_on() {
    const next = pending?.next();
    if (!next || next.done) return;
    port.postMessage(next.value);
    timer = setTimeout(go_on);
  }

  let ready; // messages are taken in their order once the module is there

  const begin = async ({ data, compiled }) => (module = await Simulator.module(data, compiled));

  async function receive(data) {
    await ready;
    pending = data.kind === "idle" ? idle(data) : null;
    clearTimeout(timer);
    if (pending) go_on();
    else if (data.kind === "draw") draw(data);
  }

  port.onmessage = ({ data }) => {
    if (data.kind === "begin") ready = begin(data);
    else receive(data);
  };
};

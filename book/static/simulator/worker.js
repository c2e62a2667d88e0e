// What a worker does: draw a band of rows for a state; when nothing is asked, time both pipelines, count flips, and
// follow the U-curve of the band. Only what a change touches is computed anew.
"use strict";
var Simulator = Simulator || {};

Simulator.worker = function (port) {
  let module, views;
  const kept = {}; // name -> {key, value}
  let pending = null; // the idle work that is left

  // The value made for this key, or a new one.
  function keep(name, key, make) {
    const text = JSON.stringify(key);
    if (!kept[name] || kept[name].key !== text) kept[name] = { key: text, value: make(kept[name]?.value), fresh: true };
    else kept[name].fresh = false;
    return kept[name].value;
  }

  const exact = { name: "exact" };
  const difference = (state) => ({ name: state.method, eps: state.eps });

  function staged(state, band) {
    const stage_key = [band, state.ball, state.lights];
    return { stage: keep("stage", stage_key, () => module.make_stage(state, band)), stage_key };
  }

  // Draw A by one method, if anything that it depends on has changed.
  function drawn(name, method, state, { stage, stage_key }) {
    const begin = performance.now(), key = [stage_key, state.field, state.ku, state.kv, method, state.beta, state.model];
    keep(name, key, () => module.draw_a(state, method, stage, name));
    return { fresh: kept[name].fresh, time: performance.now() - begin };
  }

  // The picture without A, for every view.
  function ground(state, { stage, stage_key }) {
    return keep("ground", [stage_key, state.model], () => {
      const pixels = new Uint32Array(stage.codes.length);
      module.draw_elsewhere(state, stage, "spare");
      views.background(module.planes(stage, "spare").rgb, pixels);
      return pixels;
    });
  }

  function paint_view(state, { stage }, base, target, pixels) {
    pixels.set(base);
    if (state.view === "slope") {
      const waves = module.wave_numbers(state) || [state.ku, state.kv];
      pixels.fill(views.OPAQUE);
      views.slope(target, stage.at, pixels, module.kernel("slope_bound", Math.max(...waves.map(Math.abs))));
    } else if (state.view === "straddle") {
      const [u, v] = module.chart(stage), flags = module.kernel(`straddling_${state.field}`, u, v, state.ku, state.kv, state.eps);
      for (let i = 0; i < pixels.length; i++) pixels[i] = views.OPAQUE | ((base[i] >>> 2) & 0x3f3f3f);
      views.straddle(target, flags, stage.at, pixels);
    } else views.image(target, stage.at, pixels);
  }

  function draw({ id, state, band, buffers }) {
    const on = staged(state, band), new_stage = kept.stage.fresh, base = ground(state, on);
    const numeric = drawn("numeric", difference(state), state, on), symbolic = drawn("symbolic", exact, state, on);
    const [one, other] = ["numeric", "symbolic"].map((name) => module.planes(on.stage, name));
    const begin = performance.now(), images = {}, look = [state.view, state.model, on.stage_key];
    const blank = () => new Uint32Array(buffers?.pop() ?? base.length);
    keep("view of symbolic", [look, kept.symbolic.key, state.view === "straddle" && state.eps], () => {
      images.symbolic = blank();
      paint_view(state, on, base, other, images.symbolic);
    });
    keep("view of numeric", [look, kept.numeric.key], () => {
      images.numeric = blank();
      paint_view(state, on, base, one, images.numeric);
    });
    images.difference = blank().fill(views.OPAQUE);
    const { max, sum } = views.difference(one, other, on.stage.at, images.difference, state.scale);
    const times = { paint: performance.now() - begin };
    if (numeric.fresh) times.numeric = numeric.time;
    if (symbolic.fresh) times.symbolic = symbolic.time;
    const reply = { kind: "drawn", id, band, images, max, sum, count: on.stage.count, times };
    if (new_stage) reply.codes = on.stage.codes.slice();
    const moved = [...Object.values(images).map((pixels) => pixels.buffer), ...(reply.codes ? [reply.codes.buffer] : [])];
    port.postMessage(reply, moved);
  }

  // Both pipelines drawn again from nothing, a few times.
  function time_both(state, on) {
    const times = { numeric: [], symbolic: [] };
    for (let round = 0; round < 3; round++) {
      for (const [name, method] of [["numeric", difference(state)], ["symbolic", exact]]) {
        const begin = performance.now();
        module.draw_a(state, method, on.stage, "spare");
        times[name].push(performance.now() - begin);
      }
    }
    return times;
  }

  // Flips: pixels whose chamber, computed afresh for either side, is not the one that was drawn with. Attached: pixels
  // of A that the bump turns to the other side of a light.
  function count_flips(state, { stage }) {
    let flips = 0;
    for (const side of [state, { ...state, beta: 0 }]) {
      const codes = module.chambers_of(side, stage, stage.code_again);
      for (let i = 0; i < codes.length; i++) if (codes[i] !== stage.codes[i]) flips++;
    }
    return { flips, attached: module.turned(state, stage, "symbolic") };
  }

  // One piece of idle work a turn, so that a new state never waits longer than that.
  function* idle({ id, state, band, steps }) {
    const on = staged(state, band);
    drawn("symbolic", exact, state, on);
    yield { kind: "counted", id, ...count_flips(state, on), count: on.stage.count };
    for (const [index, eps] of (steps || []).entries()) {
      module.draw_a(state, { name: state.method, eps }, on.stage, "spare");
      const [one, other] = ["spare", "symbolic"].map((name) => module.planes(on.stage, name));
      yield { kind: "followed", id, index, ...views.apart(one, other, on.stage.at), count: on.stage.count };
    }
    yield { kind: "timed", id, times: time_both(state, on) };
  }

  const channel = new MessageChannel();
  channel.port1.onmessage = () => {
    const next = pending?.next();
    if (!next || next.done) return;
    port.postMessage(next.value);
    channel.port2.postMessage(0);
  };

  let ready; // messages are taken in their order once the module is there

  async function begin({ data, compiled }) {
    module = await Simulator.module(data, compiled);
    views = Simulator.views(data, module);
  }

  async function receive(data) {
    await ready;
    pending = null;
    if (data.kind === "draw") draw(data);
    if (data.kind === "idle") {
      pending = idle(data);
      channel.port2.postMessage(0);
    }
  }

  port.onmessage = ({ data }) => {
    if (data.kind === "begin") ready = begin(data);
    else receive(data);
  };
};

// What a worker does: draw a band of rows for a state; when nothing is asked, time both pipelines, count flips, and
// follow the U-curve of the band. Only what a change touches is computed anew.
"use strict";
var Simulator = Simulator || {};

Simulator.worker = function (port) {
  const kernels = Simulator.kernels(), pipeline = Simulator.pipeline(kernels), views = Simulator.views(kernels);
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
    const scene = pipeline.scene_of(state);
    const stage_key = [band, state.ball, state.lights];
    const stage = keep("stage", stage_key, () => pipeline.make_stage(scene, band));
    return { scene, stage, stage_key };
  }

  // Draw A by one method into the pipeline's own arrays, if anything that it depends on has changed.
  function drawn(name, method, state, { scene, stage, stage_key }) {
    const gradient_key = [stage_key, state.field, state.ku, state.kv, method, state.beta === 0];
    const target = keep(`${name} arrays`, stage_key, () => pipeline.empty_target(stage.count));
    const begin = performance.now();
    keep(`${name} colours`, [gradient_key, state.beta, state.model], () => {
      keep(`${name} gradient`, gradient_key, () => pipeline.slopes(scene, method, stage, target));
      pipeline.shade_a(scene, stage, target);
    });
    return { target, fresh: kept[`${name} colours`].fresh, time: performance.now() - begin };
  }

  // The picture without A, for every view.
  function ground(state, { scene, stage, stage_key }) {
    return keep("ground", [stage_key, state.model], () => {
      const pixels = new Uint32Array(stage.codes.length);
      views.background(pipeline.shade_elsewhere(scene, stage), pixels);
      return pixels;
    });
  }

  function paint_view(state, { scene, stage }, base, target, pixels) {
    pixels.set(base);
    const field = kernels.fields[state.field];
    if (state.view === "slope") {
      const waves = field.wave_numbers ? field.wave_numbers(state.ku, state.kv) : [state.ku, state.kv];
      pixels.fill(views.OPAQUE);
      views.slope(target, stage.at, pixels, kernels.slope_bound(Math.max(...waves.map(Math.abs))));
    } else if (state.view === "straddle") {
      const flags = new Float64Array(stage.count);
      field.straddling(stage.u, stage.v, scene.k_u, scene.k_v, state.eps, flags, 0, stage.count);
      for (let i = 0; i < pixels.length; i++) pixels[i] = views.OPAQUE | ((base[i] >>> 2) & 0x3f3f3f);
      views.straddle(target, flags, stage.at, pixels);
    } else views.image(target, stage.at, pixels);
  }

  function draw({ id, state, band, buffers }) {
    const on = staged(state, band), new_stage = kept.stage.fresh, base = ground(state, on);
    const numeric = drawn("numeric", difference(state), state, on), symbolic = drawn("symbolic", exact, state, on);
    const begin = performance.now(), images = {}, look = [state.view, state.model, on.stage_key];
    const blank = () => new Uint32Array(buffers?.pop() ?? base.length);
    keep("view of symbolic", [look, kept["symbolic colours"].key, state.view === "straddle" && state.eps], () => {
      images.symbolic = blank();
      paint_view(state, on, base, symbolic.target, images.symbolic);
    });
    keep("view of numeric", [look, kept["numeric colours"].key], () => {
      images.numeric = blank();
      paint_view(state, on, base, numeric.target, images.numeric);
    });
    images.difference = blank().fill(views.OPAQUE);
    const { max, sum } = views.difference(numeric.target, symbolic.target, on.stage.at, images.difference, state.scale);
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
    const target = pipeline.empty_target(on.stage.count), times = { numeric: [], symbolic: [] };
    for (let round = 0; round < 3; round++) {
      for (const [name, method] of [["numeric", difference(state)], ["symbolic", exact]]) {
        const begin = performance.now();
        pipeline.draw_a(on.scene, method, on.stage, target);
        times[name].push(performance.now() - begin);
      }
    }
    return times;
  }

  // Flips: pixels whose chamber, computed afresh for either side, is not the one that was drawn with. Attached: pixels
  // of A that the bump turns to the other side of a light.
  function count_flips(state, { scene, stage }) {
    const flat = pipeline.scene_of({ ...state, beta: 0 });
    let flips = 0;
    for (const side of [scene, flat]) {
      const codes = pipeline.chambers_of(side, stage.raster);
      for (let i = 0; i < codes.length; i++) if (codes[i] !== stage.codes[i]) flips++;
    }
    const target = kept["symbolic arrays"].value;
    const attached = pipeline.lights_of(scene).map((light) => {
      const bumped = pipeline.towards_light(scene, stage, target, light, scene.beta);
      const plain = pipeline.towards_light(scene, stage, target, light, 0);
      let turned = 0;
      for (let i = 0; i < stage.count; i++) if (bumped[i] !== plain[i]) turned++;
      return { number: light.number, turned };
    });
    return { flips, attached };
  }

  // One piece of idle work a turn, so that a new state never waits longer than that.
  function* idle({ id, state, band, steps }) {
    const on = staged(state, band);
    drawn("symbolic", exact, state, on);
    yield { kind: "counted", id, ...count_flips(state, on), count: on.stage.count };
    if (steps) {
      const target = pipeline.empty_target(on.stage.count);
      for (const [index, eps] of steps.entries()) {
        pipeline.draw_a(on.scene, { name: state.method, eps }, on.stage, target);
        yield { kind: "followed", id, index, ...views.apart(target, kept["symbolic arrays"].value), count: on.stage.count };
      }
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

  port.onmessage = ({ data }) => {
    pending = null;
    if (data.kind === "draw") draw(data);
    if (data.kind === "idle") {
      pending = idle(data);
      channel.port2.postMessage(0);
    }
  };
};

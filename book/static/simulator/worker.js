// What a worker does, or the page itself: draw and paint a band of rows for a state, tile by tile; when nothing is asked, count
// flips, and follow the U-curve of the band. Only what a change touches is computed anew.
"use strict";

/**
 * Return what takes a task; its replies are posted.
 * @param {(reply: Reply, transfer: ArrayBufferLike[]) => void} post
 * @returns {(task: Task) => void}
 */
function simulator_worker(post) {
  const SIDE = 32; // of a still
  const MOST = 0.995; // of the pixels lie within the scale of slopes
  const TILE = 2 ** 17; // pixels: some 4 ms of a desktop; the page draws fewer, and at once
  /** @type {Record<string, { key: string, value: any, version: number, fresh: boolean }>} */
  const kept = {};
  let apart = { largest: 0, squares: 0 };
  let versions = 0;
  let timer = 0;
  /** @type {SimulatorModule} */
  let module;
  /** @type {Generator<Reply | void> | null} */
  let pending = null; // the work that is left
  let ready = Promise.resolve(); // tasks are taken in their order once the module is there

  /**
   * What was made for this key, or what is made now.
   * @param {string} name
   * @param {Key} key
   * @param {() => any} make
   */
  function keep(name, key, make = () => null) {
    const joined = key.join();
    const fresh = kept[name]?.key !== joined;
    if (fresh) kept[name] = { key: joined, value: make(), version: ++versions, fresh };
    kept[name].fresh = fresh;
    return kept[name];
  }

  /**
   * The chambers and the chart, and what is around A: what no bump changes.
   * @param {State} state
   * @param {Raster} raster
   * @returns {Stage}
   */
  function staged(state, raster) {
    const key = [state.ball, ...state.lights, ...state.lamp, ...Object.values(raster)];
    const stage = keep("stage", key, () => module.make_stage(state, raster));
    keep("around", [stage.version, state.model], () => {
      for (const name of ["numeric", "symbolic", "spare"]) module.draw_elsewhere(state, stage.value, name);
    });
    return stage.value;
  }

  /**
   * Draw A for one picture, if anything that it depends on has changed: a tile a turn.
   * @param {string} name
   * @param {State} state
   * @param {Stage} stage
   */
  function* draw_anew(name, state, stage) {
    const method = module.methods_of(state)[name];
    const key = [kept.around.version, state.field, state.h, state.ku, state.kv, state.beta, ...Object.values(method)];
    if (kept[name]?.key === key.join()) return;
    delete kept[name]; // half drawn, it is neither
    const { wide, high } = stage.raster;
    const step = Math.ceil(TILE / wide);
    for (let first_row = 0; first_row < high; first_row += step) {
      if (first_row) yield;
      module.draw_a(state, method, stage, name, { first_row, last_row: Math.min(high, first_row + step) });
    }
    keep(name, key);
  }

  /**
   * What a view shows of A's pixels, one after another: null for the image itself.
   * @param {string} name
   * @param {State} state
   * @param {Stage} stage
   */
  function shown(name, state, stage) {
    const { view, field, ku, kv, eps } = state;
    if (view === "loci" && field === "own") return module.own_creases(state, stage);
    if (["image", "loci", "bounds", "by_ku"].includes(view)) return null;
    const [u, v] = module.chart(stage);
    if (view === "straddle") return module.straddles(state, module.methods_of(state).numeric, u, v);
    if (view === "kink") return module.kinks(state, module.angles_of(stage)[3], u, v);
    const method = module.methods_of(state)[name];
    if (view === "slope") return module.kernel_over("slope", ...module.gradients(state, stage, method))[0];
    const bounds = name === "numeric" && module.bounds_of(state);
    return bounds ? module.kernel_over(bounds, u, v, ku, kv, eps)[1] : null;
  }

  /** How far the colour that moves fastest goes, red, green or blue. @param {Float64Array[]} slopes */
  function steepest([red, green, blue]) {
    /** @param {number} a @param {number} b */
    const further = (a, b) => (Math.abs(b) > Math.abs(a) ? b : a);
    return red.map((slope, i) => further(further(slope, green[i]), blue[i]));
  }

  /**
   * The slopes of the picture that a view has, or null.
   * @param {string} name @param {State} state @param {Stage} stage
   * @returns {Float64Array | null}
   */
  function slopes_of(name, state, stage) {
    if (!state.view.startsWith("by_")) return null;
    const key = [kept.around.version, kept[name].version, state.view];
    return keep(`slopes ${name}`, key, () => {
      const planes = module.picture_slopes(state, stage, module.methods_of(state)[name]);
      return planes && steepest(planes);
    }).value;
  }

  /** @param {string} name @param {State} state @param {Stage} stage @param {boolean} whole @param {number} end of the scale of slopes */
  function paint_view(name, state, stage, whole, end) {
    const slopes = slopes_of(name, state, stage);
    if (slopes) {
      const levels = slopes.map((slope) => Math.max(0, Math.min(Math.floor(128 + (128 * slope) / end), 255)));
      module.fill(stage, levels, true);
      module.paint("paint_levels", stage, name, { whole: true, palette: "slopes" });
      return;
    }
    const values = shown(name, state, stage);
    if (values) module.fill(stage, values);
    if (values && state.view === "terms") module.paint("paint_levels", stage, name, { whole, palette: "terms" });
    else if (values && state.view === "slope") {
      const waves = module.wave_numbers(state) ?? [state.ku, state.kv];
      const [steepest] =
        state.field === "own"
          ? values.toSorted().slice(-1)
          : module.kernel("slope_bound", Math.max(...waves.map(Math.abs)));
      module.paint("paint_levels", stage, name, { whole, gain: steepest > 0 ? 255 / steepest : 0 });
    } else {
      module.paint("paint_colors", stage, name, { whole });
      if (values) module.paint("paint_flags", stage, name, { whole });
    }
  }

  /** @param {Stage} stage @param {string} into @param {Painting} options */
  const paint_logarithmic = (stage, into, options) =>
    module.paint("paint_difference_logarithmic", stage, into, { ...options, table: "sizes", palette: "levels" });

  /**
   * What was painted of A in SIDE × SIDE cells, the largest level of each.
   * @param {State} state
   * @param {Stage} stage
   */
  function still_of({ size, top }, stage) {
    const { raster, pitch, at } = stage;
    const cells = new Uint8Array(SIDE * SIDE);
    const levels = module.bytes(stage, "spare", [0, raster.high]);
    for (const i of at) {
      const row = Math.floor(((Math.floor(i / pitch) + raster.top - top) * SIDE) / size);
      const cell = row * SIDE + Math.floor(((i % pitch) * SIDE) / size);
      cells[cell] = Math.max(cells[cell], levels[4 * i]);
    }
    return cells;
  }

  /** The difference is painted as its levels; the page gives them colours. @param {State} state @param {Stage} stage @param {boolean} whole */
  function paint_difference({ scale }, stage, whole) {
    const options = { whole, of: "numeric", other: "symbolic" };
    if (!Number(scale)) return paint_logarithmic(stage, "difference", options);
    return module.paint("paint_difference_linear", stage, "difference", { ...options, gain: Number(scale) });
  }

  /** @param {DrawTask} task */
  function* draw({ id, state, band, part, end: given }) {
    const stage = staged(state, band);
    for (const name of ["numeric", "symbolic"]) yield* draw_anew(name, state, stage);
    const codes = keep("codes", [kept.stage.version]).fresh ? stage.codes.slice() : null;
    const moved = codes ? [codes.buffer] : [];
    /** @type {Drawn["images"]} */
    const images = {};

    /**
     * Paint a picture if what it shows has changed: all of it if what is around A has, too.
     * @param {string} name
     * @param {Key} around
     * @param {Key} on_a
     * @param {(whole: boolean) => void} paint
     */
    function picture(name, around, on_a, paint) {
      const whole = keep(`around ${name}`, around).fresh;
      if (!keep(`${name} on A`, [...around, ...on_a], () => paint(whole)).fresh) return;
      /** @type {[number, number]} */
      const rows = whole ? [0, band.high] : stage.rows;
      const bytes = module.bytes(stage, name, rows).slice();
      images[name] = { top: rows[0], bytes };
      moved.push(bytes.buffer);
    }

    const sizes = slopes_of("symbolic", state, stage)?.map(Math.abs).sort();
    const end = given || (sizes ? sizes[Math.floor(MOST * sizes.length)] || sizes[sizes.length - 1] || 1 : 0);
    for (const name of ["numeric", "symbolic"]) {
      const by_step = ["straddle", "terms"].includes(state.view) && [state.eps, state.method].join();
      const around = [kept.around.version, state.view, ...(end ? [kept[name].version, end] : [])];
      picture(name, around, [kept[name].version, by_step], (whole) => paint_view(name, state, stage, whole, end));
    }
    const pair = [state.scale, kept.numeric.version, kept.symbolic.version];
    picture("difference", [kept.around.version], pair, (whole) => {
      apart = paint_difference(state, stage, whole);
    });
    post({ kind: "drawn", id, band, part, images, ...apart, count: stage.count, codes, end }, moved);
  }

  /**
   * Flips: pixels whose chamber, computed afresh for either side, is not the one that was drawn with. Attached: pixels
   * of A that the bump turns to the other side of a light.
   * @param {State} state
   * @param {Stage} stage
   */
  function count_flips(state, stage) {
    let flips = 0;
    for (const side of [state, { ...state, beta: 0 }]) {
      const codes = module.chambers_of(side, stage, stage.addresses.code_again);
      for (let i = 0; i < codes.length; i++) if (codes[i] !== stage.codes[i]) flips++;
    }
    return { flips, attached: module.turned(state, stage, "symbolic") };
  }

  /**
   * One piece of idle work a turn, so that a new state never waits longer than that.
   * @param {IdleTask} task
   * @returns {Generator<Reply | void>}
   */
  function* idle({ id, state, band, steps }) {
    const stage = staged(state, band);
    const { count } = stage;
    yield* draw_anew("symbolic", state, stage);
    yield { kind: "counted", id, index: 0, ...count_flips(state, stage), count };
    for (const [index, eps] of (steps ?? []).entries()) {
      module.draw_a(state, { name: state.method, eps }, stage, "spare");
      const sizes = paint_logarithmic(stage, "spare", { other: "symbolic" });
      yield { kind: "followed", id, index, ...sizes, count, still: still_of(state, stage) };
    }
  }

  function go_on() {
    const next = pending?.next();
    if (!next || next.done) return;
    if (next.value) post(next.value, []);
    timer = setTimeout(go_on);
  }

  /** @param {Task} task */
  async function take(task) {
    if (task.kind === "begin")
      ready = simulator_module(task.data, task.compiled).then((made) => {
        module = made;
      });
    await ready;
    pending = task.kind === "idle" ? idle(task) : task.kind === "draw" ? draw(task) : null;
    clearTimeout(timer);
    go_on();
  }
  return take;
}

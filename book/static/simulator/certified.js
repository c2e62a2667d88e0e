// What is certain of the colours: how far each one is off at most, by the renderer's machine that encloses, and how many
// digits that leaves of the difference. A worker computes it when the view is chosen and nothing moves.
"use strict";

/**
 * What the worker does: draw a state's picture by both pipelines with their bounds; post maps, ends and counts.
 * @param {(found: CertifiedFound) => void} post
 * @returns {(task: CertifiedTask) => Promise<void>}
 */
function simulator_certifier(post) {
  const OPEN = 255; // a level of its own
  return async ({ key, parts, state, raster }) => {
    const module = await simulator_module(...parts);
    const stage = module.make_stage(state, raster);
    const methods = Object.values(module.methods_of(state));
    const pictures = methods.map((method) => module.draw_bounded(state, method, stage));
    const [numeric, symbolic] = pictures;
    const is_open = numeric.open.map((flag, i) => flag | symbolic.open[i]);
    const is_a = stage.codes.map((code) => Number(module.is_on_a(code)));
    // An open pixel may be one of A or not: either end is that of the worse choice.
    const counted = [is_a.map((flag, i) => flag & ~is_open[i]), is_a.map((flag, i) => flag | is_open[i])];
    const [certain, possible] = counted.map((flags) => 3 * flags.filter(Boolean).length);
    const sums = [0, 0];
    const largest = [0, 0];
    for (const [c, color] of numeric.colors.entries()) {
      const apart = color.map((value, i) => Math.abs(value - symbolic.colors[c][i]));
      const within = numeric.bounds[c].map((bound, i) => bound + symbolic.bounds[c][i]);
      for (const [n, ends] of module.kernel_over("nearest_and_furthest", apart, within).entries()) {
        ends.forEach((end, i) => {
          sums[n] += counted[n][i] * end ** 2;
          largest[n] = Math.max(largest[n], counted[n][i] * end);
        });
      }
    }
    const slack = possible * 2 ** -50; // more than what rounding takes from the sums
    const rms = [(1 - slack) * (sums[0] / possible) ** 0.5, (1 + slack) * (sums[1] / certain) ** 0.5];
    const bounds = pictures.map(({ bounds: [red, green, blue] }) =>
      red.map((bound, i) => Math.max(bound, green[i], blue[i]))
    );
    const maps = bounds.map((plane) => {
      const levels = plane.map((bound) => Math.max(0, Math.min(Math.floor(256 + 16 * Math.log10(bound)), OPEN - 1)));
      return new Uint8Array(levels.map((level, i) => (is_open[i] ? OPEN : level)));
    });
    const sorted = bounds.map((plane) => plane.filter((_, i) => is_a[i]).sort());
    const extremes = sorted.map((plane) => [plane[plane.length - 1], plane[plane.length >> 1]]);
    const open = is_open.filter(Boolean).length;
    post({ key, maps, rms, largest, extremes, open });
  };
}

/**
 * @param {HTMLElement} root
 * @param {States} states
 * @param {CloserParts} parts
 * @param {(maps: Uint8Array[]) => void} show_bounds
 */
function simulator_certified(root, states, parts, show_bounds) {
  const box = find_element(root, "#certified");
  const values = box.querySelectorAll("tbody td");
  const REST = 300; // milliseconds
  /** @type {Worker | undefined} */
  let worker;
  let asked = "";
  let timer = 0;

  /** The number that both ends are to as many digits as they agree on; else what it is at most. @param {number[]} ends */
  function digits_of([low, high]) {
    for (let count = 15; count > 0; count--) {
      const [text, other] = [low, high].map((end) => scientific(end, count - 1));
      if (text === other) return text;
    }
    return `at most ${scientific(1.06 * high, 1)}`;
  }

  /** @param {string[]} texts */
  function say(texts) {
    for (const [n, value] of values.entries()) value.textContent = texts[n] ?? "…";
  }

  /** @param {CertifiedFound} found */
  function show({ key, maps, rms, largest, extremes, open }) {
    if (key !== asked) return;
    show_bounds(maps);
    say([...extremes.flat().map((bound) => scientific(bound, 1)), String(open), ""]);
    find_element(root, "[data-readout=rms]").textContent = digits_of(rms);
    find_element(root, "[data-readout=max]").textContent = digits_of(largest);
  }

  /** Ask for a state's bounds, if they are viewed and not asked for yet; those of another state are gone. @param {State} state */
  function ask(state) {
    const key =
      state.view === "bounds" && state.field !== "own" && state.against !== "surface"
        ? states.fragment({ ...state, column: 0, row: 0, axis: "u" })
        : "";
    if (key === asked) return;
    asked = key;
    show_bounds([]);
    say([]);
    clearTimeout(timer);
    if (!key) return;
    timer = setTimeout(() => {
      worker ??= worker_of(float64s, simulator_module, simulator_certifier);
      listen(worker, show, (why) => {
        worker = undefined;
        say([why]);
      });
      worker.postMessage({ key, parts, state, raster: states.crop(state) });
    }, REST);
  }
  return { ask };
}

// What is certain of the colours: how far each one is off at most, by the renderer's machine that encloses, and how many
// digits that leaves of the difference. A worker computes it when the view is chosen and nothing moves.
"use strict";

/**
 * What the worker does: draw a state's picture by both pipelines with their bounds; post maps, ends and counts.
 * @param {(found: CertifiedFound) => void} post
 * @returns {(task: CertifiedTask) => Promise<void>}
 */
function simulator_certifier(post) {
  const A = 1;
  const SURFACE = 3;
  const OPEN = 0xff739e00; // the palette's green, which the map has nowhere
  const ROOM = 2 ** -50; // more than what rounding takes from the lines below
  const TINY = 1e-100; // its square does not vanish
  return async ({ key, parts, state, raster }) => {
    const module = await simulator_module(...parts);
    const { inferno } = parts[0].tables;
    const stage = module.make_stage(state, raster);
    const methods = [{ name: state.method, eps: state.eps }, { name: "exact" }];
    const pictures = methods.map((method) => module.draw_bounded(state, method, stage));
    const [numeric, symbolic] = pictures;
    const is_open = numeric.open.map((flag, i) => flag | symbolic.open[i]);
    const is_a = stage.codes.map((code) => Number((code & SURFACE) === A));
    const open = is_open.reduce((sum, flag) => sum + flag, 0);
    const certain = is_a.reduce((sum, flag, i) => sum + (flag & ~is_open[i]), 0);
    const sums = [0, 0];
    const largest = [0, 0];
    numeric.colors.forEach((plane, c) => {
      plane.forEach((color, i) => {
        if (!is_a[i] && !is_open[i]) return;
        const apart = Math.abs(color - symbolic.colors[c][i]);
        const within = numeric.bounds[c][i] + symbolic.bounds[c][i];
        const nearest = is_open[i] ? 0 : apart * (1 - ROOM) - within * (1 + ROOM);
        take(0, nearest < TINY ? 0 : nearest);
        take(1, Math.max((apart + within) * (1 + ROOM), TINY));
      });
    });
    /** @param {number} n @param {number} end */
    function take(n, end) {
      sums[n] += end * end;
      largest[n] = Math.max(largest[n], end);
    }
    // An open pixel may be one of A or not: either end is that of the worse choice.
    const slack = 4 * (certain + open + 2) * ROOM;
    const rms = [(1 - slack) * (sums[0] / 3 / (certain + open)) ** 0.5, (1 + slack) * (sums[1] / 3 / certain) ** 0.5];
    const bounds = pictures.map(({ bounds: [red, green, blue] }) =>
      red.map((bound, i) => Math.max(bound, green[i], blue[i]))
    );
    /** @param {number} bound @param {number} i */
    function shade(bound, i) {
      const level = Math.floor(256 * (Math.log10(bound) / 16 + 1));
      return is_open[i] ? OPEN : inferno[Math.max(0, Math.min(level, 255))];
    }
    const maps = bounds.map((plane) => new Uint32Array(plane.map(shade)));
    const sorted = bounds.map((plane) => plane.filter((_, i) => is_a[i]).sort());
    const extremes = sorted.map((plane) => [plane[plane.length - 1], plane[plane.length >> 1]]);
    post({ key, maps, rms, largest, extremes, open });
  };
}

/**
 * @param {HTMLElement} root
 * @param {States} states
 * @param {() => Promise<CloserParts>} closer
 */
function simulator_certified(root, states, closer) {
  const box = find_element(root, "#certified");
  const canvases = box.querySelectorAll("canvas");
  const facts = find_element(box, ".sim-certain");
  const REST = 300; // milliseconds
  /** @type {Worker | undefined} */
  let worker;
  let asked = "";
  let timer = 0;

  /** The number that both ends are to as many digits as they agree on; else what it is at most. @param {number[]} ends */
  function digits_of([low, high], most = 15) {
    for (let count = most; count > 0; count--) {
      const [text, other] = [low, high].map((end) => scientific(end, count - 1));
      if (text === other) return text;
    }
    return `at most ${scientific(1.06 * high, 1)}`;
  }

  /** @param {MessageEvent<CertifiedFound>} message */
  function show({ data: { key, maps, rms, largest, extremes, open } }) {
    if (key !== asked) return;
    for (const [n, canvas] of canvases.entries()) {
      const image = new ImageData(new Uint8ClampedArray(maps[n].buffer), maps[n].length ** 0.5);
      canvas.width = canvas.height = image.width;
      canvas.getContext("2d")?.putImageData(image, 0, 0);
    }
    /** @param {number[]} pair */
    const bound = (pair) => pair.map((end) => scientific(end, 1)).join(", ");
    const found = {
      "RMS |ΔI| on A": digits_of(rms),
      "max |ΔI| on A": digits_of(largest),
      "numeric: largest bound, median": bound(extremes[0]),
      "symbolic: largest bound, median": bound(extremes[1]),
      "pixels left open": open
    };
    facts.innerHTML = Object.entries(found)
      .map(([name, value]) => entry_markup(name, value))
      .join("");
    find_element(root, "[data-readout=rms]").textContent = digits_of(rms, 3);
    find_element(root, "[data-readout=max]").textContent = digits_of(largest, 3);
  }

  /** Ask for a state's bounds, if they are viewed and not asked for yet. @param {State} state */
  function ask(state) {
    const key = states.fragment({ ...state, column: 0, row: 0, axis: "u" });
    box.hidden = state.view !== "bounds";
    if (box.hidden || key === asked) return;
    asked = key;
    facts.textContent = "…";
    clearTimeout(timer);
    timer = setTimeout(async () => {
      const parts = await closer();
      worker ??= worker_of(float64s, simulator_module, simulator_certifier);
      worker.onmessage = show;
      worker.postMessage({ key, parts, state, raster: states.crop(state) });
    }, REST);
  }
  return { ask };
}

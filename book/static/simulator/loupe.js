// The loupe: the pixels around the cursor with their values; below them, bit by bit, how the difference comes to its slope.
"use strict";

/**
 * What a module of both programs is made of. The second one is fetched when it is first asked for; the one file has it.
 * @param {SimulatorData} data
 * @param {WebAssembly.Module} compiled
 * @returns {Promise<[SimulatorData, ...WebAssembly.Module[]]>}
 */
async function closer_parts(data, compiled) {
  if (!Simulator.closer) {
    const { src } = /** @type {HTMLScriptElement} */ (find_element(document, "script[data-later]"));
    await new Promise((done, failed) => {
      const script = make_element("script", { src });
      script.onload = done;
      script.onerror = () => failed(new Error(`${src} is not there`));
      document.head.append(script);
    });
  }
  const { program, kernels, ...more } = Simulator.closer;
  const all = { ...data, ...more, kernels: { ...data.kernels, ...kernels } };
  return [all, compiled, await compiled_program(program)];
}

/** The bits of float64 numbers by their places: the bit of place p counts 2^p. */
const Bits = {
  LOWEST: -1074,
  /** A number's size as a multiple of the smallest float64. @param {number} number */
  units(number) {
    const [bits] = new BigUint64Array(Float64Array.of(Math.abs(number)).buffer);
    const [exponent, fraction] = [bits >> 52n, bits & (2n ** 52n - 1n)];
    return exponent ? (fraction | (2n ** 52n)) << (exponent - 1n) : fraction;
  },
  /** The place of the first 1. @param {bigint} units */
  first: (units) => Bits.LOWEST + units.toString(2).length - 1,
  /** The place of the last 1. @param {bigint} units */
  end: (units) => Bits.LOWEST + units.toString(2).length - 1 - units.toString(2).lastIndexOf("1"),
  /** The last place of a float64. @param {number} number */
  last: (number) => Math.max(Bits.first(Bits.units(number)) - 52, Bits.LOWEST),
  /** The bits of so many places down to a last one, as text. @param {bigint} units @param {number} count @param {number} last */
  text: (units, count, last) =>
    BigInt.asUintN(count, units >> BigInt(last - Bits.LOWEST)).toString(2).padStart(count, "0")
};

/**
 * @param {HTMLElement} root
 * @param {States} states
 * @param {SimulatorModule} module with both programs
 * @param {SimulatorData} data of both
 * @param {Act} act
 */
function simulator_loupe(root, states, module, data, act) {
  const NAMES = ["numeric", "symbolic", "difference"];
  const SIDE = 16;
  const MOST = 128; // places of the ruler
  const EXACT = { name: "exact" };
  const box = find_element(root, "#loupe");
  const lenses = NAMES.map((name) => find_element(box, `[data-lens=${name}]`));
  const facts = find_element(box, ".sim-slopes");
  const ruler = find_element(box, ".sim-bits");
  /** @type {State} */
  let shown;
  let [left, top] = [0, 0];
  /** @type {Float64Array[][]} */
  let colors = [];

  /** Draw the pixels around the cursor by both pipelines, and their difference. @param {State} state */
  function draw_lenses(state) {
    const corner = [state.column, state.row].map((at) => clamp(0, at - SIDE / 2, states.side(state) - SIDE));
    [left, top] = corner;
    const stage = module.make_stage(state, { ...states.crop(state), left, top, wide: SIDE, high: SIDE });
    colors = [{ name: state.method, eps: state.eps }, EXACT].map((method, n) => {
      module.draw_elsewhere(state, stage, NAMES[n]);
      module.draw_a(state, method, stage, NAMES[n]);
      module.paint("paint_colors", stage, NAMES[n], { whole: true });
      return module.colors_of(stage, NAMES[n]);
    });
    const pair = { whole: true, of: NAMES[0], other: NAMES[1], table: "sizes", palette: "inferno" };
    module.paint("paint_difference_logarithmic", stage, NAMES[2], pair);
    for (const [n, name] of NAMES.entries()) {
      /** @type {HTMLCanvasElement} */
      const canvas = find_element(lenses[n], "canvas");
      const bytes = new Uint8ClampedArray(module.bytes(stage, name, [0, SIDE]));
      canvas.getContext("2d")?.putImageData(new ImageData(bytes, SIDE), 0, 0);
    }
  }

  /** Say what a pixel's values are, and mark it. @param {number} column @param {number} row @param {string} mark */
  function tell(column, row, mark) {
    box.style.setProperty(`--${mark}-left`, `${(100 * (column - left)) / SIDE}%`);
    box.style.setProperty(`--${mark}-top`, `${(100 * (row - top)) / SIDE}%`);
    const [numeric, symbolic] = colors.map((planes) => planes.map((plane) => plane[(row - top) * SIDE + column - left]));
    const values = [numeric, symbolic].map((rgb) => rgb.map((value) => value.toFixed(10)));
    values.push(numeric.map((value, n) => scientific(Math.abs(value - symbolic[n]), 2)));
    for (const [n, lens] of lenses.entries()) find_element(lens, "output").innerText = values[n].join("\n");
    find_element(box, "[data-told]").textContent = `${column}, ${row}`;
  }

  /** The pixel under the pointer. @param {PointerEvent | MouseEvent} event @param {Element} lens @returns {[number, number]} */
  function pointed(event, lens) {
    const { x, y, width, height } = pointer_in(lens, event);
    const [right, down] = [x / width, y / height].map((share) => clamp(0, Math.floor(share * SIDE), SIDE - 1));
    return [left + right, top + down];
  }

  /**
   * Where a difference takes the height along an axis, from the largest to the smallest, as the kernel did.
   * @param {State} state
   * @param {number[]} here u and v
   * @param {number[]} found what the kernel noted
   */
  function samples_of({ axis, method, field, eps }, here, found) {
    const n = Number(axis === "v");
    const taken = data.taken[`samples_${method}_${field}`].map((name, i) => {
      const back = name.includes("minus") || (method === "forward" && n && here[1] + eps > 1);
      const step = name === "h_here" ? 0 : (back ? -1 : 1) * (name.endsWith("2") ? 2 : 1);
      return { name, step, at: found[3 * i + n], h: found[3 * i + 2] };
    });
    const along = taken.filter(({ name }) => name.startsWith(`h_${axis}_`));
    const all = along.length % 2 ? [...along, ...taken.filter(({ step }) => !step)] : along;
    return all.sort((one, other) => other.step - one.step);
  }

  /** @typedef {[look: string, last: number, units?: bigint]} Run of bits, down to a place, of the number or another */

  /**
   * The rows of the ruler: what a number is called, itself, its runs of bits, and what is said of it.
   * @param {State} state
   * @param {number[]} here
   * @param {number[]} found
   */
  function rows_of(state, here, found) {
    const { axis, eps } = state;
    const at = here[Number(axis === "v")];
    const samples = samples_of(state, here, found);
    /** @type {{ name: string, number: number, runs: Run[], note: string }[]} */
    const rows = [];
    /** @param {string} name @param {number} number @param {Run[]} runs */
    function add(name, number, runs, note = "") {
      const first = Bits.first(Bits.units(number));
      rows.push({ name, number, runs: [["blank", first + 1], ...runs], note });
    }
    /** @param {number} number @returns {Run} */
    const kept = (number, last = Bits.last(number)) => ["kept", last];
    const called = (/** @type {number} */ step) =>
      step ? `${axis} ${step > 0 ? "+" : "−"} ${Math.abs(step) > 1 ? "2" : ""}ε` : axis;

    add(axis, at, [kept(at)]);
    add("ε", eps, [kept(eps)]);
    for (const sample of samples.filter(({ step }) => step)) add(called(sample.step), sample.at, ...stepped(sample));
    for (let n = 0; n < samples.length / 2; n++) {
      const pair = [samples[n], samples[samples.length - 1 - n]];
      const [one, other] = pair.map(({ h }) => h);
      const apart = one * other < 0 ? Infinity : Bits.first(Bits.units(one) ^ Bits.units(other));
      for (const { step, h } of pair) add(`h(${called(step)})`, h, [["same", apart + 1], kept(h)]);
      add("difference", one - other, ...subtracted(one, other));
    }
    return rows;

    /** A stepped argument: the exact sum's bits that it has no place for are lost. @param {typeof samples[number]} sample @returns {[Run[], string]} */
    function stepped({ step, at: stored }) {
      const rounded = at + step * eps;
      const turn = 1n << BigInt(-Bits.LOWEST);
      if (axis === "v" && stored !== rounded) return [[kept(stored)], `clamped to ${stored}`];
      const sum = Bits.units(at) + BigInt(step) * Bits.units(eps);
      const round = BigInt(Math.round(rounded - stored));
      const exact = sum - round * turn;
      const away = Bits.units(stored) - exact;
      const words = away ? `rounded ${away > 0 ? "up" : "down"}` : "exact";
      const note = `${stored === at ? `back to ${axis}` : words}${round ? ", around the seam" : ""}`;
      return [[kept(stored, Math.max(Bits.last(rounded), Bits.last(stored))), ["lost", Bits.end(exact), exact]], note];
    }

    /** What two heights leave of each other, and how much of it rounding may have made. @param {number} one @param {number} other @returns {[Run[], string]} */
    function subtracted(one, other) {
      const left = one - other;
      if (!left) return [[], "nothing is left"];
      const noise = `noise_${state.field}`;
      const known = state.method === "central" && noise in data.kernels;
      const size = known ? module.kernel(noise, here[0], here[1], state.ku, state.kv, eps)[Number(axis === "v")] : 0;
      const ends = Math.max(Bits.last(left), Math.min(Bits.last(one), Bits.last(other)));
      const below = known ? Math.floor(Math.log2(size)) : -Infinity;
      const bits = Bits.first(Bits.units(left)) - ends + 1;
      const noisy = clamp(0, below - ends + 1, bits);
      const note = `${bits} of 53 bits are left${known ? `, ${noisy} of them noise` : ""}`;
      return [[kept(left, Math.max(ends, below + 1)), ["noise", ends], ["filled", Bits.last(left)]], note];
    }
  }

  /** @param {ReturnType<typeof rows_of>} rows */
  function ruler_markup(rows) {
    const units = rows.map(({ number }) => Bits.units(number)).filter(Boolean);
    const start = Math.max(0, ...units.map(Bits.first));
    const ends = rows.flatMap(({ number, runs }) => (number ? runs.map(([, last]) => last) : []));
    const stop = Math.max(start - MOST, Math.min(...ends));
    const lines = rows.map(({ name, number, runs, note }) => {
      let from = start;
      const own = Bits.units(number);
      const spans = runs.map(([look, last, of = own]) => {
        const end = Math.max(last, stop);
        const count = from - end + 1;
        if (count <= 0) return "";
        from = end - 1;
        const tag = look === "lost" ? "s" : "span";
        return `<${tag} class="${look}">${Bits.text(of, count, end)}</${tag}>`;
      });
      const exponent = number ? `${number < 0 ? "−" : "+"}2${raised(Bits.first(own))}` : "0";
      return `<tr><th scope="row">${name}</th><td>${exponent}</td><td>${spans.join("")}</td><td>${note}</td></tr>`;
    });
    let ticks = "";
    for (let place = start; place >= stop; place--)
      if (place % 8 === 0) ticks += `|${raised(place)}`.padEnd(8);
    const lead = " ".repeat(((start % 8) + 8) % 8);
    return `<thead><tr><td></td><td></td><td>${lead}${ticks}</td><td></td></tr></thead><tbody>${lines.join("")}</tbody>`;
  }

  /** The slope along the axis, its error, and the bound. @param {State} state @param {number[]} here @param {number} numeric @param {number} exact */
  function slopes(state, here, numeric, exact) {
    const { axis, ku, kv, eps } = state;
    const bounds = module.bounds_of(state);
    const bound = bounds && module.kernel(bounds, here[0], here[1], ku, kv, eps)[axis === "v" ? 3 : 2];
    /** @type {Record<string, string | number>} */
    const found = {
      [`h<sub>${axis}</sub> by the difference`]: numeric,
      [`h<sub>${axis}</sub> exact`]: exact,
      error: scientific(Math.abs(numeric - exact), 2),
      "proved bound": bound === null ? "no theorem covers this" : scientific(bound, 2)
    };
    return Object.entries(found).map(([name, value]) => entry_markup(name, value));
  }

  /** @param {State} state */
  function show(state) {
    shown = state;
    draw_lenses(state);
    for (const mark of ["cursor", "probe"]) tell(state.column, state.row, mark);
    const { column, row, field, method, ku, kv, eps, axis } = state;
    const stage = module.make_stage(state, { ...states.crop(state), left: column, top: row, wide: 1, high: 1 });
    const here = module.chart(stage).map(([number]) => number);
    const samples = `samples_${method}_${field}`;
    const known = stage.count > 0 && samples in data.kernels;
    ruler.hidden = facts.hidden = !known;
    if (!known) return;
    const n = Number(axis === "v");
    const exact = module.gradients(state, EXACT, stage)[n][0];
    const found = module.kernel(samples, here[0], here[1], ku, kv, eps);
    facts.innerHTML = slopes(state, here, found[found.length - 2 + n], exact).join("");
    ruler.innerHTML = ruler_markup(rows_of(state, here, found));
  }

  for (const lens of lenses) {
    const frame = find_element(lens, ".sim-lens");
    frame.addEventListener("pointermove", (event) => tell(...pointed(event, frame), "probe"));
    frame.addEventListener("pointerleave", () => tell(shown.column, shown.row, "probe"));
    frame.addEventListener("click", (event) => {
      const [column, row] = pointed(event, frame);
      act.put({ column, row });
    });
    frame.addEventListener("keydown", (event) => {
      const arrow = arrow_of(event);
      if (!arrow) return;
      event.preventDefault();
      act.move([arrow[0], -arrow[1]]);
    });
  }
  return { show };
}

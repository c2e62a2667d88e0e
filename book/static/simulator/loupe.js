// The loupe: the pixels around the cursor with their values; below them, bit by bit, how the difference comes to its slope.
"use strict";

/**
 * @param {HTMLElement} root
 * @param {States} states
 * @param {CloserData} data
 * @param {SimulatorModule} module of both programs
 * @param {Act} act
 */
function simulator_loupe(root, states, data, module, act) {
  const SIDE = 16;
  const APART = SIDE + 1;
  const MIDDLE = [SIDE / 2, SIDE / 2];
  const FIRST = 7; // places of the ruler: the bit of place n counts 2^n
  const LAST = -120;
  const FINEST = 200; // of a number no more than 2^-200 is looked at
  const box = find_element(root, "#loupe");
  const frame = find_element(box, ".sim-lenses");
  /** @type {HTMLCanvasElement} */
  const canvas = find_element(frame, "canvas");
  const outputs = box.querySelectorAll("output");
  const body = find_element(box, "tbody");
  /** @type {Float64Array[][]} */
  let colors = [];
  /** @type {State} */
  let shown;
  let told = MIDDLE;

  /** @param {number} place */
  const corner = (place) => place - SIDE / 2;

  /** Draw the pixels around the cursor by both pipelines, and their difference. @param {State} state */
  function draw_lenses(state) {
    const raster = {
      ...states.crop(state),
      left: corner(state.column),
      top: corner(state.row),
      wide: SIDE,
      high: SIDE
    };
    const stage = module.make_stage(state, raster);
    colors = module.draw_pair(state, module.methods_of(state), stage);
    for (const [n, name] of PICTURES.entries()) module.put_into(canvas, stage, name, APART * n);
  }

  /** Mark a pixel of the lenses, and say what its values are. @param {number[]} place */
  function tell(place) {
    const [x, y] = place;
    told = place;
    frame.style.cssText = `--x: ${x}; --y: ${y}`;
    const values = colors.map((planes) => planes.map((plane) => plane[SIDE * y + x]));
    const [numeric, symbolic] = values;
    values.push(numeric.map((value, n) => Math.abs(value - symbolic[n])));
    for (const [n, output] of outputs.entries())
      output.innerText = values[n].map((value) => (n < 2 ? value.toFixed(10) : scientific(value, 2))).join("\n");
    const at = [corner(shown.column) + x, corner(shown.row) + y];
    find_element(box, "[data-told]").textContent = at.join(", ");
  }

  /** The pixel under the pointer. @param {MouseEvent} event */
  function pointed(event) {
    const { x, y, width, height } = pointer_in(frame, event);
    const across = Math.floor((x / width) * canvas.width) % APART;
    return [across, (y / height) * SIDE].map((at) => clamp(0, Math.floor(at), SIDE - 1));
  }

  /** A number's size as a whole number of the finest place. @param {number} number */
  const units = (number) => BigInt(Math.trunc(Math.abs(number) * 2 ** FINEST));
  /** The place of the first bit. @param {bigint} of */
  const first = (of) => of.toString(2).length - 1 - FINEST;
  /** The place of a float64's last bit. @param {number} number */
  const last = (number) => first(units(number)) - 52;

  /**
   * Add a row of the ruler: runs of bits down to a place, each of the number itself or of another one.
   * @param {string} name
   * @param {number} number
   * @param {Run[]} runs
   */
  function add(name, number, runs, note = "") {
    const own = units(number);
    let from = FIRST;
    /** @type {Run[]} */
    const all = number ? [["blank", first(own) + 1], ...runs, ["kept", last(number)]] : [];
    const spans = all.map(([look, end, of = own]) => {
      const to = Math.max(end, LAST);
      const count = Math.max(0, from - to + 1);
      from = Math.min(from, to - 1);
      const bits = BigInt.asUintN(count, of >> BigInt(to + FINEST)).toString(2);
      return count ? make_element("span", { class: look }, bits.padStart(count, "0")) : "";
    });
    const exponent = `${1 / number < 0 ? "−" : "+"}${number ? `2${raised(first(own))}` : 0}`;
    const cells = [[exponent], [...spans, make_element("small", {}, note)]].map((parts) =>
      make_element("td", {}, ...parts)
    );
    body.append(make_element("tr", {}, make_element("th", { scope: "row" }, name), ...cells));
  }

  /** Add two numbers, whose first bits are the same. @param {string[]} names @param {number[]} pair @param {string[]} notes */
  function add_pair(names, pair, notes = []) {
    const [one, other] = pair;
    const same = one * other > 0 ? first(units(one) ^ units(other)) + 1 : FIRST + 1;
    for (const [n, number] of pair.entries()) add(names[n], number, [["same", Math.max(same, last(number))]], notes[n]);
  }

  /** Add a stepped argument: what the exact sum has below the float's last place is lost. @param {State} state @param {number} at @param {number} step @param {string} name @param {number} stored */
  function add_stepped({ axis, eps }, at, step, name, stored) {
    const sum = at + step * eps;
    const turns = Math.round(sum - stored);
    if (axis === "v" && sum !== stored) return add(name, stored, [], `at the pole: taken at ${stored}`);
    const exact = units(at) + BigInt(step) * units(eps) - BigInt(turns) * units(1);
    const away = units(stored) - exact;
    const words = [away ? `rounded ${away > 0 ? "up" : "down"}` : "exact"];
    if (stored === at) words.push(`back to ${axis}`);
    if (turns) words.push("around the seam");
    const end = Math.max(last(sum), last(stored));
    add(
      name,
      stored,
      away
        ? [
            ["kept", end],
            ["lost", Math.min(last(at), last(eps), last(stored)), exact]
          ]
        : [],
      words.join(", ")
    );
  }

  /** Add a difference of heights: what rounding may have made of it is noise, NaN where that is not known. @param {number[]} heights @param {number} noise */
  function add_difference([one, other], noise) {
    const left = one - other;
    const end = Math.max(last(left), Math.min(last(one), last(other)));
    const below = noise ? Math.floor(Math.log2(noise)) + 1 : LAST;
    const bits = first(units(left)) - end + 1;
    const noisy = noise ? `, ${clamp(0, below - end, bits)} of them noise` : "";
    const note = left ? `${bits} of 53 bits are left${noisy}` : "nothing is left";
    add(
      "difference",
      left,
      [
        ["kept", Math.max(end, below)],
        ["noise", end],
        ["filled", last(left)]
      ],
      note
    );
  }

  /** Show a state's pixel: the ruler, if it is on A. @param {State} state */
  function show(state) {
    const { field, method, axis, ku, kv, eps } = state;
    shown = state;
    draw_lenses(state);
    tell(told);
    body.replaceChildren();
    const stage = module.stage_of_pixel(state, states.crop(state));
    if (!stage.count || field === "own") return; // whose steps have no kernel
    const n = axis === "v" ? 1 : 0;
    const [u, v] = module.chart(stage).map(([number]) => number);
    const at = [u, v][n];
    const samples = `samples_${method}_${field}`;
    const found = module.kernel(samples, u, v, ku, kv, eps);
    const [numeric, noise, bound] = [6, 4, 2].map((back) => found[found.length - back + n]);
    const pairs = data.pairs[samples][axis];
    add(axis, at, []);
    add("ε", eps, []);
    for (const { name, step, at: to } of pairs.flat()) if (step) add_stepped(state, at, step, name, found[to]);
    for (const pair of pairs) {
      const heights = pair.map(({ h }) => found[h]);
      add_pair(
        pair.map(({ name }) => `h(${name})`),
        heights
      );
      add_difference(heights, noise);
    }
    const exact = module.gradients(state, stage)[n][0];
    const proved = Number.isNaN(bound) ? "no theorem covers this" : `proved: at most ${scientific(bound, 2)}`;
    const off = `off by ${scientific(Math.abs(numeric - exact), 2)}; ${proved}`;
    add_pair([`h${"ᵤᵥ"[n]}`, "exact"], [numeric, exact], [off]);
  }

  frame.addEventListener("pointermove", (event) => tell(pointed(event)));
  frame.addEventListener("pointerleave", () => tell(MIDDLE));
  frame.addEventListener("click", (event) => {
    const [x, y] = pointed(event);
    act.move([x - SIDE / 2, y - SIDE / 2]);
  });
  follow_arrows(frame, (right, up) => act.move([right, -up]));
  return { show };
}

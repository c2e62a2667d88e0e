// What is known of the pixel under the cursor, by both pipelines, and how far apart they are.
"use strict";

/** @param {HTMLElement} root @param {States} states @param {SimulatorData} data @param {SimulatorModule} module */
function simulator_cursor(root, states, data, module) {
  const body = find_element(root, ".sim-pixel tbody");
  const facts = find_element(root, ".sim-facts");
  const MOST = 10000n; // floats: past that many, their count says less than the numbers themselves
  const AXES = ["x", "y", "z"];
  /** @type {{ key: "gradient" | "normal" | "rgb" | "slope", names: string[] }[]} */
  const COMPUTED = [
    { key: "gradient", names: ["h<sub>u</sub>", "h<sub>v</sub>"] },
    { key: "normal", names: AXES.map((axis) => `N′<sub>${axis}</sub>`) },
    { key: "rgb", names: ["red", "green", "blue"] },
    { key: "slope", names: ["∂ red", "∂ green", "∂ blue"] }
  ];

  /** Where a float stands among all floats, counted from 0. @param {number} number */
  function place(number) {
    const [bits] = new BigInt64Array(Float64Array.of(number).buffer);
    return bits < 0n ? -(bits & 0x7fffffffffffffffn) : bits;
  }

  /** How far apart two numbers are, and by how many floats, if these are few. @param {number} a @param {number} b */
  function distance(a, b) {
    const steps = place(a) - place(b);
    const count = steps < 0n ? -steps : steps;
    return `${scientific(Math.abs(a - b), 1)}${count <= MOST ? ` · ${count} ulp` : ""}`;
  }

  /** A number, the digits in which it agrees with another marked. @param {number} a @param {number} b */
  function marked(a, b) {
    const [text, other] = [a, b].map((number) => (Object.is(number, -0) ? "-0" : String(number)));
    const alike = text.split("e")[1] === other.split("e")[1];
    const first = alike ? [...text].findIndex((digit, n) => digit !== other[n]) : 0;
    const length = first < 0 ? text.length : first;
    return `<span class="same">${text.slice(0, length)}</span>${text.slice(length)}`;
  }

  /**
   * Which term of a difference's error may be the largest at a pixel, and how large each slope's is at most, by theorem.
   * @param {State} state @param {number} u @param {number} v
   * @returns {Record<string, string>}
   */
  function bounded(state, u, v) {
    const bounds = module.bounds_of(state);
    if (!bounds) return { "error led by": "no theorem covers this" };
    const [, leading, of_u, of_v] = module.kernel(bounds, u, v, state.ku, state.kv, state.eps);
    const most = [of_u, of_v].map((bound) => bound.toExponential(2));
    return {
      "error led by": data.terms[leading - 1] ?? "nothing: it is 0",
      "|Δh<sub>u</sub>| ≤": most[0],
      "|Δh<sub>v</sub>| ≤": most[1]
    };
  }

  /** What both pipelines share. @param {PixelRecord} one @param {State} state */
  function shared(one, state) {
    const { column, row, surface, u, v, theta, phi, h, point } = one;
    /** @param {boolean | undefined} flag */
    const yes = (flag) => (flag ? "yes" : "no");
    /** @type {Record<string, string | number | undefined>} */
    const found = { pixel: `${column}, ${row}`, surface };
    if (u !== undefined && v !== undefined) {
      Object.assign(found, { "kink flag": yes(one.kink), "straddles a crease": yes(one.straddling) });
      Object.assign(found, bounded(state, u, v));
      Object.assign(found, { u, v, θ: theta, φ: phi, h });
    }
    for (const [n, number] of (point ?? []).entries()) found[`P<sub>${AXES[n]}</sub>`] = number;
    return Object.entries(found);
  }

  /** What they compute, each in its own way. @param {PixelRecord} one @param {PixelRecord} other */
  function compared(one, other) {
    return COMPUTED.flatMap(({ key, names }) =>
      (other[key] ?? []).map((b, n) => {
        const a = /** @type {number[]} */ (one[key])[n];
        const cells = [marked(a, b), marked(b, a), distance(a, b)].map((text) => `<td>${text}</td>`);
        return `<tr><th scope="row">${names[n]}</th>${cells.join("")}</tr>`;
      })
    );
  }

  /** @param {State} state */
  function show(state) {
    const methods = Object.values(module.methods_of(state));
    const [one, other] = methods.map((method) => module.pixel(state, method, states.crop(state)));
    const entries = shared(one, state).map(([name, value]) => `<div><dt>${name}</dt><dd>${value}</dd></div>`);
    facts.innerHTML = entries.join("");
    body.innerHTML = compared(one, other).join("");
    find_element(root, ".sim-python code").textContent = states.python(state);
  }

  return { show };
}

// What is known of the pixel under the cursor, by both pipelines, and how many floats apart they are.
"use strict";

Simulator.cursor = function (root, states, data, module) {
  const body = root.querySelector(".sim-pixel tbody"), facts = root.querySelector(".sim-facts"), line = root.querySelector(".sim-python code");

  // Where a float stands among all floats, counted from 0.
  function place(number) {
    const [bits] = new BigInt64Array(Float64Array.of(number).buffer);
    return bits < 0n ? -(bits & 0x7fffffffffffffffn) : bits;
  }

  // Past that many, a count of floats says less than the numbers themselves.
  const MOST = 10000n;

  function ulps(a, b) {
    const apart = place(a) - place(b), count = apart < 0n ? -apart : apart;
    return count <= MOST ? `${count} ulp` : "—";
  }

  // Which term of a difference's error may be the largest at this pixel, and how large both slopes' are at most, by the theorems.
  function bounded(state, { u, v }) {
    const found = module.bounds(state, u, v, state.eps);
    if (!found) return [["error led by", "no theorem covers this"]];
    const [, leading, ...slopes] = found, most = slopes.map((bound, n) => [`|Δh<sub>${"uv"[n]}</sub>| ≤`, bound.toExponential(2)]);
    return [["error led by", data.terms[leading - 1]], ...most];
  }

  // Both records of a pixel, as renderer.pixel gives them.
  function records(state) {
    const raster = states.crop(state), method = { name: state.method, eps: state.eps };
    return [method, { name: "exact" }].map((m) => module.pixel(state, m, raster, state.column, state.row));
  }

  // What both pipelines share.
  function shared(one, state) {
    const yes = (flag) => (flag ? "yes" : "no"), found = [["pixel", `${one.column}, ${one.row}`], ["surface", one.surface]];
    if (one.u !== undefined) found.push(["kink flag", yes(one.kink)], ["straddles a crease", yes(one.straddling)], ...bounded(state, one));
    if (one.u !== undefined) for (const [name, key] of [["u", "u"], ["v", "v"], ["θ", "theta"], ["φ", "phi"], ["h", "h"]]) found.push([name, one[key]]);
    if (one.point) ["x", "y", "z"].forEach((axis, n) => found.push([`P<sub>${axis}</sub>`, one.point[n]]));
    return found;
  }

  // What they compute, each in its own way.
  function compared(one, other) {
    const found = [], both = (name, key) => found.push([name, key(one), key(other)]);
    if (one.u !== undefined) ["u", "v"].forEach((axis, n) => both(`h<sub>${axis}</sub>`, (r) => r.gradient[n]));
    if (one.normal) ["x", "y", "z"].forEach((axis, n) => both(`N′<sub>${axis}</sub>`, (r) => r.normal[n]));
    ["red", "green", "blue"].forEach((name, n) => both(name, (r) => r.rgb[n]));
    return found;
  }

  // Put rows where they differ from what is there.
  function fill(list, rows) {
    if (list.children.length !== rows.length) list.innerHTML = rows.join("");
    else rows.forEach((row, n) => row !== list.texts[n] && (list.children[n].outerHTML = row));
    list.texts = rows;
  }

  function show(state) {
    const [one, other] = records(state);
    fill(facts, shared(one, state).map(([name, value]) => `<div><dt>${name}</dt><dd>${value}</dd></div>`));
    fill(body, compared(one, other).map(([name, a, b]) =>
      `<tr><th scope="row">${name}</th><td>${a}</td><td>${b}</td><td>${ulps(a, b)}</td></tr>`));
    root.querySelector(".sim-far").hidden = !body.textContent.includes("—");
    line.textContent = states.python(state);
  }

  return { show, records, ulps };
};

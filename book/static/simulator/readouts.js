// The numbers and words beside the pictures: how far apart they are, flips, times, captions, the scale's bar.
"use strict";

Simulator.readouts = function (root, data) {
  const $ = (selector) => root.querySelector(selector), put = (name, text) => ($(`[data-readout=${name}]`).textContent = text);
  const METHODS = { central: "central", forward: "forward", central4: "fourth order" };
  const ENOUGH = 8, MOST = 24, SPREAD = 0.25; // times are shown when so many agree so far
  const css = (color) => `#${[0, 8, 16].map((shift) => ((color >>> shift) & 255).toString(16).padStart(2, "0")).join("")}`;
  const number = (x) => (x === 0 ? "0" : x.toExponential(2).replace("e-", "e−").replace("e+", "e"));
  let times = {}, captioned = "";

  function short(x) {
    const [digits, power] = x.toExponential().split("e").map(Number), up = [..."⁰¹²³⁴⁵⁶⁷⁸⁹"];
    if (x >= 0.01 && x < 1000) return String(x);
    const exponent = (power < 0 ? "⁻" : "") + [...String(Math.abs(power))].map((d) => up[d]).join("");
    return digits === 1 ? `10${exponent}` : `${Number(digits.toPrecision(3))} · 10${exponent}`;
  }

  function apart({ count, largest, squares }) {
    put("max", count ? number(largest) : "—");
    put("rms", count ? number(Math.sqrt(squares / 3 / count)) : "—");
  }

  // null: not yet.
  function counted(found) {
    const share = (n) => `${n.toLocaleString("en")} (${found.count ? Math.round((100 * n) / found.count) : 0} %)`;
    put("flips", found ? String(found.flips) : "…");
    put("attached", found ? found.attached.map(share).join(", ") || "no light is on" : "…");
  }

  function forget_times() {
    times = { numeric: [], symbolic: [], ratio: [] };
    for (const name of Object.keys(times)) put(name, "…");
  }

  const quartiles = (list) => [0.25, 0.5, 0.75].map((share) => list.slice().sort((a, b) => a - b)[Math.floor(share * (list.length - 1))]);

  // One more time of either pipeline, in milliseconds. Only what has settled is shown: a median, and the ratio's spread.
  function timed(numeric, symbolic) {
    for (const [name, time] of Object.entries({ numeric, symbolic, ratio: numeric / symbolic })) {
      times[name].push(time);
      if (times[name].length > MOST) times[name].shift();
    }
    if (times.ratio.length < ENOUGH || !times.ratio.every(isFinite)) return;
    const [low, middle, high] = quartiles(times.ratio);
    if (high - low > SPREAD * middle) return;
    for (const name of ["numeric", "symbolic"]) put(name, `${quartiles(times[name])[1].toFixed(1)} ms`);
    put("ratio", `${middle.toFixed(2)} (${low.toFixed(2)}–${high.toFixed(2)})`);
  }

  function remark({ view, method, field }) {
    if (view === "loci" && !data.fields[field].creases) return `${field} has no creases: there is nothing to draw over it.`;
    if (view === "terms" && (method !== "central" || !(`bounds_${field}` in data.kernels))) return "No theorem bounds this difference of this field: there is nothing to attribute.";
    return "";
  }

  function captions(state) {
    const { method, eps, scale, zoom, view, field } = state, key = [method, eps, scale, zoom, view, field].join();
    if (key === captioned) return;
    captioned = key;
    $("[data-title=numeric]").textContent = `${METHODS[method]}, ε = ${short(eps)}`;
    $("[data-title=difference]").textContent = scale === "log" ? "|ΔI|, logarithmic" : scale === "1e0" ? "|ΔI|" : `|ΔI| × ${short(Number(scale))}`;
    $(".sim-zoom output").textContent = zoom ? `${(2 ** (zoom / 2)).toPrecision(3)} ×` : "1 ×";
    $(".sim-remark").textContent = remark(state);
    $(".sim-legend").hidden = view !== "terms";
    const { inferno, grey } = data.tables, bar = $(".sim-bar");
    bar.querySelector("span").style.background = `linear-gradient(to right, ${(scale === "log" ? inferno : grey).filter((_, n) => n % 15 === 0).map(css)})`;
    const marks = scale === "log" ? ["10⁻¹⁶", "10⁻¹²", "10⁻⁸", "10⁻⁴", "1"] : ["0", short(1 / Number(scale))];
    bar.querySelector("p").innerHTML = marks.map((mark) => `<span>${mark}</span>`).join("");
  }

  $(".sim-legend").innerHTML = data.terms.map((term, n) => `<span><i style="background:${data.term_colours[n + 1]}"></i> ${term}</span>`).join(" ");
  return { apart, counted, timed, forget_times, captions };
};

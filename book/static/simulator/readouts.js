// The numbers and words beside the pictures: how far apart they are, flips, captions, the scale's bar.
"use strict";

/** @param {HTMLElement} root @param {SimulatorData} data @param {SimulatorModule} module */
function simulator_readouts(root, data, module) {
  /** @param {string} selector */
  const $ = (selector) => find_element(root, selector);
  /** @param {string} selector @param {string} text */
  function put(selector, text) {
    const place = $(selector);
    if (place.textContent !== text) place.textContent = text; // else some screen readers say it again
  }
  let end = 0; // of the scale of slopes

  /** @param {number} x */
  const number = (x) => (x === 0 ? "0" : scientific(x, 2));

  /** A count, its thousands apart; the browser's own way loads for 20 ms. @param {number} n */
  const with_commas = (n) => String(n).replace(/\B(?=(\d{3})+$)/g, ",");

  /** @param {number} x */
  const short = (x) => (x >= 0.01 && x < 1000 ? String(x) : in_powers(x, 2));

  /**
   * The largest difference, and the root mean square: about, while a coarser picture stands for the one that is asked for.
   * @param {{ count: number, max: number, size: number }} found
   * @param {boolean} is_whole
   * @param {number} most of the slopes that are shown
   */
  function apart({ count, max, size }, is_whole, most) {
    end = most;
    for (const [name, one] of Object.entries({ max, rms: size }))
      put(`[data-readout=${name}]`, count ? `${is_whole ? "" : "≈ "}${number(one)}` : "—");
  }

  /** @param {{ count: number, flips: number, attached: number[] } | null} found null: not yet */
  function counted(found) {
    const shares = found?.attached.map(
      (n) => `${with_commas(n)} (${found.count ? Math.round((100 * n) / found.count) : 0} %)`
    );
    put("[data-readout=flips]", String(found?.flips ?? "…"));
    put("[data-readout=attached]", shares ? shares.join(", ") || "no light is on" : "…");
  }

  /** @param {State} state */
  function remark(state) {
    const { view, field } = state;
    if (state.against === "surface" && ["by_ku", "bounds"].includes(view))
      return "Beside the surface’s bump the page has no such view: the picture stands for it.";
    if (view === "by_ku" && field === "own")
      return "The page has no exact slope by k_u of your own h: the picture stands for it.";
    if (view === "by_lamp" && !state.lights[0]) return "The first light is off: no colour moves with it.";
    if (field === "own") {
      const seam = module.own_of(state)?.has_seam ? "h differs at u = 0 and u = 1: the seam is in both pictures. " : "";
      return `${seam}Of your own h no bound is proved.`;
    }
    if (view === "loci" && !data.fields[field].creases)
      return `${field} has no creases: there is nothing to draw over it.`;
    if (view === "terms" && !module.bounds_of(state))
      return "No theorem bounds this difference of this field: there is nothing to attribute.";
    return "";
  }

  /** @param {State} state */
  function captions(state) {
    const { method, eps, scale, zoom, view } = state;
    const gain = scale === "1e0" ? "" : ` × ${short(Number(scale))}`;
    put("[data-title=numeric]", `${$(`#sim-method [value=${method}]`).textContent}, ε = ${short(eps)}`);
    put("[data-title=difference]", `|ΔI|${Number(scale) ? gain : ", logarithmic"}`);
    name_pictures(state);
    put(".sim-zoom output", zoom ? `${(2 ** (zoom / 2)).toPrecision(3)} ×` : "1 ×");
    put(".sim-remark", remark(state));
    const legends = view === "terms" ? terms : view in data.by ? slopes() : [];
    $(".sim-legend").hidden = !legends.length;
    $(".sim-legend").innerHTML = legends
      .map(([color, words]) => `<span><i style="background:${color}"></i> ${words}</span>`)
      .join(" ");
  }

  /** Give every picture a name that says what it shows now. @param {State} state */
  function name_pictures({ field, ku, kv, beta, view, method, eps, against }) {
    const scene = `${field}, k u ${ku}, k v ${kv}, β ${beta}`;
    const [by, seen] = [`#sim-method [value=${method}]`, `#sim-view [value=${view}]`].map(
      (place) => $(place).textContent
    );
    const apart = ["rms", "max"].map((name) => `${name} ${$(`[data-readout=${name}]`).textContent}`).join(", ");
    const names = {
      numeric: `${seen}, ${by}, ε ${eps}`,
      symbolic: `${seen}, ${$(`#sim-against [value=${against}]`).textContent}`,
      difference: apart
    };
    for (const [name, words] of Object.entries(names))
      $(`[data-picture=${name}] .pixels`).setAttribute("aria-label", `${name}: ${scene}; ${words}`);
  }

  const terms = data.terms.map((term, n) => [data.term_colours[n + 1], term]);

  // The ends of a scale of slopes, and its middle.
  function slopes() {
    const words = [`≤ −${number(end)}`, "0", `≥ ${number(end)}`];
    return words.map((word, n) => {
      const color = data.tables.slopes[Math.round(127.5 * n)];
      return [`rgb(${[0, 8, 16].map((shift) => (color >> shift) & 255)})`, word];
    });
  }

  return { apart, counted, captions };
}

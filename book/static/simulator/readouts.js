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
   */
  function apart({ count, max, size }, is_whole) {
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
    const { method, eps, against, scale, zoom, view } = state;
    const gain = scale === "1e0" ? "" : ` × ${short(Number(scale))}`;
    put("[data-title=numeric]", `${$(`#sim-method [value=${method}]`).textContent}, ε = ${short(eps)}`);
    root.classList.toggle("sim-both-step", against !== "exact");
    put("[data-title=difference]", `|ΔI|${Number(scale) ? gain : ", logarithmic"}`);
    name_pictures(state);
    put(".sim-zoom output", zoom ? `${(2 ** (zoom / 2)).toPrecision(3)} ×` : "1 ×");
    put(".sim-remark", remark(state));
    $(".sim-legend").hidden = view !== "terms";
    $("#certified").hidden = view !== "bounds";
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

  const terms = data.terms.map(
    (term, n) => `<span><i style="background:${data.term_colours[n + 1]}"></i> ${term}</span>`
  );
  $(".sim-legend").innerHTML = terms.join(" ");
  return { apart, counted, captions };
}

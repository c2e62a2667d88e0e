// The difference's levels, from 0 to 255, as colours. Where several pixels share one of the screen's, the largest level
// is taken before it is coloured: a crease one pixel wide stays as bright as it is. Below the picture stand the scale
// and how many pixels have each level.
"use strict";

/** @param {HTMLElement} root @param {SimulatorData} data */
function simulator_scale(root, data) {
  const { inferno, grey } = data.tables;
  const LEVELS = 256;
  const DECADE = 16; // levels, of the logarithmic scale; level 0 is 10⁻¹⁶ and whatever is less
  const HIGH = 20; // of the counts
  const [bar, marks] = ["span", "p"].map((selector) => find_element(root, `.sim-bar ${selector}`));
  const counts_path = make_svg(".sim-counts");
  let colors = Uint32Array.from(inferno);
  let shown = "";

  /** @param {string} selector */
  function make_svg(selector) {
    const svg = find_element(root, selector);
    svg.innerHTML = path_markup("", "");
    return find_element(svg, "path");
  }

  /** @param {Uint8Array} levels */
  function count(levels) {
    const counts = new Uint32Array(LEVELS);
    for (const level of levels) counts[level]++;
    return counts;
  }

  /** The whole decades that a fitted scale shows: all but the least hundredth of what is not 0. @param {Uint32Array} counts */
  function fitted(counts) {
    const many = counts.reduce((sum, number) => sum + number) - counts[0];
    let low = 1;
    for (let sum = counts[1]; low < LEVELS - 1 && sum < 0.01 * many; sum += counts[low]) low++;
    const high = Math.max(low, counts.findLastIndex(Boolean));
    const first = Math.min(Math.floor(low / DECADE), DECADE - 2);
    return many ? [first, Math.max(first + 2, Math.ceil((high + 1) / DECADE))] : [0, DECADE];
  }

  /** @param {string} scale @param {number[]} decades */
  function show_bar(scale, [first, last]) {
    const key = [scale, first, last].join();
    if (key === shown) return;
    shown = key;
    const is_linear = Number(scale) > 0;
    const [low, high] = [first, last].map((decade) => decade * DECADE);
    const palette = is_linear ? grey : inferno;
    const place = (/** @type {number} */ level) => clamp(0, Math.round(((level - low) / (high - 1 - low)) * 255), 255);
    colors = Uint32Array.from(palette, (_, level) => palette[place(level)]);
    const css = palette
      .filter((_, n) => n % 15 === 0)
      .map((color) => `rgb(${[0, 8, 16].map((shift) => (color >>> shift) & 255)})`);
    const powers = [0, 0.25, 0.5, 0.75, 1].map((share) => first + share * (last - first) - DECADE);
    const texts = powers.filter(Number.isInteger).map((power) => (power ? `10${raised(power)}` : "1"));
    const ends = ["0", scale === "1e0" ? "1" : `10${raised(-Math.log10(Number(scale)))}`];
    bar.style.background = `linear-gradient(to right, ${css})`;
    marks.replaceChildren(...(is_linear ? ends : texts).map((mark) => make_element("span", {}, mark)));
  }

  /** Choose the colours for a picture's levels, and show the scale. @param {string} scale @param {Uint8Array} levels */
  function choose(scale, levels) {
    const counts = count(levels);
    const decades = scale === "fit" ? fitted(counts) : [0, DECADE];
    show_bar(scale, decades);
    const [low, high] = decades.map((decade) => decade * DECADE);
    const seen = counts.subarray(Math.max(1, low), high);
    const most = Math.sqrt(Math.max(1, ...seen));
    const wide = LEVELS / (high - low);
    let text = `M${low ? 0 : wide} ${HIGH}`;
    for (const number of seen) text += `V${(HIGH * (1 - Math.sqrt(number) / most)).toFixed(1)}h${wide}`;
    counts_path.setAttribute("d", `${text}V${HIGH}z`);
  }

  /**
   * A square of levels in colour, `by` × `by` of them a pixel.
   * @param {Uint8Array} levels
   * @param {number} side
   */
  function colored(levels, side, by = 1) {
    const wide = side / by;
    const largest = by === 1 ? levels : new Uint8Array(wide * wide);
    if (by > 1) {
      for (let row = 0, i = 0; row < side; row++) {
        const start = Math.floor(row / by) * wide;
        for (let column = 0; column < side; column++, i++) {
          const cell = start + Math.floor(column / by);
          if (levels[i] > largest[cell]) largest[cell] = levels[i];
        }
      }
    }
    const pixels = Uint32Array.from(largest, (level) => colors[level]);
    return new ImageData(new Uint8ClampedArray(pixels.buffer), wide);
  }

  return { choose, colored };
}

// The difference's levels, from 0 to 255, as colours. Where several pixels share one of the screen's, the largest level
// is taken before it is coloured: a crease one pixel wide stays as bright as it is. Below the picture stand the scale
// and how many pixels have each level.
"use strict";

/** @param {HTMLElement} root @param {SimulatorData} data */
function simulator_scale(root, data) {
  const { inferno, grey } = data.tables;
  const LEVELS = 256;
  const SOME = 0x100; // set in a logarithmic level of what is not 0
  const BLACK = 0xff000000;
  const OPEN = 0xff739e00; // the palette's green, for a bound that is not known
  const DECADE = 16; // levels, of the logarithmic scale; level 0 is 10⁻¹⁶ and whatever is less
  const HIGH = 20; // of the counts
  /** @type {HTMLCanvasElement} */
  const bar = find_element(root, ".sim-bar canvas");
  const marks = find_element(root, ".sim-bar p");
  const counts_path = find_element(root, ".sim-counts path");
  let is_linear = false;
  let colors = Uint32Array.from(inferno);
  let shown = "";

  /** How many pixels have each level; of a linear difference, in the colour in which it is the largest. @param {Uint8Array} levels */
  function count(levels) {
    const counts = new Uint32Array(LEVELS);
    for (let i = 0; i < levels.length; i += 4)
      counts[is_linear ? Math.max(levels[i], levels[i + 1], levels[i + 2]) : levels[i]]++;
    return counts;
  }

  /** The whole decades that a fitted scale shows, two at least: those of more than a thousandth of what is not 0. @param {Uint32Array} counts */
  function fitted(counts) {
    const many = Array.from({ length: DECADE }, (_, n) =>
      total([...counts.subarray(n * DECADE || 1, (n + 1) * DECADE)], Number)
    );
    const some = many.map((number) => number > 0.001 * total(many, Number));
    const last = Math.max(2, some.lastIndexOf(true) + 1);
    return [clamp(0, some.indexOf(true), last - 2), last];
  }

  /** @param {string} scale @param {number[]} decades */
  function show_bar(scale, [first, last]) {
    const key = [scale, first, last].join();
    if (key === shown) return;
    shown = key;
    const [low, high] = [first, last].map((decade) => decade * DECADE);
    const palette = is_linear ? grey : inferno;
    const place = (/** @type {number} */ level) => clamp(0, Math.round(((level - low) / (high - 1 - low)) * 255), 255);
    colors = Uint32Array.from(palette, (_, level) => palette[place(level)]);
    const powers = [0, 0.25, 0.5, 0.75, 1].map((share) => first + share * (last - first) - DECADE);
    const texts = powers.filter(Number.isInteger).map((power) => (power ? ten_to(power) : "1"));
    const ends = ["0", scale === "1e0" ? "1" : ten_to(-Math.log10(Number(scale)))];
    bar.getContext("2d")?.putImageData(image_of(Uint32Array.from(palette), LEVELS), 0, 0);
    marks.replaceChildren(...(is_linear ? ends : texts).map((mark) => make_element("span", {}, mark)));
  }

  /** Choose the colours for a picture's levels, and show the scale. @param {string} scale @param {Uint8Array} levels */
  function choose(scale, levels) {
    is_linear = Number(scale) > 0; // which has a level for each colour
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
   * A square of pixels with the largest levels of those that each of them stands for.
   * @template {Uint8Array | Uint32Array} Levels
   * @param {Levels} levels so many a pixel as `largest` has
   * @param {Levels} largest
   * @param {number} side
   * @param {number} wide
   */
  function reduce(levels, largest, side, wide) {
    const each = largest.length / (wide * wide);
    const places = Int32Array.from({ length: side }, (_, n) => Math.floor((n * wide) / side));
    for (let row = 0, i = 0; row < side; row++) {
      for (let column = 0; column < side; column++) {
        const cell = each * (places[row] * wide + places[column]);
        for (let n = cell; n < cell + each; n++, i++) if (levels[i] > largest[n]) largest[n] = levels[i];
      }
    }
  }

  /** A square of levels in colour, in so many pixels a side. @param {Uint8Array<ArrayBuffer>} levels @param {number} side */
  function colored(levels, side, wide = side) {
    let words = new Uint32Array(levels.buffer);
    if (wide < side) {
      const largest = new Uint32Array(wide * wide);
      if (is_linear) reduce(levels, new Uint8Array(largest.buffer), side, wide);
      else reduce(words, largest, side, wide); // a word is larger where its level is
      words = largest;
    }
    return image_of(is_linear ? words.slice() : words.map((word) => (word & SOME ? colors[word & 255] : BLACK)), wide);
  }

  /** Levels of the logarithmic scale, a byte each, whatever the picture's scale is. @param {Uint8Array} levels @param {number} side */
  const still = (levels, side) =>
    image_of(
      Uint32Array.from(levels, (level) => inferno[level]),
      side
    );

  /** Levels of bounds in colour, in so many pixels a side, each the largest there. @param {Uint8Array} levels @param {number} side @param {number} wide */
  function bounds(levels, side, wide) {
    const largest = new Uint8Array(wide * wide);
    reduce(levels, largest, side, wide);
    return image_of(
      Uint32Array.from(largest, (level) => (level < LEVELS - 1 ? inferno[level] : OPEN)),
      wide
    );
  }

  /** @param {Uint32Array<ArrayBuffer>} pixels @param {number} wide */
  const image_of = (pixels, wide) => new ImageData(new Uint8ClampedArray(pixels.buffer), wide);

  return { choose, colored, still, bounds };
}

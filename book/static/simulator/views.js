// Pictures as bytes, as in renderer/views.py: sRGB, slope in grey, straddled pixels, the difference on two scales.
"use strict";
var Simulator = Simulator || {};

Simulator.views = function (data, module) {
  const LOW = -16; // the logarithmic scale runs from 1e-16 to 1
  const OPAQUE = 255 << 24;
  const grey = (level) => OPAQUE | (level << 16) | (level << 8) | level;
  const inferno = Uint32Array.from({ length: 256 }, (_, n) => {
    const [r, g, b] = [0, 2, 4].map((k) => parseInt(data.inferno.slice(6 * n + k, 6 * n + k + 2), 16));
    return OPAQUE | (b << 16) | (g << 8) | r;
  });

  // sRGB by table: the level at each 4096th, put right by the levels' own thresholds.
  const encoded = (linear) => (linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.pow(linear, 1 / 2.4) - 0.055) * 255;
  const threshold = Float64Array.from({ length: 257 }, (_, level) => {
    const s = (level - 0.5) / 255;
    return level > 255 ? Infinity : s <= 0.04045 ? s / 12.92 : Math.pow((s + 0.055) / 1.055, 2.4);
  });
  const guess = Uint8Array.from({ length: 4097 }, (_, n) => Math.max(0, Math.round(encoded(n / 4096)) - 1));

  function byte(linear) {
    let level = guess[Math.floor(linear * 4096)];
    while (linear >= threshold[level + 1]) level++;
    return level;
  }

  const color = (r, g, b) => OPAQUE | (byte(b) << 16) | (byte(g) << 8) | byte(r);

  function background([red, green, blue], pixels) {
    for (let i = 0; i < pixels.length; i++) pixels[i] = color(red[i], green[i], blue[i]);
  }

  function image({ rgb: [red, green, blue] }, at, pixels) {
    for (let n = 0; n < at.length; n++) {
      const i = at[n];
      pixels[i] = color(red[i], green[i], blue[i]);
    }
  }

  // |grad h| in grey, white at `steepest`.
  function slope({ h_u, h_v }, at, pixels, steepest) {
    const slopes = module.kernel("slope", h_u, h_v), scale = steepest > 0 ? 255 / steepest : 0;
    for (const i of at) pixels[i] = grey(Math.min(255, Math.round(slopes[i] * scale)));
  }

  // White where the difference reaches across a crease, over the dimmed picture.
  function straddle({ rgb: [red, green, blue] }, flags, at, pixels) {
    const third = (c) => (byte(c) / 3) | 0;
    at.forEach((i, n) => {
      pixels[i] = flags[n] ? grey(255) : OPAQUE | (third(blue[i]) << 16) | (third(green[i]) << 8) | third(red[i]);
    });
  }

  const per_factor = 255.999 / -LOW / Math.LN10;
  // The logarithm by table: the level where the float's upper 16 bits begin, put right by the levels' own thresholds.
  const size_of = new Float64Array(1), halves = new Uint32Array(size_of.buffer);
  const least = Float64Array.from({ length: 257 }, (_, level) => (level > 255 ? Infinity : Math.exp((level - 255.999) / per_factor)));
  const level_at = Uint8Array.from({ length: 2 ** 15 }, (_, upper) => {
    halves[1] = upper << 16;
    return Math.max(0, Math.min(255, Math.floor(255.999 + Math.log(size_of[0]) * per_factor)));
  });

  function log_color(size) {
    size_of[0] = size;
    let level = level_at[halves[1] >>> 16];
    while (size >= least[level + 1]) level++;
    return size > 0 ? inferno[level] : OPAQUE;
  }

  const linear_level = (size, gain) => Math.round(Math.min(1, size * gain) * 255);

  // Paint |a - b| (scale "log", or a gain as text), and return {max, sum} of its size and its square over all channels.
  function difference(a, b, at, pixels, scale) {
    const [ar, ag, ab] = a.rgb, [br, bg, bb] = b.rgb, gain = scale === "log" ? 0 : Number(scale);
    let max = 0, sum = 0;
    for (let n = 0; n < at.length; n++) {
      const i = at[n], r = Math.abs(ar[i] - br[i]), g = Math.abs(ag[i] - bg[i]), blue = Math.abs(ab[i] - bb[i]);
      const most = r > g ? (r > blue ? r : blue) : g > blue ? g : blue;
      if (most > max) max = most;
      sum += r * r + g * g + blue * blue;
      if (gain === 0) pixels[i] = log_color(most);
      else pixels[i] = OPAQUE | (linear_level(blue, gain) << 16) | (linear_level(g, gain) << 8) | linear_level(r, gain);
    }
    return { max, sum };
  }

  // The same numbers without a picture.
  function apart(a, b, at) {
    let max = 0, sum = 0;
    for (let c = 0; c < 3; c++) {
      const one = a.rgb[c], other = b.rgb[c];
      for (let n = 0; n < at.length; n++) {
        const size = Math.abs(one[at[n]] - other[at[n]]);
        if (size > max) max = size;
        sum += size * size;
      }
    }
    return { max, sum };
  }

  return { OPAQUE, LOW, inferno, background, image, slope, straddle, difference, apart };
};

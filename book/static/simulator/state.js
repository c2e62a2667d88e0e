// What the reader can set, said once: names, ranges, defaults; the URL's fragment and the line of Python made from it.
"use strict";

Simulator.state = function ({ fields, models, scene }) {
  const decimal = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d{1,3})?$/i;

  function number(low, high, start) {
    const allowed = `a number from ${low} to ${high}`;
    const read = (text) => (decimal.test(text.trim()) ? Number(text) + 0 : NaN);
    return { start, read, allowed, holds: (x) => typeof x === "number" && x >= low && x <= high, write: String };
  }

  const whole = (low, high, start) => ({ ...number(low, high, start), allowed: `a whole number from ${low} to ${high}`,
    holds: (x) => Number.isInteger(x) && x >= low && x <= high });

  function choice(values, start) {
    const read = (text) => values.find((value) => String(value) === text);
    return { start, read, write: String, holds: (x) => values.includes(x), allowed: `one of ${values.join(", ")}` };
  }

  const switches = (count) => ({
    start: Array(count).fill(true),
    read: (text) => (/^[01]+$/.test(text) ? [...text].map((digit) => digit === "1") : null),
    write: (lights) => lights.map((on) => (on ? 1 : 0)).join(""),
    holds: (x) => Array.isArray(x) && x.length === count && x.every((on) => typeof on === "boolean"),
    allowed: `${count} digits, 1 for on and 0 for off`,
  });

  const FURTHEST = 16; // half-octaves of zoom: 256 times
  const parameters = {
    field: choice(Object.keys(fields), scene.field),
    eps: number(1e-16, 0.1, 1e-3),
    beta: number(0, 2, scene.beta),
    ku: number(-64, 64, scene.ku),
    kv: number(-64, 64, scene.kv),
    model: choice(Object.keys(models), scene.model),
    method: choice(["central", "forward", "central4"], "central"),
    view: choice(["image", "slope", "kink", "loci", "straddle", "terms"], "image"),
    scale: choice(["log", "1e0", "1e2", "1e4", "1e6", "1e8", "1e10", "1e12"], "log"),
    lights: switches(scene.lights.length),
    ball: { ...choice([true, false], true), read: (text) => ({ 1: true, 0: false })[text], write: (on) => (on ? "1" : "0"),
      allowed: "1 or 0" },
    size: choice([128, 256, 512, 1024], 256),
    zoom: whole(0, FURTHEST, 0),
    left: whole(0, 2 ** 24, 0),
    top: whole(0, 2 ** 24, 0),
    column: whole(0, 2 ** 24, 104),
    row: whole(0, 2 ** 24, 72),
  };

  // The side of the whole raster, of which size x size pixels are shown.
  const side = ({ size, zoom }) => Math.round(size * 2 ** (zoom / 2));

  const start = () => Object.fromEntries(Object.entries(parameters).map(([name, p]) => [name, p.start]));

  const refused = (name, value, allowed = parameters[name].allowed) => new Error(`${name} = ${value} is not allowed: ${allowed}`);

  // Return the state with changes, checked; throw an Error that names the value and what is allowed.
  function changed(state, changes) {
    const next = { ...state, ...changes }, { left, top, size } = next, last = side(next) - size;
    for (const [name, parameter] of Object.entries(parameters)) if (!parameter.holds(next[name])) throw refused(name, next[name]);
    for (const [name, low, high] of [["left", 0, last], ["top", 0, last], ["column", left, left + size - 1], ["row", top, top + size - 1]]) {
      if (next[name] < low || next[name] > high) throw refused(name, next[name], `from ${low} to ${high} here`);
    }
    return next;
  }

  // Read one parameter from a text, or throw.
  function read(name, text) {
    const value = parameters[name].read(text);
    if (!parameters[name].holds(value)) throw refused(name, text.slice(0, 40));
    return value;
  }

  // The shown part moved or resized so that it stays inside the raster, and the cursor inside the shown part.
  function within(state) {
    const last = side(state) - state.size, clamp = (x, low, high) => Math.max(low, Math.min(high, Math.round(x)));
    const left = clamp(state.left, 0, last), top = clamp(state.top, 0, last);
    const column = clamp(state.column, left, left + state.size - 1), row = clamp(state.row, top, top + state.size - 1);
    return { ...state, left, top, column, row };
  }

  // The cursor moved by so many pixels; the shown part follows it.
  function moved(state, dx, dy) {
    const last = side(state) - 1, column = Math.max(0, Math.min(last, state.column + dx)), row = Math.max(0, Math.min(last, state.row + dy));
    const seen = (begin, at) => Math.max(Math.min(begin, at), at - state.size + 1);
    return within({ ...state, left: seen(state.left, column), top: seen(state.top, row), column, row });
  }

  // Show the raster at another zoom or size; the image point at the share (across, down) of the picture stays there.
  function zoomed(state, changes, across = 0.5, down = 0.5) {
    const next = { ...state, ...changes }, ratio = side(next) / side(state);
    next.left = (state.left + across * state.size) * ratio - across * next.size;
    next.top = (state.top + down * state.size) * ratio - down * next.size;
    next.column = Math.floor((state.column + 0.5) * ratio);
    next.row = Math.floor((state.row + 0.5) * ratio);
    return within(next);
  }

  const MARK = "#sim?";

  const fragment = (state) =>
    MARK + Object.entries(parameters).map(([name, p]) => `${name}=${p.write(state[name])}`).join("&");

  // Return the state of a fragment, null if it is none of ours; throw if it is malformed.
  function from_fragment(text) {
    if (!text.startsWith(MARK)) return null;
    const found = {};
    for (const [name, value] of new URLSearchParams(text.slice(MARK.length))) {
      if (!Object.hasOwn(parameters, name)) throw new Error(`the address sets ${name.slice(0, 40)}, which is not a setting`);
      if (name in found) throw new Error(`the address sets ${name} twice`);
      found[name] = read(name, value);
    }
    const state = { ...start(), ...found };
    if ("column" in found || "row" in found) return changed(state, {});
    const { column, row } = within(state);
    return changed(state, { column, row });
  }

  const crop = (state) => ({ width: side(state), height: side(state), left: state.left, top: state.top, wide: state.size, high: state.size });

  // One line that prints the renderer's own record of the pixel under the cursor, by the difference and exactly.
  function python(state) {
    const light = ({ position, color }, on) => `Light((${position.join(", ")}), ${on ? `(${color.join(", ")})` : "None"})`;
    const all = state.lights.every(Boolean);
    const given = [`field="${state.field}"`, `ku=${state.ku}`, `kv=${state.kv}`, `beta=${state.beta}`, `model="${state.model}"`];
    if (!state.ball) given.push("ball=False");
    if (!all) given.push(`lights=(${scene.lights.map((l, n) => light(l, state.lights[n])).join(", ")})`);
    const at = `s, ${side(state)}, ${side(state)}, ${state.column}, ${state.row}`;
    return `from renderer import ${all ? "" : "Light, "}Scene, ${state.method}, pixel; s = Scene(${given.join(", ")}); ` +
      `print(pixel(${at}, ${state.method}(${state.eps})), pixel(${at}), sep="\\n")`;
  }

  return { parameters, start, changed, read, within, moved, zoomed, side, crop, fragment, from_fragment, python, FURTHEST };
};

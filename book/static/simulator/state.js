// What the reader can set, said once: names, ranges, defaults; the URL's fragment and the line of Python made from it.
"use strict";

/** @param {HTMLElement} root @param {SimulatorData} data @param {(state: State) => boolean} has_seam */
function simulator_states(root, { fields, models, scene, record, by: numbers }, has_seam) {
  const DECIMAL = /^[\de.+-]+$/i; // the signs of a decimal number, and of no other that Number reads
  /** @type {Record<string, string>} */
  const SIGNS = { eps: "ε", beta: "β" }; // as the page has them

  /** The number in a text as code has it, or as print has: 1e-8, 1.2e−8, 10⁻⁸, 3 · 10⁻⁴, 2^-20, 1/8; NaN in others. @param {string} text */
  function number_in(text) {
    const in_code = text
      .replace(/[⁻⁰¹²³⁴-⁹]+/g, "^$&")
      .normalize("NFKC") // raised digits as digits
      .replaceAll("−", "-")
      .replace(/ *[·×*] *10\^/, "e")
      .replace(/^ *10\^/, "1e")
      .trim();
    const [top, bottom = 1, ...more] = in_code.split("/").map((part) => {
      const [base, exponent = 1, ...rest] = part.split("^").map((text) => (DECIMAL.test(text) ? Number(text) : NaN));
      return rest.length || Number.isNaN(base) ? NaN : base ** exponent;
    });
    return more.length ? NaN : top / bottom + 0;
  }

  /** @param {number} low @param {number} high @param {number} start @returns {Parameter} */
  const number = (low, high, start) => ({
    start,
    read: number_in,
    write: String,
    holds: (x) => typeof x === "number" && x >= low && x <= high,
    allowed: `a number from ${low} to ${high}`
  });

  /** @param {number} low @param {number} high @param {number} start @returns {Parameter} */
  const whole = (low, high, start) => ({
    ...number(low, high, start),
    holds: (x) => Number.isInteger(x) && x >= low && x <= high,
    allowed: `a whole number from ${low} to ${high}`
  });

  /** @param {(string | number)[]} values @param {string | number} start @returns {Parameter} */
  const choice = (values, start) => ({
    start,
    read: (text) => values.find((value) => String(value) === text),
    write: String,
    holds: (x) => values.includes(x),
    allowed: `one of ${values.join(", ")}`
  });

  /** What a menu of the page offers. @param {string} name */
  function offered(name) {
    /** @type {HTMLSelectElement} */
    const menu = find_element(root, `#sim-${name}`);
    return Array.from(menu.options, (option) => option.value);
  }

  /** @param {number} count @returns {Parameter} */
  const switches = (count) => ({
    start: Array(count).fill(true),
    read: (text) => (/^[01]+$/.test(text) ? [...text].map((digit) => digit === "1") : null),
    write: (lights) => lights.map(Number).join(""),
    holds: (x) => Array.isArray(x) && x.length === count && x.every((on) => typeof on === "boolean"),
    allowed: `${count} digits, 1 for on and 0 for off`
  });

  const FURTHEST_LAMP = 50;
  const LOWEST_LAMP = 0.05;
  /** @param {number[]} at @param {number[]} center @param {number} radius */
  const is_clear = (at, center, radius) => Math.hypot(...at.map((part, axis) => part - center[axis])) > 1.01 * radius;
  /** @type {Parameter} */
  const place = {
    start: scene.lights[0].position,
    read: (text) => text.split(",").map(number_in),
    write: String,
    holds: (x) =>
      Array.isArray(x) &&
      x.length === 3 &&
      x.every((part) => Math.abs(part) <= FURTHEST_LAMP) &&
      x[2] >= LOWEST_LAMP &&
      is_clear(x, [0, 0, 0], scene.radius) &&
      is_clear(x, scene.ball_center, scene.ball_radius),
    allowed: `x, y, z from -${FURTHEST_LAMP} to ${FURTHEST_LAMP}, z at least ${LOWEST_LAMP}, outside both spheres`
  };

  // A formula as it is typed or printed, in the letters that `--field-expression` reads.
  /** @param {string} text */
  const formula_text = (text) =>
    text
      .replace(/\b(np|numpy|math|sp|sympy)\./g, "")
      .replaceAll("−", "-")
      .replace(/[·×]|(?<=[\wπ)])\s*(?=π)|(?<=π)\s*(?=[\w(])/g, "*")
      .replaceAll("π", "pi")
      .replace(/[²³]/g, (sign) => `**${"²³".indexOf(sign) + 2}`);
  /** @type {Parameter} */
  const formula = {
    start: "(2*sinpi(20*u)*sinpi(9*v) + sinpi(26*u + 5*v) + sinpi(14*v - 18*u))/10",
    read(text) {
      const written = formula_text(text);
      formula_of(written, { ku: 1, kv: 1 });
      return written;
    },
    write: encodeURIComponent,
    holds: (text) => typeof text === "string",
    allowed: "a formula of u and v"
  };

  const AXES = [
    ["left", "column"],
    ["top", "row"]
  ]; // of the raster: where the shown part begins, and where the cursor is
  const FURTHEST = 16; // half-octaves of zoom: 256 times
  const MOST = 2 ** 24;
  /** @type {Record<string, Parameter>} */
  const parameters = {
    field: choice([...Object.keys(fields), "own"], scene.field),
    h: formula,
    eps: number(1e-18, 0.1, 1e-3),
    beta: number(0, 2, scene.beta),
    ku: number(-64, 64, scene.ku),
    kv: number(-64, 64, scene.kv),
    model: choice(Object.keys(models), scene.model),
    method: choice(offered("method"), "central"),
    against: choice(offered("against"), "exact"),
    against_eps: number(1e-18, 0.1, 1e-3),
    view: choice(offered("view"), "image"),
    scale: choice(offered("scale"), "log"),
    axis: choice(["u", "v"], "u"),
    lights: switches(scene.lights.length),
    lamp: place,
    ball: choice([1, 0], 1),
    size: choice(offered("size").map(Number), 256),
    zoom: whole(0, FURTHEST, 0),
    left: whole(0, MOST, 0),
    top: whole(0, MOST, 0),
    column: whole(0, MOST, 104),
    row: whole(0, MOST, 72)
  };

  /** The side of the whole raster, of which size x size pixels are shown. @param {State} state */
  const side = ({ size, zoom }) => Math.round(size * 2 ** (zoom / 2));

  /** @returns {State} */
  const start = () =>
    /** @type {any} */ (Object.fromEntries(Object.entries(parameters).map(([name, p]) => [name, p.start])));

  /** @param {string} name @param {any} value */
  const refused = (name, value, allowed = parameters[name].allowed) =>
    new Error(`${SIGNS[name] ?? name} = ${value} is not allowed: ${allowed}`);

  /**
   * Return the state with changes, checked; throw an Error that names the value and what is allowed.
   * @param {State} state
   * @param {Partial<State>} changes
   */
  function changed(state, changes) {
    const next = { ...state, ...changes };
    for (const [name, parameter] of Object.entries(parameters))
      if (!parameter.holds(next[name])) throw refused(name, next[name]);
    /** @param {string} name @param {number} low @param {number} high */
    function check(name, low, high) {
      if (next[name] < low || next[name] > high) throw refused(name, next[name], `from ${low} to ${high} here`);
    }
    for (const [corner, cursor] of AXES) {
      check(corner, 0, side(next) - next.size);
      check(cursor, next[corner], next[corner] + next.size - 1);
    }
    return next;
  }

  /** Read one parameter from a text, or throw. @param {string} name @param {string} text */
  function read(name, text) {
    const value = parameters[name].read(text);
    if (parameters[name].holds(value)) return value;
    const comma = text.split(",").length === 2 && "write the decimal comma as a point";
    throw refused(name, text.slice(0, 40), comma || undefined);
  }

  /**
   * The shown part moved or resized so that it stays inside the raster, and the cursor inside the shown part.
   * @param {State} state
   */
  function within(state) {
    const next = { ...state };
    for (const [corner, cursor] of AXES) {
      next[corner] = clamp(0, Math.round(state[corner]), side(state) - state.size);
      next[cursor] = clamp(next[corner], Math.round(state[cursor]), next[corner] + state.size - 1);
    }
    return next;
  }

  /** The cursor moved by so many pixels, to the right and down; the shown part follows it. @param {State} state @param {number[]} by */
  function moved(state, by) {
    const next = { ...state };
    for (const [n, [corner, cursor]] of AXES.entries()) {
      next[cursor] = state[cursor] + by[n];
      next[corner] = clamp(next[cursor] - state.size + 1, state[corner], next[cursor]);
    }
    return within(next);
  }

  /**
   * Show the raster at another zoom or size; the image point at a share of the picture, across and down, stays there.
   * @param {State} state
   * @param {Partial<State>} changes
   */
  function zoomed(state, changes, share = [0.5, 0.5]) {
    const next = { ...state, ...changes };
    const ratio = side(next) / side(state);
    for (const [n, [corner, cursor]] of AXES.entries()) {
      next[corner] = (state[corner] + share[n] * state.size) * ratio - share[n] * next.size;
      next[cursor] = Math.floor((state[cursor] + 0.5) * ratio);
    }
    return within(next);
  }

  /** Where the cursor is, as shares of the picture, across and down. @param {State} state */
  const share_of_cursor = (state) => AXES.map(([corner, cursor]) => (state[cursor] - state[corner] + 0.5) / state.size);

  const MARK = "#sim?";

  /** @param {State} state */
  const fragment = (state) =>
    MARK +
    Object.entries(parameters)
      .filter(([name]) => name !== "h" || state.field === "own")
      .map(([name, p]) => `${name}=${name in OFFSETS ? share_at(state, name) : p.write(state[name])}`)
      .join("&");

  // A place in an address is a share of the raster, the same at any size; a whole number is one in pixels.
  /** @type {Record<string, number>} */
  const OFFSETS = { left: 0, top: 0, column: 0.5, row: 0.5 }; // of the point that is meant, in its pixel
  /** @param {State} state @param {string} name */
  const share_at = (state, name) => ((state[name] + OFFSETS[name]) / side(state)).toFixed(7);
  /** @param {State} state @param {string} name @param {string} text */
  const place_in = (state, name, text) =>
    /^0?\.\d+$/.test(text) ? Math.round(Number(text) * side(state) - OFFSETS[name]) : read(name, text);

  /** Return the state of a fragment, null if it is none of ours; throw if it is malformed. @param {string} text */
  function from_fragment(text) {
    if (!text.startsWith(MARK)) return null;
    /** @type {Record<string, string>} */
    const places = {};
    /** @type {Partial<State>} */
    const found = {};
    for (const [name, value] of new URLSearchParams(text.slice(MARK.length))) {
      if (!Object.hasOwn(parameters, name))
        throw new Error(`the address sets ${name.slice(0, 40)}, which is not a setting`);
      if (name in found || name in places) throw new Error(`the address sets ${name} twice`);
      if (name in OFFSETS) places[name] = value;
      else found[name] = read(name, value);
    }
    const state = zoomed(start(), found);
    for (const [name, value] of Object.entries(places)) state[name] = place_in(state, name, value);
    const is_pinned = "column" in places || "row" in places;
    return changed(is_pinned ? state : { ...within(state), left: state.left, top: state.top }, {});
  }

  /**
   * The part of the raster that is shown; in pixels that are so many times as large, along either side.
   * @param {State} state
   * @returns {Raster}
   */
  function crop(state, coarse = 1) {
    const [whole, wide, left, top] = [side(state), state.size, state.left, state.top].map((length) => length / coarse);
    return { width: whole, height: whole, left, top, wide, high: wide };
  }

  /** The scene's lights, the first where the lamp is; no colour where one is off. @param {State} state */
  const lights_of = ({ lights, lamp }) =>
    scene.lights.map(({ position, color }, n) => ({ position: n ? position : lamp, color: lights[n] ? color : null }));

  /** Whether a gradient of this name is taken by a step; else exactly, for the chapter's bump or the surface's. @param {string} name */
  const is_stepped = (name) => !["exact", "surface"].includes(name);

  /**
   * One line that prints the renderer's own record of the pixel under the cursor, by the difference and exactly.
   * @param {State} state
   */
  function python(state) {
    /** @param {ReturnType<typeof lights_of>[number]} light */
    const light = ({ position, color }) =>
      `Light((${position.join(", ")}), ${color ? `(${color.join(", ")})` : "None"})`;
    const all = state.lights.every(Boolean) && String(state.lamp) === String(place.start);
    const { ku, kv, beta, model, method, against } = state;
    const is_own = state.field === "own";
    const field = is_own
      ? `HeightField("own", "${state.h}"${has_seam(state) ? ", seam=True" : ""})`
      : `"${state.field}"`;
    const given = [`field=${field}`, `ku=${ku}`, `kv=${kv}`, `beta=${beta}`, `model="${model}"`];
    if (!state.ball) given.push("ball=False");
    if (!all) given.push(`lights=(${lights_of(state).map(light).join(", ")})`);
    const [other, by] = is_stepped(against)
      ? [against === method ? "" : `${against}, `, `, ${against}(${state.against_eps})`]
      : ["", ""];
    const second = against === "surface" ? 'Scene(**vars(s) | {"bump": "surface"})' : "s";
    const is_off = state.view === "by_lamp" && !state.lights[0];
    const slope = !by && !is_off && numbers[state.view];
    const slopes = slope ? `, derivatives=("${slope}",)` : "";
    const at = `${side(state)}, ${side(state)}, ${state.column}, ${state.row}`;
    return (
      `from renderer import ${is_own ? "HeightField, " : ""}${all ? "" : "Light, "}Scene, ${method}, ${other}pixel; s = Scene(${given.join(", ")}); ` +
      `print(pixel(s, ${at}, ${method}(${state.eps})), pixel(${second}, ${at}${by}${slopes}), sep="\\n")`
    );
  }

  /** What the renderer's own pictures say of how they were drawn. @param {State} state @param {boolean} is_numeric */
  function record_of(state, is_numeric) {
    const { ku, kv, beta, model, method, eps, against, against_eps, size, left, top } = state;
    const [name, step] = is_numeric ? [method, eps] : [against, against_eps];
    const own = { name: "own", expression: state.h, ...(has_seam(state) ? { seam: true } : {}) };
    const field = state.field === "own" ? own : state.field;
    const lights = lights_of(state);
    return {
      ...record,
      width: side(state),
      height: side(state),
      crop: [left, top, size, size],
      gradient: { ...record.gradient, ...(is_stepped(name) ? { name, eps: step } : {}) },
      scene: {
        ...record.scene,
        field,
        ku,
        kv,
        beta,
        model,
        lights,
        ball: Boolean(state.ball),
        bump: name === "surface" ? name : "chart"
      }
    };
  }

  return {
    record: record_of,
    parameters,
    start,
    changed,
    read,
    within,
    moved,
    zoomed,
    share_of_cursor,
    side,
    crop,
    fragment,
    from_fragment,
    python,
    FURTHEST
  };
}

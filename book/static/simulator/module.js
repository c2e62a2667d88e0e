// The compiled shader and kernels: their memory, and calls of them. What they compute is written in renderer/shader/shader.py
// and in proofs/; the numbers beside them, Simulator.data, in book/programs/simulator_module.py.
"use strict";

/**
 * Compile a program as the pages carry it; throw where the browser cannot.
 * @param {string} program
 */
async function compiled_program(program) {
  const bytes = await unpacked(program).arrayBuffer();
  if (typeof WebAssembly !== "object" || !WebAssembly.validate(bytes))
    throw new Error("this browser has no WebAssembly with vectors, SIMD");
  return WebAssembly.compile(bytes);
}

/** One module of one program or several. @param {SimulatorData} data @param {...WebAssembly.Module} programs */
async function simulator_module(data, ...programs) {
  const memory = new WebAssembly.Memory({ initial: 1 });
  /** @type {Record<string, WebAssembly.ModuleImports>} */
  const imports = { env: { __linear_memory: memory } };
  const instances = await Promise.all(programs.map((program) => WebAssembly.instantiate(program, imports)));
  /** @type {Record<string, Compiled>} */
  const exported = Object.assign({}, ...instances.map((instance) => instance.exports));
  Object.assign(imports.env, exported);
  const { eye, radius } = data.scene;
  const SURFACE = 3;
  const A = 1;
  const COLORS = ["red", "green", "blue"];
  const SLOPES = ["h_u", "h_v"];
  const PLANES = [...COLORS, ...SLOPES];
  const ANGLES = ["cos_theta", "sin_theta", "cos_phi", "sin_phi"];
  const CHART = ["u", "v"];
  const EXACT = { name: "exact" };
  const SURFACE_BUMP = { ...EXACT, bump: "surface", way: 0 }; // by slopes that are stored
  /** Of a difference of pictures: how many steps away each is, and its weight. @type {Record<string, number[][]>} */
  const STEPS = {
    central: [
      [1, 1 / 2],
      [-1, -1 / 2]
    ],
    forward: [
      [1, 1],
      [0, -1]
    ],
    central4: [
      [1, 2 / 3],
      [-1, -2 / 3],
      [2, -1 / 12],
      [-2, 1 / 12]
    ]
  };
  const PAGE = 2 ** 16;
  const CHUNK = 512;
  const MOST_COLUMNS = 512; // more than a kernel has, or a formula creases: each takes five of its operations
  let top = 64; // an address of 0 is none

  /** @param {number} bytes */
  function reserve(bytes) {
    const address = top;
    top += 16 * Math.ceil(bytes / 16);
    const missing = top - memory.buffer.byteLength;
    if (missing > 0) memory.grow(Math.ceil(missing / PAGE));
    return address;
  }

  // Views of memory are of no use any more once more of it has been reserved.
  /** @param {number} address @param {number} length */
  const floats = (address, length) => new Float64Array(memory.buffer, address, length);
  /** @param {number} address @param {number} length */
  const integers = (address, length) => new BigInt64Array(memory.buffer, address, length);

  const arguments_at = reserve(8 * Math.max(data.sloped.length, data.painting.length, 1 + MOST_COLUMNS));
  const counts_at = reserve(8 * data.counts);
  const scene_at = reserve(8 * Object.values(data.scenes)[0].scene.length);
  const lights_at = reserve(8 * data.light_size * data.scene.lights.length);
  const columns_at = Array.from({ length: MOST_COLUMNS }, () => reserve(8 * CHUNK));
  const numbers_at = reserve(8 * data.numbers.length);
  const { srgb, sizes, ...palettes } = data.tables;
  const WHITE = 255;
  /** @type {Record<string, { level_at: number, threshold: number }>} */
  const tables = {
    srgb: table(
      srgb.thresholds,
      float64s(srgb.cells + 1, (n) => n / srgb.cells)
    ),
    sizes: table(sizes.thresholds, beginnings(sizes.bits))
  };
  const palette_at = Object.fromEntries(
    Object.entries(palettes).map(([name, colors]) => [name, put(Uint32Array.from(colors))])
  );
  const beginning = top;

  /** @param {Uint8Array | Uint32Array | Float64Array} array */
  function put(array) {
    const address = reserve(array.byteLength);
    new Uint8Array(memory.buffer, address).set(new Uint8Array(array.buffer));
    return address;
  }

  /** The numbers that are not negative and begin with each combination of so many upper bits. @param {number} bits */
  function beginnings(bits) {
    const words = new Uint32Array(2 ** bits);
    for (let n = 0; n < words.length / 2; n++) words[2 * n + 1] = n << (32 - bits);
    return new Float64Array(words.buffer);
  }

  /**
   * The level at which each cell of numbers begins, and where the levels do.
   * @param {number[]} thresholds
   * @param {Float64Array} cells
   */
  function table(thresholds, cells) {
    let level = 0;
    const level_at = Uint8Array.from(cells, (number) => {
      while (level < WHITE && number >= thresholds[level]) level++;
      return level;
    });
    return { level_at: put(level_at), threshold: put(Float64Array.of(0, ...thresholds, Infinity)) };
  }

  /** @param {Compiled} run @param {number[]} numbers */
  function call(run, numbers) {
    integers(arguments_at, numbers.length).set(numbers.map(BigInt));
    run(arguments_at);
  }

  /** @param {string[]} names @param {Record<string, number>} given */
  const in_order = (names, given) => names.map((name) => given[name] ?? 0);

  /**
   * What a function over points makes of arrays, and of numbers that stand for arrays: the list of its outputs.
   * @type {OverPoints}
   */
  function over_points(run, [taken, made], ...inputs) {
    const [{ length } = { length: 1 }] = inputs.filter((input) => typeof input !== "number");
    const outputs = Array.from({ length: made }, () => new Float64Array(length));
    const addresses = columns_at.slice(0, taken + made);
    const columns = addresses.map((address) => floats(address, CHUNK));
    for (let start = 0; start < length; start += CHUNK) {
      const count = Math.min(CHUNK, length - start);
      for (const [n, input] of inputs.entries()) {
        if (typeof input === "number") columns[n].fill(input);
        else columns[n].set(input.subarray(start, start + count));
      }
      call(run, [count, ...addresses]);
      for (const [n, output] of outputs.entries()) output.set(columns[taken + n].subarray(0, count), start);
    }
    return outputs;
  }

  /** @param {string} name @param {...(number | Float64Array)} inputs */
  const kernel_over = (name, ...inputs) => over_points(exported[name], data.kernels[name], ...inputs);

  /** What a kernel makes of numbers: the list of its outputs. @param {string} name @param {...number} inputs */
  const kernel = (name, ...inputs) => kernel_over(name, ...inputs).map(first_of);

  /** @param {Raster} raster */
  function image_points({ width, height, left, top, wide, high }) {
    const [half] = kernel("image_extent", eye, radius);
    const columns = float64s(wide, (n) => left + n);
    const rows = float64s(high, (n) => top + n);
    return [kernel_over("image_x", columns, width, height, half)[0], kernel_over("image_y", rows, height, half)[0]];
  }

  /** Return what says where an image point is in a raster, in pixels from its corner. @param {Raster} raster */
  function placing_in(raster) {
    const [[x0, x1], [y0, y1]] = image_points({ ...raster, wide: 2, high: 2 });
    /** @param {number} x @param {number} y @returns {[number, number]} */
    return (x, y) => [(x - x0) / (x1 - x0) + 0.5, (y - y0) / (y1 - y0) + 0.5];
  }

  /** How each picture of a state takes its gradient. @param {State} state @returns {Record<string, Method>} */
  const methods_of = ({ method, eps, against, against_eps }) => ({
    numeric: { name: method, eps },
    symbolic:
      against === EXACT.name ? EXACT : against === "surface" ? SURFACE_BUMP : { name: against, eps: against_eps }
  });

  let made_of = "";
  /** @type {OwnField | null} */
  let own = null;
  /** The reader's own field, where a state wears it, else null. @param {SceneState} state */
  function own_of(state) {
    if (state.field !== "own") return null;
    const key = [state.h, state.ku, state.kv].join();
    if (key !== made_of) own = own_field(state, data.emitted, imports, over_points);
    made_of = key;
    return own;
  }

  /** Whether a pixel of this chamber shows A. @param {number} code */
  const is_on_a = (code) => (code & SURFACE) === A;

  /** The numbers by which h depends on u and on v, or null. @param {SceneState} state */
  const wave_numbers = ({ field, ku, kv }) =>
    `wave_numbers_${field}` in data.kernels ? kernel(`wave_numbers_${field}`, ku, kv) : null;

  /** As renderer.shader.gradients.algebraic_powers. @param {SceneState} state */
  function algebraic_powers(state) {
    const [a, b] = wave_numbers(state) ?? [1, 1];
    if (a % 2 || b % 1 || Math.max(Math.abs(a), Math.abs(b)) > data.max_algebraic) return null;
    return [Math.trunc(a) / 2, Math.trunc(b)];
  }

  /**
   * As renderer.shader.numbers: what a state changes of the scene's numbers, and the numbers of the lights that are on.
   * @param {SceneState} state
   * @param {Method} method
   */
  function numbers_of(state, { name, eps = 0, way: given }) {
    const { ku, kv, beta } = state;
    const is_exact = name === "exact";
    const powers = is_exact ? algebraic_powers(state) : null;
    const [power_u, power_v] = powers ?? [0, 0];
    const way = is_exact ? (powers ? "algebraic" : "general") : name;
    const { index, power } = data.models[state.model];
    const changed = {
      way: given ?? data.fields[state.field]?.ways[beta === 0 ? "flat" : way] ?? 0,
      model: index,
      power,
      ku,
      kv,
      beta,
      eps,
      power_u: Math.abs(power_u),
      power_v: Math.abs(power_v),
      turn_u: Math.sign(power_u) || 1,
      turn_v: Math.sign(power_v) || 1
    };
    const { scene, lights: standing } = data.scenes[[state.ball, ...state.lights].map(Number).join("")];
    const lights = has_moved(state) && state.lights[0] ? [moved(state, standing[0]), ...standing.slice(1)] : standing;
    const numbers = Float64Array.from(scene);
    for (const [key, number] of Object.entries(changed)) numbers[data.offsets[key]] = number;
    return { scene: numbers, lights };
  }

  /** Whether the lamp, the first light, is not where the scene has it. @param {SceneState} state */
  const has_moved = ({ lamp = data.scene.lights[0].position }) =>
    lamp.some((coordinate, axis) => coordinate !== data.scene.lights[0].position[axis]);

  /** The numbers of the lamp elsewhere: its shadows may be anywhere, those of a sphere that is there. @param {SceneState} state @param {number[]} numbers */
  function moved({ lamp = [0, 0, 0], ball }, numbers) {
    const first = numbers.length - data.shadows;
    const boxes = numbers.slice(first).map((end, n) => (ball || n < 4 ? (n % 2 ? Infinity : -Infinity) : end));
    return [...lamp, ...numbers.slice(3, first), ...boxes];
  }

  /**
   * Draw on a stage, into the planes whose addresses a target has.
   * @param {string} what
   * @param {SceneState} state
   * @param {Method} method
   * @param {Ground} stage
   * @param {Record<string, number>} [target]
   */
  function draw(what, state, method, stage, target) {
    const { scene, lights } = numbers_of(state, method);
    floats(scene_at, scene.length).set(scene);
    floats(lights_at, data.light_size * lights.length).set(lights.flat());
    const everywhere = !["draw_a", "draw_own", "draw_chart"].includes(what);
    const given = {
      ...stage.addresses,
      ...on_rows(stage, everywhere),
      ...target,
      scene: scene_at,
      lights: lights_at,
      light_count: lights.length,
      counts: counts_at
    };
    call(exported[what], in_order(what === "draw_sloped" ? data.sloped : data.arguments, given));
  }

  /** What a drawing or a painting is told of the rows: all of them, or where A is. @param {Ground} stage */
  const on_rows = ({ raster, pitch, addresses }, everywhere = false) => ({
    first_row: 0,
    last_row: raster.high,
    pitch,
    columns: everywhere ? addresses.everywhere : addresses.columns_of_a
  });

  /**
   * The rows of a plane without what fills up their last group of pixels.
   * @template {Uint8Array | Float64Array} Plane
   * @param {Plane} plane
   * @param {Ground} stage
   */
  function rows(plane, { pitch, raster: { wide, high } }) {
    const whole = /** @type {Plane} */ (plane.slice(0, wide * high));
    for (let row = 0; row < high; row++) whole.set(plane.subarray(row * pitch, row * pitch + wide), row * wide);
    return whole;
  }

  /**
   * The chamber of every pixel, computed anew into a plane.
   * @param {SceneState} state
   * @param {Ground} stage
   * @param {number} code
   */
  function chambers_of(state, stage, code) {
    draw("draw_chambers", state, EXACT, stage, { code });
    return rows(new Uint8Array(memory.buffer, code, stage.pitch * stage.raster.high), stage);
  }

  /**
   * A state's chambers on a raster, which pixels are A's, and where these are on the chart: what no bump changes (theorem
   * bump_moves_no_boundary). An earlier stage is gone. Where `wide` is a whole number of groups, `at` holds for pictures
   * too.
   * @param {SceneState} state
   * @param {Raster} raster
   * @returns {Stage}
   */
  function make_stage(state, raster) {
    top = beginning;
    const { wide, high } = raster;
    const pitch = data.lanes * Math.ceil(wide / data.lanes);
    const [x, y] = image_points(raster);
    const planes = [...ANGLES, ...CHART].map((name) => [name, reserve(8 * pitch * high)]);
    /** @type {Record<string, number>} */
    const addresses = {
      x: reserve(8 * pitch),
      y: reserve(8 * high),
      code: reserve(pitch * high),
      code_again: reserve(pitch * high),
      everywhere: reserve(16 * high),
      columns_of_a: reserve(16 * high),
      ...Object.fromEntries(planes)
    };
    const ground = { raster, pitch, addresses };
    floats(addresses.x, pitch).fill(NaN).set(x);
    floats(addresses.y, high).set(y);
    integers(addresses.everywhere, 2 * high).set(Array.from({ length: 2 * high }, (_, n) => BigInt(n % 2 && wide)));
    const codes = chambers_of(state, ground, addresses.code);
    const ends = integers(addresses.columns_of_a, 2 * high).fill(0n);
    /** @type {number[]} */
    const at = [];
    for (let row = 0; row < high; row++) {
      const before = at.length;
      for (let column = 0; column < wide; column++) {
        if (is_on_a(codes[row * wide + column])) at.push(row * pitch + column);
      }
      if (at.length === before) continue;
      ends.set([BigInt(at[before] - row * pitch), BigInt(at[at.length - 1] + 1 - row * pitch)], 2 * row);
    }
    draw("draw_chart", state, EXACT, ground);
    return {
      ...ground,
      codes,
      count: at.length,
      at: Int32Array.from(at),
      rows: at.length ? [Math.floor(at[0] / pitch), Math.floor(at[at.length - 1] / pitch) + 1] : [0, 0],
      targets: {}
    };
  }

  /** The stage of the one pixel that is under a state's cursor. @param {State} state @param {Raster} raster of all pixels */
  const stage_of_pixel = (state, raster) =>
    make_stage(state, { ...raster, left: state.column, top: state.row, wide: 1, high: 1 });

  /** The address of a stage's plane of a name. @param {Stage} stage @param {string} name @param {string} plane */
  function place(stage, name, plane) {
    const key = `${name} ${plane}`;
    stage.targets[key] ??= reserve((plane === "pixels" ? 4 : 8) * stage.pitch * stage.raster.high);
    return stage.targets[key];
  }

  /** @param {Stage} stage @param {string} name */
  const target = (stage, name, planes = PLANES, before = "") =>
    Object.fromEntries(planes.map((plane) => [before + plane, place(stage, name, plane)]));

  /**
   * Paint the pixels of a name, on all rows or where A is; return {largest, squares} of a difference.
   * @param {string} painter
   * @param {Stage} stage
   * @param {string} name
   * @param {Painting} options
   */
  function paint(painter, stage, name, options) {
    const { whole = false, of = name, other = name, table = "srgb", palette = "grey", gain = 1 } = options;
    const given = {
      ...target(stage, of, COLORS),
      ...target(stage, other, COLORS, "other_"),
      ...tables[table],
      ...on_rows(stage, whole),
      pixels: place(stage, name, "pixels"),
      plane: place(stage, "view", "plane"),
      palette: palette_at[palette],
      numbers: numbers_at
    };
    const numbers = floats(numbers_at, data.numbers.length).fill(0);
    const [gain_at, largest, squares] = ["gain", "largest", "squares"].map((key) => data.numbers.indexOf(key));
    numbers[gain_at] = gain;
    call(exported[painter], in_order(data.painting, given));
    return { largest: numbers[largest], squares: numbers[squares] };
  }

  /**
   * Put numbers of A's pixels, one after another, into the plane of what is viewed, 0 elsewhere; or those of all pixels.
   * @param {Stage} stage
   * @param {Float64Array} values
   */
  function fill(stage, values, whole = false) {
    const plane = plane_at(stage, place(stage, "view", "plane")).fill(0);
    const { pitch, raster, at } = stage;
    if (whole)
      for (let i = 0; i < values.length; i++)
        plane[i + Math.floor(i / raster.wide) * (pitch - raster.wide)] = values[i];
    else for (let n = 0; n < at.length; n++) plane[at[n]] = values[n];
  }

  /** A view of the painted bytes of some rows. @param {Stage} stage @param {string} name @param {[number, number]} rows */
  const bytes = (stage, name, [first, last]) =>
    new Uint8ClampedArray(
      memory.buffer,
      place(stage, name, "pixels") + 4 * stage.pitch * first,
      4 * stage.pitch * (last - first)
    );

  /** Put a painted picture into a canvas. @param {HTMLCanvasElement} canvas @param {Stage} stage @param {string} name */
  function put_into(canvas, stage, name, left = 0) {
    const image = new ImageData(bytes(stage, name, [0, stage.raster.high]), stage.pitch);
    canvas.getContext("2d")?.putImageData(image, left, 0);
  }

  /**
   * Draw A, all of it or some rows.
   * @param {SceneState} state
   * @param {Method} method
   * @param {Stage} stage
   * @param {string} name
   * @param {Record<string, number>} [rows]
   */
  function draw_a(state, method, stage, name, rows) {
    const own = own_of(state);
    const planes = target(stage, name);
    const is_stored = own || method.bump;
    if (is_stored && !rows?.first_row) {
      const of_h = own ? own_slopes(own, method, ...points_of_a(stage)) : gradients(state, stage);
      const slopes = tilts(method, stage, of_h);
      for (const [n, plane] of SLOPES.entries()) {
        const into = plane_at(stage, planes[plane]);
        for (let i = 0; i < stage.count; i++) into[stage.at[i]] = slopes[n][i];
      }
    }
    draw(is_stored ? "draw_own" : "draw_a", state, method, stage, { ...planes, ...rows });
  }

  /** The slopes by which a bump tilts the normal: the chart's, or the surface's own. @param {Method} method @param {Stage} stage @param {Float64Array[]} slopes */
  const tilts = ({ bump }, stage, slopes) =>
    bump ? kernel_over("surface_slopes", angles_of(stage)[3], radius, ...slopes) : slopes;

  /** @param {Method} method @param {Float64Array} u @param {Float64Array} v */
  function points_taken({ name, eps = 0 }, u, v) {
    const places = kernel_over(`points_of_${name}`, u, v, eps);
    return Array.from({ length: places.length / 2 }, (_, n) => [places[2 * n], places[2 * n + 1]]);
  }

  /**
   * h_u and h_v of the reader's own field at points, exactly or by a difference.
   * @param {OwnField} own @param {Method} method @param {Float64Array} u @param {Float64Array} v
   */
  function own_slopes(own, method, u, v) {
    if (method.name === "exact") return own.gradient(u, v);
    const heights = points_taken(method, u, v).map(([at_u, at_v]) => own.height(at_u, at_v)[0]);
    return kernel_over(`slopes_of_${method.name}`, u, v, method.eps ?? 0, ...heights);
  }

  /** h at points of the chart. @param {SceneState} state @param {Float64Array} u @param {Float64Array} v */
  const height = (state, u, v) =>
    own_of(state)?.height(u, v)[0] ?? kernel_over(`height_${state.field}`, u, v, state.ku, state.kv)[0];

  /** 1 where a point lies on a crease, else 0. @param {SceneState} state @param {Float64Array} sin_phi @param {Float64Array} u @param {Float64Array} v */
  function kinks(state, sin_phi, u, v) {
    const own = own_of(state);
    if (!own) return kernel_over(`kink_${state.field}`, sin_phi, u, v, state.ku, state.kv)[0];
    const switches = own.switches(u, v);
    return float64s(u.length, (i) => Number(switches.some((plane) => plane[i] === 0)));
  }

  /** 1 where a difference's points lie on both sides of a crease, else 0. @param {SceneState} state @param {Method} method @param {Float64Array} u @param {Float64Array} v */
  function straddles(state, method, u, v) {
    const own = own_of(state);
    if (!own) return kernel_over(`straddling_${state.field}`, u, v, state.ku, state.kv, method.eps ?? 0)[0];
    const sides = points_taken(method, u, v).map(([at_u, at_v]) => own.switches(at_u, at_v));
    /** @param {number} i */
    const parts = (i) => sides.some((planes) => planes.some((plane, n) => plane[i] * sides[0][n][i] < 0));
    return float64s(u.length, (i) => Number(parts(i)));
  }

  /** 1 where the next pixel to the right or below is on the other side of a crease of the reader's own field. @param {State} state @param {Stage} stage */
  function own_creases(state, stage) {
    const planes = own_of(state)?.switches(...points_of_a(stage)) ?? [];
    const index = new Int32Array(stage.pitch * (stage.raster.high + 1)).fill(-1);
    for (const [n, i] of stage.at.entries()) index[i] = n;
    return float64s(stage.count, (n) => {
      const others = [index[stage.at[n] + 1], index[stage.at[n] + stage.pitch]].filter((other) => other >= 0);
      return Number(planes.some((plane) => others.some((other) => plane[n] * plane[other] < 0)));
    });
  }

  /** @param {SceneState} state @param {Stage} stage @param {string} name */
  const draw_elsewhere = (state, stage, name) => draw("draw_elsewhere", state, EXACT, stage, target(stage, name));

  /**
   * A whole picture, three planes, as the renderer's frame.rgb; where its name has been drawn before, a step from that.
   * @param {SceneState} state
   * @param {Method} method
   * @param {Stage} stage
   */
  function render(state, method, stage, name = "picture") {
    draw_elsewhere(state, stage, name);
    draw_a(state, method, stage, name);
    return colors_of(stage, name);
  }

  /**
   * Draw and paint whole pictures by two methods, which may change the scene, and their difference; return both's colours.
   * @param {SceneState} state
   * @param {Record<string, Method & { scene?: Partial<SceneState> }>} methods
   * @param {Stage} stage
   */
  function draw_pair(state, methods, stage) {
    const colors = Object.entries(methods).map(([name, method]) => {
      const planes = render({ ...state, ...method.scene }, method, stage, name);
      paint("paint_colors", stage, name, { whole: true });
      return planes;
    });
    const pair = { whole: true, of: "numeric", other: "symbolic", table: "sizes", palette: "inferno" };
    paint("paint_difference_logarithmic", stage, "difference", pair);
    return colors;
  }

  /** The colours of a name, three planes. @param {Stage} stage @param {string} name */
  const colors_of = (stage, name) => COLORS.map((color) => rows(plane_at(stage, place(stage, name, color)), stage));

  /**
   * A whole picture by the machine that encloses: its colours, how far each is off at most, and where it is open.
   * @param {SceneState} state
   * @param {Method} method
   * @param {Stage} stage
   */
  function draw_bounded(state, method, stage) {
    const { left, top, wide, high, width, height } = stage.raster;
    const of_x = kernel_over(
      "bound_of_x",
      float64s(wide, (n) => left + n),
      width,
      height,
      eye,
      radius
    );
    const of_y = kernel_over(
      "bound_of_y",
      float64s(high, (n) => top + n),
      height,
      eye,
      radius
    );
    const open = place(stage, "open", "plane");
    const bounds = COLORS.map((color) => [`${color}_bound`, place(stage, "bound", color)]);
    const [x_bound, y_bound] = [Float64Array.of(...of_x[0], 0), of_y[0]].map(put);
    draw("draw_bounded", state, method, stage, {
      ...target(stage, "bounded", COLORS),
      ...Object.fromEntries(bounds),
      x_bound,
      y_bound,
      scene_bounds: put(Float64Array.from(data.scene_bounds ?? [])),
      open
    });
    return {
      colors: colors_of(stage, "bounded"),
      bounds: colors_of(stage, "bound"),
      open: rows(new Uint8Array(memory.buffer, open, stage.pitch * high), stage)
    };
  }

  /**
   * The slope of every colour of a picture by the number that is viewed: exactly, or by a difference of whole pictures.
   * Three planes; null by k_u of the reader's own field, or of the surface's bump.
   * @param {State} state
   * @param {Stage} stage
   * @param {Method} method
   */
  function picture_slopes(state, stage, method) {
    const by_ku = state.view === "by_ku";
    if (method.name !== EXACT.name) return difference_of_pictures(state, stage, method);
    if (by_ku && (state.field === "own" || method.bump)) return null;
    draw_a({ ...state, beta: 1 }, method, stage, "gradient");
    const views = Object.keys(data.by);
    const planes = views.flatMap((view, n) =>
      COLORS.map((color) => [`${color}_slope_${n}`, place(stage, view === state.view ? "slope" : "unseen", color)])
    );
    const way = by_ku ? data.fields[state.field].sloped : Object.keys(data.fields).length;
    const into = { ...target(stage, "gradient"), ...Object.fromEntries(planes) };
    draw("draw_sloped", state, { ...EXACT, way }, stage, into);
    return colors_of(stage, "slope");
  }

  /** @param {State} state @param {Stage} stage @param {Method} method */
  function difference_of_pictures(state, stage, { name, eps = 0 }) {
    const code = stage.addresses.code_again;
    const number = state.view.slice(3);
    const [x, y, z] = state.lamp;
    /** @type {Float64Array[]} */
    let sums = [];
    for (const [steps, weight] of STEPS[name]) {
      const step = steps * eps;
      const beside = { ...state, [number]: number === "lamp" ? [x + step, y, z] : state[number] + step };
      chambers_of(beside, stage, code);
      draw("draw_elsewhere", beside, EXACT, stage, { ...target(stage, "beside"), code });
      draw_a(beside, EXACT, stage, "beside", { code });
      sums = colors_of(stage, "beside").map((plane, c) =>
        plane.map((color, i) => (sums[c]?.[i] ?? 0) + weight * color)
      );
    }
    return sums.map((plane) => plane.map((sum) => sum / eps));
  }

  /** @param {Ground} stage @param {number} address */
  const plane_at = ({ pitch, raster }, address) => floats(address, pitch * raster.high);

  /** The numbers of a plane on A's pixels, one after another. @param {Stage} stage @param {number} address */
  function on_a(stage, address) {
    const plane = plane_at(stage, address);
    return new Float64Array(stage.at).map((i) => plane[i]);
  }

  /** @param {Stage} stage */
  const angles_of = (stage, names = ANGLES) => names.map((name) => on_a(stage, stage.addresses[name]));
  /** @param {Stage} stage @returns {[Float64Array, Float64Array]} */
  const points_of_a = (stage) => /** @type {any} */ ((stage.points ??= angles_of(stage, CHART)));

  /**
   * h_u and h_v on A's pixels, whether they are drawn with a bump or not.
   * @param {SceneState} state
   * @param {Stage} stage
   * @param {Method} method
   */
  function gradients(state, stage, method = EXACT) {
    draw_a({ ...state, beta: 1 }, { ...method, bump: undefined }, stage, "gradient");
    return slopes_of(stage, "gradient");
  }

  /** @param {Stage} stage @param {string} name */
  const slopes_of = (stage, name) => SLOPES.map((plane) => on_a(stage, place(stage, name, plane)));

  /**
   * The kernel that bounds the error of a method's slopes by theorem: (u, v, ku, kv, ε) → the bound, the number of its
   * largest term, the bounds of h_u and of h_v, of which it is the larger. Null where no theorem covers the field.
   * @param {{ field: string, method: string }} state
   */
  const bounds_of = ({ field, method }) =>
    `bounds_${field}_${method}` in data.kernels ? `bounds_${field}_${method}` : null;

  /**
   * {a, b, level} of the lines a u + b v = level on which a crease factor sinpi(a u + b v + c) is zero (theorem kink_loci).
   * @param {SceneState} state
   */
  function crease_lines({ field, ku, kv }) {
    const rates = data.fields[field]?.creases ? kernel(`creases_${field}`, ku, kv) : [];
    const lines = [];
    for (let n = 0; n < rates.length; n += 3) {
      const [a, b, c] = rates.slice(n);
      const ends = [c, c + a, c + b, c + a + b];
      const last = Math.floor(Math.max(...ends));
      for (let whole = Math.ceil(Math.min(...ends)); whole <= last && (a || b); whole++)
        lines.push({ a, b, level: whole - c });
    }
    return lines;
  }

  /**
   * How many of A's pixels the bump turns to the other side of each light that is on.
   * @param {SceneState} state
   * @param {Stage} stage
   * @param {string} name
   */
  function turned(state, stage, name) {
    const angles = angles_of(stage);
    const slopes = slopes_of(stage, name);
    const point = kernel_over("point_on_a", ...angles, radius);
    const normals = [state.beta, 0].map((beta) => kernel_over("bumped_normal", ...angles, ...slopes, beta));
    const positions = data.scene.lights.map(({ position }, n) => (n ? position : (state.lamp ?? position)));
    return positions
      .filter((_, n) => state.lights[n])
      .map((position) => {
        const [bumped, plain] = normals.map(
          (normal) => kernel_over("light_cosine", ...point, ...position, ...normal)[0]
        );
        return bumped.reduce((count, mu, i) => count + Number(mu > 0 !== plain[i] > 0), 0);
      });
  }

  /**
   * What renderer.pixel records, for the pixel of the whole raster that is under the cursor.
   * @param {State} state
   * @param {Method} method
   * @param {Raster} raster
   * @returns {PixelRecord}
   */
  function pixel(state, method, raster) {
    const stage = stage_of_pixel(state, raster);
    const surface = ["none", "A", "B", "floor"][stage.codes[0] & SURFACE];
    const rgb = render(state, method, stage).map(first_of);
    const slope = state.view in data.by && picture_slopes(state, stage, method)?.map(first_of);
    const record = { column: state.column, row: state.row, surface, rgb, ...(slope && { slope }) };
    if (surface === "none") return record;
    if (surface === "A") return { ...record, ...record_on_a(state, method, stage) };
    const [x, y] = image_points(stage.raster).map(first_of);
    const ball = [...data.scene.ball_center, data.scene.ball_radius];
    const six = surface === "B" ? kernel("normal_of_b", x, y, eye, ...ball) : kernel("normal_of_floor", x, y);
    return { ...record, point: six.slice(0, 3), normal: six.slice(3) };
  }

  /** @param {Float64Array} numbers */
  const first_of = ([number]) => number;

  /** @param {SceneState} state @param {Method} method @param {Stage} stage */
  function record_on_a(state, method, stage) {
    const { beta } = state;
    const points = points_of_a(stage);
    const [u, v] = points.map(first_of);
    const angles = angles_of(stage).map(first_of);
    const slopes = gradients(state, stage, method);
    const tilt = tilts(method, stage, slopes).map(first_of);
    const gradient = slopes.map(first_of);
    const [theta, phi] = kernel("chart_radians", u, v);
    const [h] = height(state, ...points);
    const [kink] = kinks(state, angles_of(stage)[3], ...points);
    const [straddling] = method.eps ? straddles(state, method, ...points) : [0];
    return {
      point: kernel("point_on_a", ...angles, radius),
      normal: kernel("bumped_normal", ...angles, ...tilt, beta),
      gradient,
      u,
      v,
      h,
      theta,
      phi,
      kink: kink === 1,
      straddling: straddling === 1
    };
  }

  const radius_of_a = Math.sqrt(Object.values(data.scenes)[0].scene[data.offsets.reach_of_a]); // on the image
  return {
    kernel,
    kernel_over,
    methods_of,
    is_on_a,
    image_points,
    placing_in,
    radius_of_a,
    wave_numbers,
    make_stage,
    stage_of_pixel,
    chambers_of,
    draw_a,
    draw_elsewhere,
    draw_bounded,
    picture_slopes,
    paint,
    fill,
    bytes,
    put_into,
    render,
    draw_pair,
    chart: points_of_a,
    own_of,
    kinks,
    straddles,
    own_creases,
    angles_of,
    gradients,
    bounds_of,
    crease_lines,
    turned,
    pixel
  };
}

// The compiled shader and kernels: their memory, and calls of them. What they compute is written in renderer/shader/shader.py
// and in proofs/; the numbers beside them, Simulator.data, in book/simulator_module.py.
"use strict";

// Compile the program of compiled.js; throw where the browser cannot.
Simulator.compiled = async function (program) {
  const packed = new Blob([Uint8Array.from(atob(program), (letter) => letter.charCodeAt(0))]);
  const bytes = await new Response(packed.stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
  if (typeof WebAssembly !== "object" || !WebAssembly.validate(bytes)) throw new Error("this browser has no WebAssembly with vectors, SIMD");
  return WebAssembly.compile(bytes);
};

Simulator.module = async function (data, compiled) {
  const memory = new WebAssembly.Memory({ initial: 1 });
  const { exports } = await WebAssembly.instantiate(compiled, { env: { __linear_memory: memory } });
  const { eye, radius } = data.scene, SURFACE = 3, A = 1, COLORS = ["red", "green", "blue"], PLANES = [...COLORS, "h_u", "h_v"], ANGLES = ["cos_theta", "sin_theta", "cos_phi", "sin_phi"];
  const PAGE = 2 ** 16, CHUNK = 512, MOST_COLUMNS = Math.max(...Object.values(data.kernels).map(([taken, made]) => taken + made));
  let top = 64; // an address of 0 is none

  function reserve(bytes) {
    const address = top, missing = (top += 16 * Math.ceil(bytes / 16)) - memory.buffer.byteLength;
    if (missing > 0) memory.grow(Math.ceil(missing / PAGE));
    return address;
  }

  // A view is of no use any more once memory has been reserved.
  const floats = (address, length) => new Float64Array(memory.buffer, address, length);
  const arguments_at = reserve(8 * Math.max(data.arguments.length, data.painting.length, 1 + MOST_COLUMNS)), counts_at = reserve(8 * data.counts);
  const scene_at = reserve(8 * Object.values(data.scenes)[0].scene.length), lights_at = reserve(8 * data.light_size * data.scene.lights.length);
  const columns_at = Array.from({ length: MOST_COLUMNS }, () => reserve(8 * CHUNK)), numbers_at = reserve(8 * data.numbers.length);
  const { srgb, sizes, ...palettes } = data.tables, WHITE = 255;
  const tables = { srgb: table(srgb.thresholds, Float64Array.from({ length: srgb.cells + 1 }, (_, n) => n / srgb.cells)), sizes: table(sizes.thresholds, beginnings(sizes.bits)) };
  const palette_at = Object.fromEntries(Object.entries(palettes).map(([name, colors]) => [name, put(Uint32Array.from(colors))])), beginning = top;

  function put(array) {
    const address = reserve(array.byteLength);
    new array.constructor(memory.buffer, address, array.length).set(array);
    return address;
  }

  // The numbers that are not negative and begin with each combination of so many upper bits.
  function beginnings(bits) {
    const words = new Uint32Array(2 ** bits);
    for (let n = 0; n < words.length / 2; n++) words[2 * n + 1] = n << (32 - bits);
    return new Float64Array(words.buffer);
  }

  // The level at which each cell of numbers begins, and where the levels do.
  function table(thresholds, cells) {
    let level = 0;
    const level_at = Uint8Array.from(cells, (number) => {
      while (level < WHITE && number >= thresholds[level]) level++;
      return level;
    });
    return { level_at: put(level_at), threshold: put(Float64Array.of(0, ...thresholds, Infinity)) };
  }

  function call(name, numbers) {
    new BigInt64Array(memory.buffer, arguments_at, numbers.length).set(numbers.map(BigInt));
    exports[name](arguments_at);
  }

  // What a kernel makes of numbers and arrays: its outputs, numbers where it was given numbers alone.
  function kernel(name, ...inputs) {
    const [taken, made] = data.kernels[name], arrays = inputs.filter((input) => typeof input !== "number");
    const length = arrays.length ? arrays[0].length : 1, outputs = Array.from({ length: made }, () => new Float64Array(length));
    for (let start = 0; start < length; start += CHUNK) {
      const count = Math.min(CHUNK, length - start), columns = columns_at.map((address) => floats(address, count));
      inputs.forEach((input, n) => (typeof input === "number" ? columns[n].fill(input) : columns[n].set(input.subarray(start, start + count))));
      call(name, [count, ...columns_at.slice(0, taken + made)]);
      outputs.forEach((output, n) => output.set(columns[taken + n], start));
    }
    const found = arrays.length ? outputs : outputs.map(([number]) => number);
    return made === 1 ? found[0] : found;
  }

  const range = (start, count) => Float64Array.from({ length: count }, (_, n) => start + n);

  function image_points({ width, height, left, top, wide, high }) {
    const half = kernel("image_extent", eye, radius);
    return [kernel("image_x", range(left, wide), width, height, half), kernel("image_y", range(top, high), height, half)];
  }

  // The numbers by which h depends on u and on v, or null.
  const wave_numbers = ({ field, ku, kv }) => (`wave_numbers_${field}` in data.kernels ? kernel(`wave_numbers_${field}`, ku, kv) : null);

  // As renderer.shader.gradients.algebraic_powers.
  function algebraic_powers(state) {
    const [a, b] = wave_numbers(state) || [1, 1];
    return a % 2 || b % 1 || Math.max(Math.abs(a), Math.abs(b)) > data.max_algebraic ? null : [Math.trunc(a) / 2, Math.trunc(b)];
  }

  // As renderer.shader.numbers: what a state changes of the scene's numbers, and the numbers of the lights that are on.
  function numbers_of(state, { name, eps }) {
    const powers = name === "exact" ? algebraic_powers(state) : null, [power_u, power_v] = powers || [0, 0];
    const way = state.beta === 0 ? "flat" : name !== "exact" ? name : powers ? "algebraic" : "general";
    const { index, power } = data.models[state.model], { ku, kv, beta } = state;
    const changed = { way: data.fields[state.field].ways[way], model: index, power, ku, kv, beta, eps: eps || 0,
      power_u: Math.abs(power_u), power_v: Math.abs(power_v), turn_u: power_u < 0 ? -1 : 1, turn_v: power_v < 0 ? -1 : 1 };
    const { scene, lights } = data.scenes[[state.ball, ...state.lights].map(Number).join("")], numbers = Float64Array.from(scene);
    for (const [key, number] of Object.entries(changed)) numbers[data.offsets[key]] = number;
    return { scene: numbers, lights };
  }

  // Draw on a stage, into the planes whose addresses a target has.
  function draw(what, state, method, stage, target = {}) {
    const { scene, lights } = numbers_of(state, method), { high } = stage.raster;
    floats(scene_at, scene.length).set(scene);
    floats(lights_at, data.light_size * lights.length).set(lights.flat());
    const columns = ["draw_chambers", "draw_elsewhere"].includes(what) ? stage.everywhere : stage.columns_of_a;
    const given = { ...stage, ...target, columns, first_row: 0, last_row: high, scene: scene_at, lights: lights_at, light_count: lights.length, counts: counts_at };
    call(what, data.arguments.map((name) => given[name] ?? 0));
  }

  // The rows of a plane without what fills up their last group of pixels.
  function rows(plane, { pitch, raster: { wide, high } }) {
    const whole = new plane.constructor(wide * high);
    for (let row = 0; row < high; row++) whole.set(plane.subarray(row * pitch, row * pitch + wide), row * wide);
    return whole;
  }

  // The chamber of every pixel, computed anew.
  function chambers_of(state, stage, code) {
    draw("draw_chambers", state, { name: "exact" }, { ...stage, code });
    return rows(new Uint8Array(memory.buffer, code, stage.pitch * stage.raster.high), stage);
  }

  // A state's chambers on a raster, which pixels are A's, and where these are on the chart: what no bump changes (theorem
  // bump_moves_no_boundary). An earlier stage is gone. Where `wide` is a whole number of groups, `at` holds for pictures too.
  function make_stage(state, raster) {
    top = beginning;
    const { wide, high } = raster, pitch = data.lanes * Math.ceil(wide / data.lanes), [x, y] = image_points(raster);
    const stage = { raster, pitch, targets: {}, x: reserve(8 * pitch), y: reserve(8 * high), code: reserve(pitch * high), code_again: reserve(pitch * high),
      everywhere: reserve(16 * high), columns_of_a: reserve(16 * high) };
    for (const plane of [...ANGLES, "u", "v"]) stage[plane] = reserve(8 * pitch * high);
    floats(stage.x, pitch).fill(NaN).set(x);
    floats(stage.y, high).set(y);
    new BigInt64Array(memory.buffer, stage.everywhere, 2 * high).forEach((_, n, ends) => (ends[n] = n % 2 ? BigInt(wide) : 0n));
    const codes = chambers_of(state, stage, stage.code), at = [], ends = new BigInt64Array(memory.buffer, stage.columns_of_a, 2 * high).fill(0n);
    for (let row = 0; row < high; row++) {
      const on_row = codes.subarray(row * wide, (row + 1) * wide), before = at.length;
      on_row.forEach((code, column) => (code & SURFACE) === A && at.push(row * pitch + column));
      if (at.length > before) ends.set([at[before], at[at.length - 1] + 1].map((end) => BigInt(end - row * pitch)), 2 * row);
    }
    draw("draw_chart", state, { name: "exact" }, stage);
    const lanes = BigInt(data.lanes), groups = Number(ends.reduce((sum, end, n) => (n % 2 ? sum + (end + lanes - 1n) / lanes : sum - end / lanes), 0n));
    const rows = at.length ? [Math.floor(at[0] / pitch), Math.floor(at[at.length - 1] / pitch) + 1] : [0, 0];
    return { ...stage, codes, count: at.length, at: Int32Array.from(at), rows, stills: 8 * data.lanes * groups * data.stills[state.lights.filter(Boolean).length] };
  }

  // The address of a stage's plane of a name.
  const place = (stage, name, plane) => (stage.targets[`${name} ${plane}`] ??= reserve((plane === "pixels" ? 4 : 8) * stage.pitch * stage.raster.high));
  const target = (stage, name, planes = PLANES) => Object.fromEntries(planes.map((plane) => [plane, place(stage, name, plane)]));

  // Paint the pixels of a name, on all rows or where A is; return {largest, squares} of a difference.
  function paint(painter, stage, name, { whole = false, of = name, other = name, table = "srgb", palette = "grey", gain = 1 }) {
    const columns = whole ? stage.everywhere : stage.columns_of_a, pixels = place(stage, name, "pixels"), plane = place(stage, "view", "plane");
    const others = Object.fromEntries(COLORS.map((color) => [`other_${color}`, place(stage, other, color)]));
    const given = { ...target(stage, of, COLORS), ...others, ...tables[table], pixels, plane, columns, first_row: 0, last_row: stage.raster.high, pitch: stage.pitch, palette: palette_at[palette], numbers: numbers_at };
    const numbers = floats(numbers_at, data.numbers.length).fill(0);
    numbers[data.numbers.indexOf("gain")] = gain;
    call(painter, data.painting.map((argument) => given[argument]));
    return Object.fromEntries(data.numbers.map((key, n) => [key, numbers[n]]));
  }

  // Put numbers of A's pixels, one after another, into the plane of what is viewed; 0 elsewhere.
  function fill(stage, values) {
    const plane = floats(place(stage, "view", "plane"), stage.pitch * stage.raster.high).fill(0);
    stage.at.forEach((i, n) => (plane[i] = values[n]));
  }

  // A view of the painted bytes of some rows.
  const bytes = (stage, name, [first, last]) =>
    new Uint8ClampedArray(memory.buffer, place(stage, name, "pixels") + 4 * stage.pitch * first, 4 * stage.pitch * (last - first));

  // Draw A. What no step of ε or β changes is kept from one central difference to the next, but for what is timed.
  function draw_a(state, method, stage, name) {
    const keeps = name !== "spare" && method.name === "central" && state.beta !== 0, key = [state.field, state.ku, state.kv, state.model].join();
    const what = !keeps ? "draw_a" : stage.kept === key ? "draw_again" : "draw_first";
    if (keeps) stage.kept = key;
    draw(what, state, method, stage, { ...target(stage, name), stills: (stage.targets.stills ??= reserve(stage.stills)) });
  }

  const draw_elsewhere = (state, stage, name) => draw("draw_elsewhere", state, { name: "exact" }, stage, target(stage, name));

  // A whole picture, three planes, as the renderer's frame.rgb; on the stage of another one, a step from it.
  function render(state, method, raster, stage = make_stage(state, raster)) {
    draw_elsewhere(state, stage, "picture");
    draw_a(state, method, stage, "picture");
    const planes = COLORS.map((color) => rows(floats(place(stage, "picture", color), stage.pitch * raster.high), stage));
    return { planes, codes: stage.codes, stage };
  }

  // The numbers of a plane on A's pixels, one after another.
  function on_a(stage, address) {
    const plane = floats(address, stage.pitch * stage.raster.high);
    return Float64Array.from(stage.at, (i) => plane[i]);
  }

  const angles_of = (stage) => ANGLES.map((name) => on_a(stage, stage[name]));
  const chart = (stage) => ["u", "v"].map((name) => on_a(stage, stage[name]));

  // h_u and h_v on A's pixels, whether they are drawn with a bump or not.
  function gradients(state, method, stage) {
    draw_a({ ...state, beta: 1 }, method, stage, "gradient");
    return ["h_u", "h_v"].map((plane) => on_a(stage, place(stage, "gradient", plane)));
  }

  const gradient = (...what) => gradients(...what).map(([slope]) => slope); // of the one pixel of a stage

  // What bounds a central difference's error at points of A, by theorem: null where none covers the field or the method.
  // Arrays: the bound, the number of its largest term, the bounds of h_u and of h_v, of which it is the larger.
  const bounds = ({ field, method, ku, kv }, u, v, eps) =>
    method === "central" && `bounds_${field}` in data.kernels ? kernel(`bounds_${field}`, u, v, ku, kv, eps) : null;

  // {a, b, c} of the field's crease factors sinpi(a u + b v + c).
  function creases({ field, ku, kv }) {
    const rates = data.fields[field].creases ? kernel(`creases_${field}`, ku, kv) : [];
    return Array.from({ length: rates.length / 3 }, (_, n) => ({ a: rates[3 * n], b: rates[3 * n + 1], c: rates[3 * n + 2] }));
  }

  // How many of A's pixels the bump turns to the other side of each light that is on.
  function turned(state, stage, name) {
    const angles = angles_of(stage), slopes = ["h_u", "h_v"].map((plane) => on_a(stage, place(stage, name, plane)));
    const point = kernel("point_on_a", ...angles, radius), normals = [state.beta, 0].map((beta) => kernel("bumped_normal", ...angles, ...slopes, beta));
    return data.scene.lights.filter((_, n) => state.lights[n]).map(({ position }) => {
      const [bumped, plain] = normals.map((normal) => kernel("light_cosine", ...point, ...position, ...normal));
      return bumped.reduce((count, mu, i) => count + (mu > 0 !== plain[i] > 0), 0);
    });
  }

  // What renderer.pixel records, for one pixel of the whole raster.
  function pixel(state, method, { width, height }, column, row) {
    const raster = { width, height, left: column, top: row, wide: 1, high: 1 }, { planes, codes: [code], stage } = render(state, method, raster);
    const rgb = planes.map(([number]) => number), [[x], [y]] = image_points(raster);
    const record = { column, row, code, surface: ["none", "A", "B", "floor"][code & SURFACE], rgb };
    if (record.surface === "none") return record;
    if (record.surface === "A") return { ...record, ...facts_on_a(state, method, stage) };
    const ball = [...data.scene.ball_center, data.scene.ball_radius, 1];
    const six = record.surface === "B" ? kernel("normal_of_b", x, y, eye, ...ball) : kernel("normal_of_floor", x, y);
    return { ...record, point: six.slice(0, 3), normal: six.slice(3) };
  }

  function facts_on_a(state, method, stage) {
    const [u, v, ...angles] = [...chart(stage), ...angles_of(stage)].map(([number]) => number);
    const [theta, phi] = kernel("chart_radians", u, v), field = (name, ...inputs) => kernel(`${name}_${state.field}`, ...inputs), slopes = gradient(state, method, stage);
    return {
      point: kernel("point_on_a", ...angles, radius), normal: kernel("bumped_normal", ...angles, ...slopes, state.beta), gradient: slopes,
      theta, phi, u, v, h: field("height", u, v, state.ku, state.kv),
      kink: field("kink", angles[3], u, v, state.ku, state.kv) === 1,
      straddling: method.eps ? field("straddling", u, v, state.ku, state.kv, method.eps) === 1 : false,
    };
  }

  const radius_of_a = Math.sqrt(Object.values(data.scenes)[0].scene[data.offsets.reach_of_a]); // on the image
  return { kernel, image_points, radius_of_a, wave_numbers, make_stage, chambers_of, draw_a, draw_elsewhere, paint, fill, bytes, render,
    chart, angles_of, gradients, gradient, bounds, creases, turned, pixel };
};

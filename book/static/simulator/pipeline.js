// What the renderer does, with its kernels: chambers, gradient, shading. It mirrors renderer/{chambers,gradients,
// shading}.py, and the tests compare every bit. Sphere A's pixels stand one after another in compact arrays; a segment
// is a piece of a row of one chamber. What does not depend on the field, beta or epsilon is kept on the stage
// (theorem bump_moves_no_boundary).
"use strict";
var Simulator = Simulator || {};

Simulator.pipeline = function (kernels) {
  const SURFACE = 3, A = 1, B = 2, FLOOR = 3, FIRST_LIGHT_BIT = 2, DARK_BIT = 128, CHUNK = 512;
  const rows = (count, length) => Array.from({ length: count }, () => new Float64Array(length));

  // The scene of a state: the renderer's defaults with what the page can change.
  function scene_of(state) {
    const scene = { ...kernels.scene, field: state.field, k_u: state.ku, k_v: state.kv, beta: state.beta };
    const lights = scene.lights.map((light, n) => (state.lights[n] ? light : null));
    return { ...scene, model: state.model, ball_on: state.ball ? 1 : 0, floor_on: 1, lights };
  }

  const lights_of = (scene) =>
    scene.lights.flatMap((light, n) => (light ? [{ ...light, bit: 1 << (FIRST_LIGHT_BIT + n), number: n }] : []));

  function image_points(scene, { width, height, left, top, wide, high }) {
    const half = kernels.image_extent(scene.eye, scene.radius);
    const x = Float64Array.from({ length: wide }, (_, i) => kernels.image_x(left + i, width, height, half));
    return [x, Float64Array.from({ length: high }, (_, i) => kernels.image_y(top + i, height, half))];
  }

  // A scene without B asks with the renderer's stand-in for it.
  const ball_of = (scene) => (scene.ball_on ? [scene.ball_center, scene.ball_radius] : [[0, 0, 0], 1]);

  function mark_shadows(scene, surface, light, x, y, codes, at, flag, start, stop) {
    const [ball, ball_radius] = ball_of(scene), { eye, radius, ball_on } = scene, origin = [0, 0, 0];
    const mark = () => {
      for (let i = start; i < stop; i++) if (flag[i] > 0) codes[at + i] |= light.bit;
    };
    if (surface === B) {
      kernels.shadow_on_b_row(x, y, eye, ...ball, ball_radius, ball_on, ...light.position, ...origin, radius,
        flag, start, stop);
      mark();
    } else if (surface === A && ball_on) {
      kernels.shadow_on_a_row(x, y, eye, radius, ...light.position, ...ball, ball_radius, flag, start, stop);
      mark();
    } else if (surface === FLOOR) {
      kernels.shadow_on_floor_row(x, y, ...light.position, ...origin, radius, flag, start, stop);
      mark();
      if (ball_on) {
        kernels.shadow_on_floor_row(x, y, ...light.position, ...ball, ball_radius, flag, start, stop);
        mark();
      }
    }
  }

  // The chamber of every pixel, as in renderer.chambers: surface, occluded lights, dark square.
  function chambers_of(scene, raster) {
    const [x, y] = image_points(scene, raster), { wide, high } = raster, [ball, ball_radius] = ball_of(scene);
    const codes = new Uint8Array(wide * high), [surface, flag] = rows(2, wide), lights = lights_of(scene);
    for (let row = 0; row < high; row++) {
      const at = row * wide;
      kernels.visible_surface_row(x, y[row], scene.eye, scene.radius, ...ball, ball_radius, scene.ball_on,
        scene.floor_on, surface, 0, wide);
      for (let start = 0, stop; start < wide; start = stop) {
        for (stop = start + 1; stop < wide && surface[stop] === surface[start];) stop++;
        codes.fill(surface[start], at + start, at + stop);
        if (surface[start] === FLOOR) {
          kernels.checker_row(x, y[row], flag, start, stop);
          for (let i = start; i < stop; i++) if (flag[i] > 0) codes[at + i] |= DARK_BIT;
        }
        for (const light of lights) mark_shadows(scene, surface[start], light, x, y[row], codes, at, flag, start, stop);
      }
    }
    return codes;
  }

  // The chambers, the segments of each surface, and what is known of A's pixels before any height is looked at.
  function make_stage(scene, raster) {
    const [x, y] = image_points(scene, raster), { wide, high } = raster, codes = chambers_of(scene, raster);
    const on_a = [], elsewhere = [];
    let count = 0;
    for (let row = 0; row < high; row++) {
      for (let start = 0, stop; start < wide; start = stop) {
        const code = codes[row * wide + start];
        for (stop = start + 1; stop < wide && codes[row * wide + stop] === code;) stop++;
        const segment = { row, y: y[row], code, from: start, start, stop };
        if ((code & SURFACE) === A) {
          Object.assign(segment, { start: count, stop: count + stop - start });
          count = segment.stop;
          on_a.push(segment);
        } else elsewhere.push(segment);
      }
    }
    const stage = { x, raster, codes, on_a, elsewhere, count, at: new Int32Array(count), x_of_a: new Float64Array(count) };
    [stage.cos_theta, stage.sin_theta, stage.cos_phi, stage.sin_phi, stage.u, stage.v] = rows(6, count);
    for (const { row, y, from, start, stop } of on_a) {
      for (let i = start; i < stop; i++) {
        stage.at[i] = row * wide + from + i - start;
        stage.x_of_a[i] = x[from + i - start];
      }
      const { eye, radius } = scene, { x_of_a, cos_theta, sin_theta, cos_phi, sin_phi } = stage;
      kernels.angles_on_a_row(x_of_a, y, eye, radius, cos_theta, sin_theta, cos_phi, sin_phi, start, stop);
    }
    in_chunks(count, (start, stop) =>
      kernels.chart_row(stage.cos_theta, stage.sin_theta, stage.cos_phi, stage.sin_phi, stage.u, stage.v, start, stop));
    return stage;
  }

  // A chunk's rows stay in the first-level cache.
  function in_chunks(count, work) {
    for (let start = 0; start < count; start += CHUNK) work(start, Math.min(count, start + CHUNK));
  }

  function algebraic_powers(scene) {
    const wave_numbers = kernels.fields[scene.field].wave_numbers;
    if (!wave_numbers) return null;
    const [a, b] = wave_numbers(scene.k_u, scene.k_v);
    if (a % 2 || b % 1 || Math.max(Math.abs(a), Math.abs(b)) > kernels.max_algebraic) return null;
    return [Math.trunc(a) / 2, Math.trunc(b)];
  }

  const [square_real, square_imaginary] = rows(2, CHUNK);

  // (orientation * base)^exponent by repeated squaring; a negative exponent conjugates.
  function power(base_real, base_imaginary, orientation, exponent, real, imaginary, start, stop) {
    const count = stop - start, reflection = exponent >= 0 ? orientation : -orientation;
    for (let i = 0; i < count; i++) {
      square_real[i] = orientation * base_real[start + i];
      square_imaginary[i] = reflection * base_imaginary[start + i];
    }
    let remaining = Math.abs(exponent), first = true;
    real.fill(1, 0, count);
    imaginary.fill(0, 0, count);
    while (remaining) {
      if (remaining & 1) {
        if (first) {
          real.set(square_real.subarray(0, count));
          imaginary.set(square_imaginary.subarray(0, count));
        } else kernels.complex_product_row(real, imaginary, square_real, square_imaginary, 0, count);
        first = false;
      }
      remaining >>= 1;
      if (remaining) kernels.complex_square_row(square_real, square_imaginary, 0, count);
    }
  }

  const [cos_u, sin_u, cos_v, sin_v, part_u, part_v] = rows(6, CHUNK);

  // h_u and h_v of A's pixels by a method {name, eps}; the exact one without a sine where the form is algebraic.
  function gradient(scene, method, stage, h_u, h_v) {
    const field = kernels.fields[scene.field], { k_u, k_v } = scene, powers = algebraic_powers(scene);
    in_chunks(stage.count, (start, stop) => {
      if (method.name !== "exact") {
        field[method.name](stage.u, stage.v, k_u, k_v, method.eps, h_u, h_v, start, stop);
      } else if (powers) {
        power(stage.cos_theta, stage.sin_theta, -1, powers[0], cos_u, sin_u, start, stop);
        power(stage.cos_phi, stage.sin_phi, 1, powers[1], cos_v, sin_v, start, stop);
        field.gradient_from_factors(sin_u, cos_u, sin_v, cos_v, k_u, k_v, part_u, part_v, 0, stop - start);
        h_u.set(part_u.subarray(0, stop - start), start);
        h_v.set(part_v.subarray(0, stop - start), start);
      } else field.gradient(stage.u, stage.v, k_u, k_v, h_u, h_v, start, stop);
    });
  }

  function material_of(scene) {
    const floor = [0, 1].map((dark) => kernels.floor_albedo(dark, scene.floor_tint)).map(([r, b]) => [r, r, b]);
    const squared = scene.model === "blinn" && scene.shininess % 2 === 0;
    return {
      power: squared ? scene.shininess / 2 : scene.shininess,
      base_row: squared ? kernels.blinn_squared_row : kernels.phong_row,
      on_a: squared
        ? [kernels.squared_of_1_on_a_row, kernels.squared_of_2_on_a_row]
        : [kernels.phong_of_1_on_a_row, kernels.phong_of_2_on_a_row],
      floor_row: squared ? kernels.blinn_squared_on_floor_row : kernels.phong_on_floor_row,
      ambient: scene.ambient.map((channel) => kernels.ambient_term(scene.ka, channel)),
      albedo: [[0, 0, 0], scene.albedo_a, scene.albedo_b, ...floor],
      lights: lights_of(scene),
    };
  }

  let place = [], work = []; // points, normals, 1/|E - P|; mu and the highlight's base of two lights, a spare row

  // Add the lights that reach a segment of one chamber, whose places are in `place`.
  function light_segment(scene, m, code, x, y, rgb, start, stop) {
    const on_floor = (code & SURFACE) === FLOOR, albedo = m.albedo[on_floor && code & DARK_BIT ? 4 : code & SURFACE];
    const [px, py, pz, nx, ny, nz, view] = place, [mu, base, , , spare] = work;
    rgb.forEach((channel, n) => channel.fill(m.ambient[n], start, stop));
    for (const { position, color, bit } of m.lights) {
      if (code & bit) continue;
      if (on_floor) m.floor_row(x, y, scene.eye, view, ...position, mu, base, start, stop);
      else m.base_row(x, y, scene.eye, view, px, py, pz, ...position, nx, ny, nz, mu, base, start, stop);
      raise(base, spare, m.power, start, stop);
      kernels.light_term_row(...rgb, ...color, ...albedo, scene.kd, scene.ks, mu, base, start, stop);
    }
    kernels.clip_row(...rgb, ...rgb, start, stop);
  }

  // base^power in place, by repeated squaring.
  function raise(base, spare, power, start, stop) {
    let remaining = power;
    for (; !(remaining & 1); remaining >>= 1) kernels.square_row(base, start, stop);
    if (remaining === 1) return;
    spare.set(base.subarray(start, stop), start);
    for (remaining >>= 1; remaining; remaining >>= 1) {
      kernels.square_row(spare, start, stop);
      if (remaining & 1) kernels.multiply_row(base, spare, start, stop);
    }
  }

  // One or two lights on a segment of A, in one loop for their geometry and one for their colours.
  function light_a(scene, m, lit, stage, { y, start, stop }, { h_u, h_v, rgb }) {
    const { cos_theta, sin_theta, cos_phi, sin_phi, x_of_a } = stage, { kd, ks, albedo_a } = scene;
    const found = work.slice(0, 2 * lit.length), [mu, base, other_mu, other_base, spare] = work;
    m.on_a[lit.length - 1](cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, scene.beta, scene.radius, x_of_a, y,
      scene.eye, ...lit.flatMap((light) => light.position), ...found, start, stop);
    raise(base, spare, m.power, start, stop);
    const first = [...m.ambient, ...lit[0].color, ...albedo_a, kd, ks, mu, base];
    if (lit.length === 1) kernels.light_terms_of_1_on_sphere_row(...first, ...rgb, start, stop);
    else {
      raise(other_base, spare, m.power, start, stop);
      kernels.light_terms_of_2_on_sphere_row(...first, ...lit[1].color, other_mu, other_base, ...rgb, start, stop);
    }
    kernels.clip_row(...rgb, ...rgb, start, stop);
  }

  function prepare(length) {
    if (!place.length || place[0].length < length) [place, work] = [rows(7, length), rows(5, length)];
  }

  function place_a(scene, stage, { y, start, stop }, h_u, h_v, beta = scene.beta) {
    const { cos_theta, sin_theta, cos_phi, sin_phi, x_of_a } = stage;
    kernels.normal_on_a_row(cos_theta, sin_theta, cos_phi, sin_phi, h_u, h_v, beta, scene.radius, x_of_a, y, scene.eye,
      ...place, start, stop);
  }

  function place_elsewhere(scene, x, { y, code, start, stop }) {
    const [ball, ball_radius] = ball_of(scene);
    if ((code & SURFACE) === FLOOR) kernels.view_length_row(x, y, scene.eye, place[6], start, stop);
    else kernels.normal_of_b_row(x, y, scene.eye, ...ball, ball_radius, scene.ball_on, ...place, start, stop);
  }

  // The colours of A's pixels, three compact planes.
  function shade_a(scene, stage, target) {
    const m = material_of(scene);
    prepare(stage.count);
    for (const segment of stage.on_a) {
      const lit = m.lights.filter(({ bit }) => !(segment.code & bit));
      if (lit.length === 1 || lit.length === 2) light_a(scene, m, lit, stage, segment, target);
      else {
        place_a(scene, stage, segment, target.h_u, target.h_v);
        light_segment(scene, m, segment.code, stage.x_of_a, segment.y, target.rgb, segment.start, segment.stop);
      }
    }
  }

  // The colours of everything but A, three planes of the raster; 0 on A and where there is nothing.
  function shade_elsewhere(scene, stage) {
    const m = material_of(scene), { x, raster: { wide, high } } = stage, planes = rows(3, wide * high);
    prepare(wide);
    for (const segment of stage.elsewhere) {
      if (!(segment.code & SURFACE)) continue;
      place_elsewhere(scene, x, segment);
      const rgb = planes.map((plane) => plane.subarray(segment.row * wide));
      light_segment(scene, m, segment.code, x, segment.y, rgb, segment.start, segment.stop);
    }
    return planes;
  }

  // The slopes that one pipeline shades with: none where there is no bump.
  function slopes(scene, method, stage, { h_u, h_v }) {
    if (scene.beta !== 0) gradient(scene, method, stage, h_u, h_v);
    else [h_u, h_v].forEach((plane) => plane.fill(0));
  }

  function draw_a(scene, method, stage, target) {
    slopes(scene, method, stage, target);
    shade_a(scene, stage, target);
  }

  const empty_target = (count) => ({ h_u: new Float64Array(count), h_v: new Float64Array(count), rgb: rows(3, count) });

  // A whole picture, three planes, as the renderer's frame.rgb.
  function render(scene, method, raster) {
    const stage = make_stage(scene, raster), target = empty_target(stage.count), planes = shade_elsewhere(scene, stage);
    draw_a(scene, method, stage, target);
    for (let i = 0; i < stage.count; i++) planes.forEach((plane, c) => (plane[stage.at[i]] = target.rgb[c][i]));
    return { planes, codes: stage.codes };
  }

  // Which of A's pixels have N' turned towards a light, at an amplitude.
  function towards_light(scene, stage, target, light, beta) {
    const lit = new Uint8Array(stage.count), [px, py, pz, nx, ny, nz] = place, mu = work[0];
    for (const segment of stage.on_a) {
      const { start, stop } = segment;
      place_a(scene, stage, segment, target.h_u, target.h_v, beta);
      kernels.light_cosine_row(px, py, pz, ...light.position, nx, ny, nz, mu, start, stop);
      for (let i = start; i < stop; i++) lit[i] = mu[i] > 0 ? 1 : 0;
    }
    return lit;
  }

  // What renderer.pixel records, for one pixel of the whole raster.
  function pixel(scene, method, { width, height }, column, row) {
    const raster = { width, height, left: column, top: row, wide: 1, high: 1 };
    const stage = make_stage(scene, raster), code = stage.codes[0], { planes } = render(scene, method, raster);
    const record = { column, row, code, surface: ["none", "A", "B", "floor"][code & SURFACE], rgb: planes.map((p) => p[0]) };
    if (!(code & SURFACE)) return record;
    prepare(1);
    if ((code & SURFACE) === A) {
      const h_u = new Float64Array(1), h_v = new Float64Array(1);
      gradient(scene, method, stage, h_u, h_v);
      place_a(scene, stage, stage.on_a[0], h_u, h_v);
      Object.assign(record, facts_on_a(scene, method, stage, h_u[0], h_v[0]));
    } else if ((code & SURFACE) === B) place_elsewhere(scene, stage.x, stage.elsewhere[0]);
    else return { ...record, point: [stage.x[0], stage.elsewhere[0].y, 0], normal: [0, 0, 1] };
    const six = place.map((p) => p[0]);
    return { ...record, point: six.slice(0, 3), normal: six.slice(3, 6) };
  }

  function facts_on_a(scene, method, stage, h_u, h_v) {
    const field = kernels.fields[scene.field], { k_u, k_v } = scene, { u, v } = stage, [h, kink, straddling] = rows(3, 1);
    field.height(u, v, k_u, k_v, h, 0, 1);
    field.kink(stage.sin_phi, u, v, k_u, k_v, kink, 0, 1);
    if (method.eps) field.straddling(u, v, k_u, k_v, method.eps, straddling, 0, 1);
    return {
      theta: (2 * u[0] - 1) * Math.PI, phi: v[0] * Math.PI, u: u[0], v: v[0], h: h[0], gradient: [h_u, h_v],
      kink: kink[0] === 1, straddling: straddling[0] === 1,
    };
  }

  return { scene_of, lights_of, image_points, chambers_of, make_stage, in_chunks, gradient, slopes, empty_target, shade_a, draw_a, render,
    shade_elsewhere, towards_light, pixel, rows };
};

// Three balls under one lamp, turned as one by hand: really displaced, with its slopes alone, and painted.
// Points and light are the kernels'; the graphics card draws triangles and nothing else.
"use strict";

IDEAS.three_balls = (stage, module, data) => {
  const { ku, kv, ambient, albedo_a, kd } = data.scene;
  const { beta, away, ka } = data.balls;
  const NAMES = ["really displaced", "bump-mapped", "painted"];
  const HIGH = clamp(190, 0.36 * stage.figure.clientWidth, 330);
  const AROUND = 320; // points; a crease lies between two of them
  const ALONG = 160;
  const FAR = (4 * Math.PI) / 9; // the lamp to a side
  let { turn, tip, lamp } = data.balls; // the eye goes around and up; the lamp stands so far to its right and above it
  let from = [0, 0];

  const canvas = make_element("canvas", { "aria-hidden": "true" });
  const gl = canvas.getContext("webgl2");
  if (!gl) return null;

  /** @param {number} kind @param {string} text */
  const shader = (kind, text) => {
    const made = /** @type {WebGLShader} */ (gl.createShader(kind));
    gl.shaderSource(made, text);
    gl.compileShader(made);
    return made;
  };
  const program = gl.createProgram();
  const VERTEX =
    "#version 300 es\nlayout(location = 0) in vec3 at; layout(location = 1) in vec2 light; uniform mat4 view;" +
    "out vec2 lit; void main() { gl_Position = view * vec4(at, 1.0); lit = light; }";
  const FRAGMENT =
    "#version 300 es\nprecision highp float; uniform vec3 tint, dark; in vec2 lit; out vec4 colour; void main() {" +
    "vec3 c = dark + tint * lit.x * lit.y;" +
    "colour = vec4(mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c)), 1.0); }";
  gl.attachShader(program, shader(gl.VERTEX_SHADER, VERTEX));
  gl.attachShader(program, shader(gl.FRAGMENT_SHADER, FRAGMENT));
  gl.linkProgram(program);
  gl.useProgram(program);
  gl.enable(gl.DEPTH_TEST);
  const view_at = gl.getUniformLocation(program, "view");
  const colours = { tint: albedo_a.map((part) => kd * part), dark: ambient.map((part) => ka * part) };
  for (const [name, colour] of Object.entries(colours)) gl.uniform3fv(gl.getUniformLocation(program, name), colour);

  /** @param {AllowSharedBufferSource} values */
  const buffer = (values, /** @type {number} */ target = gl.ARRAY_BUFFER, made = gl.createBuffer()) => {
    gl.bindBuffer(target, made);
    gl.bufferData(target, values, gl.STATIC_DRAW);
    return made;
  };

  // A row of points on each parallel, half a cell off every crease; the first and the last all but at the poles.
  const count = AROUND * (ALONG + 2);
  const u = float64s(count, (n) => ((n % AROUND) + 0.5) / AROUND);
  const v = float64s(count, (n) => clamp(1e-6, (Math.floor(n / AROUND) - 0.5) / ALONG, 1 - 1e-6));
  /** The axes of the view: to the right, up, and toward the eye. */
  const axes = () => {
    const [c, s, ct, st] = [Math.cos(turn), -Math.sin(turn), Math.cos(tip), Math.sin(tip)];
    return [
      [-s, c, 0],
      [-st * c, -st * s, ct],
      [ct * c, ct * s, st]
    ];
  };
  /** What the lamp lights. */
  const values = () => {
    const [to_right, up] = lamp;
    const along = [Math.sin(to_right) * Math.cos(up), Math.sin(up), Math.cos(to_right) * Math.cos(up)];
    const view = axes();
    const light = [0, 1, 2].map((n) => away * along.reduce((sum, part, axis) => sum + part * view[axis][n], 0));
    return module.own.kernel_over("surfaces", u, v, ku, kv, beta, ...light);
  };
  /** The numbers of each point, one after another. @param {ArrayLike<number>[]} parts */
  const together = (parts) =>
    Float32Array.from(
      { length: parts.length * count },
      (_, n) => parts[n % parts.length][Math.floor(n / parts.length)]
    );
  const first = values();
  const [smooth, raised] = [first.slice(0, 3), first.slice(3, 6)].map((points) => buffer(together(points)));
  const plain = new Float64Array(count).fill(1);
  // So painted that it looks like the bump under the lamp's first place, but no brighter than white.
  const paint = plain.map((_, n) => Math.min(1 / Math.max(...albedo_a), first[11][n] ? first[9][n] / first[11][n] : 1));
  const lit = gl.createBuffer();
  const cells = Array.from({ length: AROUND * (ALONG + 1) }, (_, n) => {
    const next = n - (n % AROUND) + ((n + 1) % AROUND);
    return [n, next, n + AROUND, next, next + AROUND, n + AROUND];
  });
  const corners = Uint16Array.from(cells.flat());
  buffer(corners, gl.ELEMENT_ARRAY_BUFFER);

  const panel = stage.panel("Three balls and their lamp", HIGH);
  panel.box.classList.add("idea-orbit");
  panel.box.append(canvas);
  /** CSS pixels of a ball's radius. */
  const radius = () => Math.min(panel.width() / 7.5, HIGH / 2.4);
  /** How far a radian moves the lamp, beside the middle ball. */
  const reach = () => (1.3 * radius()) / FAR;
  /** @type {Moved} */
  function drag(x, y, begins) {
    if (!begins) look(turn + (x - from[0]) / 120, tip + (y - from[1]) / 120);
    from = [x, y];
  }
  const put_view = panel.backdrop(
    "the balls: drag, or press arrow keys, to turn them",
    [-180, 180],
    drag,
    (right, up) => look(clamp(-Math.PI, turn + right / 20, Math.PI), tip - up / 20)
  );
  const put_lamp = panel.handle(
    "the lamp",
    [-80, 80],
    (x, y) => shine((x - panel.width() / 2) / reach(), (HIGH / 2 - y) / reach()),
    (right, up) => shine(lamp[0] + right / 20, lamp[1] + up / 20),
    "lamp"
  );

  /** @param {number} to_turn @param {number} to_tip */
  function look(to_turn, to_tip) {
    turn = Math.atan2(Math.sin(to_turn), Math.cos(to_turn));
    tip = clamp(-Math.PI / 2, to_tip, Math.PI / 2);
    stage.redraw();
  }

  /** @param {...number} to */
  function shine(...to) {
    const [to_right, up] = to.map((angle) => clamp(-FAR, angle, FAR));
    lamp = [to_right, up];
    stage.redraw();
  }

  return () => {
    const wide = panel.width();
    const size = radius();
    set_attributes(canvas, { width: wide * devicePixelRatio, height: HIGH * devicePixelRatio });
    const scale = [(6 * size) / wide, (2 * size) / HIGH, -1 / 8];
    const view = axes().map((axis, n) => axis.map((part) => part * scale[n]));
    gl.uniformMatrix4fv(view_at, false, [...[0, 1, 2].flatMap((n) => [...view.map((axis) => axis[n]), 0]), 0, 0, 0, 1]);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const light = values();
    const balls = [light[10], light[9], light[11]];
    for (const [n, cosines] of balls.entries()) {
      gl.viewport((n * canvas.width) / 3, 0, canvas.width / 3, canvas.height);
      buffer(together([cosines, n < 2 ? plain : paint]), gl.ARRAY_BUFFER, lit);
      gl.vertexAttribPointer(1, 2, gl.FLOAT, false, 0, 0);
      gl.bindBuffer(gl.ARRAY_BUFFER, n ? smooth : raised);
      gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
      for (const place of [0, 1]) gl.enableVertexAttribArray(place);
      gl.drawElements(gl.TRIANGLES, corners.length, gl.UNSIGNED_SHORT, 0);
    }
    panel.show(NAMES.map((name, n) => text_at(((n + 0.5) * wide) / 3, HIGH - 6, name)).join(""));
    const [around, above, to_right, up] = [turn, tip, ...lamp].map((part) => Math.round((part * 180) / Math.PI));
    put_view(around, `turned by ${around}°, from ${above}° above`);
    put_lamp(
      [wide / 2 + lamp[0] * reach(), HIGH / 2 - lamp[1] * reach()],
      to_right,
      `${to_right}° to the right, ${up}° up`
    );
  };
};

// One sphere to turn by hand: the chapter's normal, its sign, its scale and its metric mended, and the surface moved.
// Points, normals and light are the kernels'; the graphics card draws triangles and nothing else.
"use strict";

IDEAS.bump_surface = (stage, module, data) => {
  const { ku, kv, beta, lights } = data.scene;
  const STATES = ["the chapter’s normal", "its sign mended", "and its scale", "and its metric", "really displaced"];
  const SAYS = [
    "Its hills are lit as hollows.",
    "Now hills are hills.",
    "Slopes are per radian now; around the pole they still lack 1/sin φ.",
    "Blinn’s normal; the rim and the shadow are still the ball’s.",
    "The rim and the shadow have moved, for the first time."
  ];
  const DISPLACED = STATES.length - 1;
  const HIGH = 430;
  const AROUND = 320; // points; a crease lies between two of them
  const ALONG = 160;
  const FLOOR = -1.4;
  const DISC = [-0.6, -0.6, 2.2]; // the floor's middle and radius
  const RED = [0.88, 0.54, 0.45, 0]; // the least light at the end
  const GROUND = [0.91, 0.89, 0.85, 1];
  const SHADE = [0.564, 0.552, 0.527, 1];
  const [light_x, light_y, light_z] = lights[0].position;
  let shown = 0;
  let turn = 0.5; // the sphere: how far around,
  let tip = 0.45; // the eye: how far up
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
    "#version 300 es\nlayout(location = 0) in vec3 at; layout(location = 1) in float light; uniform mat4 view; out float lit;" +
    "void main() { gl_Position = view * vec4(at, 1.0); lit = light; }";
  const FRAGMENT =
    "#version 300 es\nprecision mediump float; uniform vec4 tint; in float lit; out vec4 colour;" +
    "void main() { colour = vec4(tint.rgb * clamp(lit, tint.a, 1.0), 1.0); }";
  gl.attachShader(program, shader(gl.VERTEX_SHADER, VERTEX));
  gl.attachShader(program, shader(gl.FRAGMENT_SHADER, FRAGMENT));
  gl.linkProgram(program);
  gl.useProgram(program);
  gl.enable(gl.DEPTH_TEST);
  const view_at = gl.getUniformLocation(program, "view");
  const tint_at = gl.getUniformLocation(program, "tint");

  /** @param {AllowSharedBufferSource} values */
  const buffer = (values, /** @type {number} */ target = gl.ARRAY_BUFFER) => {
    const made = gl.createBuffer();
    gl.bindBuffer(target, made);
    gl.bufferData(target, values, gl.STATIC_DRAW);
    return made;
  };

  // A row of points on each parallel, half a cell off every crease; the first and the last all but at the poles.
  const count = AROUND * (ALONG + 2);
  const u = float64s(count, (n) => ((n % AROUND) + 0.5) / AROUND);
  const v = float64s(count, (n) => clamp(1e-6, (Math.floor(n / AROUND) - 0.5) / ALONG, 1 - 1e-6));
  const values = module.own.kernel_over("surfaces", u, v, ku, kv, beta, light_x, light_y, light_z);
  /** @param {Float64Array[]} parts */
  const together = (parts) => Float32Array.from({ length: 3 * count }, (_, n) => parts[n % 3][Math.floor(n / 3)]);
  const shapes = [values.slice(0, 3), values.slice(3, 6)].map((points) => {
    const share = points[2].map((z) => (light_z - FLOOR) / (light_z - z));
    const shadow = [
      points[0].map((x, n) => light_x + share[n] * (x - light_x)),
      points[1].map((y, n) => light_y + share[n] * (y - light_y)),
      points[2].map(() => FLOOR + 0.004)
    ];
    return { points: buffer(together(points)), shadow: buffer(together(shadow)) };
  });
  const light = values.slice(6).map((mu) => buffer(Float32Array.from(mu, (part) => (0.08 + 0.92 * part) ** (1 / 2.2))));
  const circle = Array.from({ length: 66 }, (_, n) => [
    DISC[0] + (n && DISC[2] * Math.cos((n * Math.PI) / 32)),
    DISC[1] + (n && DISC[2] * Math.sin((n * Math.PI) / 32)),
    FLOOR
  ]);
  const floor = buffer(Float32Array.from(circle.flat()));
  const cells = Array.from({ length: AROUND * (ALONG + 1) }, (_, n) => {
    const next = n - (n % AROUND) + ((n + 1) % AROUND);
    return [n, next, n + AROUND, next, next + AROUND, n + AROUND];
  });
  const corners = Uint16Array.from(cells.flat());
  buffer(corners, gl.ELEMENT_ARRAY_BUFFER);

  const panel = stage.panel("The sphere", HIGH);
  panel.box.classList.add("idea-orbit");
  panel.box.append(canvas);
  /** @type {Moved} */
  function drag(x, y, begins) {
    if (!begins) look(turn + (x - from[0]) / 120, tip + (y - from[1]) / 120);
    from = [x, y];
  }
  const put_view = panel.backdrop("the view: drag, or press arrow keys, to turn it", [-180, 180], drag, (right, up) =>
    look(clamp(-Math.PI, turn + right / 20, Math.PI), tip - up / 20)
  );
  const row = add_element(stage.root, "div", { class: "idea-states", role: "group", "aria-label": "the normal" });
  const buttons = STATES.map((name, number) =>
    row.appendChild(
      make_button(name, () => {
        shown = number;
        stage.redraw();
      })
    )
  );
  const says = stage.says();

  /** @param {number} to_turn @param {number} to_tip */
  function look(to_turn, to_tip) {
    turn = Math.atan2(Math.sin(to_turn), Math.cos(to_turn));
    tip = clamp(-Math.PI / 2, to_tip, Math.PI / 2);
    stage.redraw();
  }

  /** Let the card draw what stands in a buffer. @param {WebGLBuffer} points @param {number[]} tint */
  const draw = (points, tint) => {
    for (const [place, values] of [points, light[shown]].entries()) {
      gl.bindBuffer(gl.ARRAY_BUFFER, values);
      gl.vertexAttribPointer(place, place ? 1 : 3, gl.FLOAT, false, 0, 0);
      gl.enableVertexAttribArray(place);
    }
    gl.uniform4fv(tint_at, tint);
    if (points === floor) gl.drawArrays(gl.TRIANGLE_FAN, 0, circle.length);
    else gl.drawElements(gl.TRIANGLES, corners.length, gl.UNSIGNED_SHORT, 0);
  };

  return () => {
    const wide = panel.width();
    const size = Math.min(wide / 4.5, HIGH / 3.7); // CSS pixels of the sphere's radius
    set_attributes(canvas, { width: wide * devicePixelRatio, height: HIGH * devicePixelRatio });
    gl.viewport(0, 0, canvas.width, canvas.height);
    const [c, s, ct, st] = [Math.cos(turn), -Math.sin(turn), Math.cos(tip), Math.sin(tip)];
    const [x, y, z] = [(2 * size) / wide, (2 * size) / HIGH, -1 / 8];
    // By columns; the centre is a little above the middle, and to the right of it, where its shadow falls to the left.
    const columns = [-s * x, -st * c * y, ct * c * z, 0, c * x, -st * s * y, ct * s * z, 0, 0, ct * y, st * z, 0];
    gl.uniformMatrix4fv(view_at, false, [...columns, 0.8 * x, 0.19, 0, 1]);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const shape = shapes[Number(shown === DISPLACED)];
    if (tip > 0) {
      draw(floor, GROUND);
      draw(shape.shadow, SHADE);
    }
    draw(shape.points, RED);
    for (const [number, button] of buttons.entries()) button.setAttribute("aria-pressed", String(number === shown));
    const angle = data.angles[shown];
    says.innerHTML = `Off the displaced surface’s normal by <b class="difference">${decimal(angle, angle && angle < 20 ? 1 : 0)}°</b> in the median. ${SAYS[shown]}`;
    const [around, above] = [turn, tip].map((part) => Math.round((part * 180) / Math.PI));
    put_view(around, `turned by ${around}°, from ${above}° above`);
  };
};

// One pixel that the reader picks, worked through: the values of the program's lines, beside their formulas.
"use strict";

IDEAS.pixel_worked = (stage, module, data) => {
  const SIZE = 256;
  const raster = raster_of(SIZE, SIZE);
  const [xs, ys] = module.image_points(raster);
  const outputs = find_all(stage.figure, "[data-line]");
  let column = 104;
  let row = 92;

  /** @param {number} number */
  const say = (number) => (Number.isFinite(number) ? decimal(number, Number.isInteger(number) ? 0 : 4) : "—");

  /** @param {number} x @param {number} y */
  function set(x, y) {
    [column, row] = [x, y].map((at) => clamp(0, Math.floor(at), SIZE - 1));
    stage.redraw();
  }

  const panel = stage.panel("The scene, and the pixel that is worked through", SIZE);
  const canvas = add_element(panel.box, "canvas", {
    width: SIZE,
    height: SIZE,
    role: "img",
    "aria-label": "the chapter's scene"
  });
  panel.box.classList.add("idea-picture");
  const put_pixel = panel.handle("the pixel, column and row", [0, SIZE - 1], set, (right, up) =>
    set(column + right, row - up)
  );
  const swatch = add_element(stage.root, "div", { class: "idea-swatch" });
  const told = stage.says();
  const scene = scene_state(data);
  const part = module.make_stage(scene, raster);
  module.render(scene, EXACT, part);
  module.paint("paint_colors", part, "picture", { whole: true });
  module.put_into(canvas, part, "picture");

  return () => {
    const place = { x: xs[column], y: ys[row] };
    /** @type {Record<string, number>} */
    const lines = { ...place, ...program_lines(module, data, "pixel_lines", { ...data.given, ...place }) };
    const surface = SURFACES[lines.surface];
    for (const output of outputs) {
      const is_off_a = lines.surface !== 1 && output.closest("[data-on-a]");
      output.textContent = is_off_a ? "—" : say(lines[output.dataset.line ?? ""]);
    }
    swatch.style.background = `color(srgb-linear ${lines.rgb_red} ${lines.rgb_green} ${lines.rgb_blue})`;
    told.innerHTML = `Pixel (${column}, ${row}) shows <b>${surface}</b>.`;
    put_pixel([column + 0.5, row + 0.5], column, `column ${column}, row ${row}: ${surface}`);
  };
};

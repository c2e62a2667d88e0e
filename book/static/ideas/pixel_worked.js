// One pixel that the reader picks, worked through: the values of the program's lines, beside their formulas.
"use strict";
var Ideas = Ideas || {};

Ideas.pixel_worked = function (figure, module, data) {
  const SIZE = 256, RASTER = { width: SIZE, height: SIZE, left: 0, top: 0, wide: SIZE, high: SIZE }, [xs, ys] = module.image_points(RASTER), NAMES = ["nothing", "sphere A", "sphere B", "the floor"];
  const outputs = [...figure.querySelectorAll("[data-line]")], says = (number) => (Number.isFinite(number) ? Ideas.say(number, Number.isInteger(number) ? 0 : 4) : "—");
  let column = 104, row = 92;

  const stage = Ideas.stage(figure, draw), panel = stage.panel("The scene, and the pixel that is worked through", SIZE), paint = stage.picture(panel.box, SIZE, "the chapter's scene");
  panel.box.classList.add("idea-picture", "small");
  const on_pixel = panel.handle("the pixel, column and row", (x, y) => set(x, y), (right, up) => set(column + right, row - up)), swatch = Ideas.make(stage.root, "div", { class: "idea-swatch" }), told = stage.says();
  paint(module, Ideas.state(data), RASTER);

  function set(x, y) {
    [column, row] = [x, y].map((at) => Math.max(0, Math.min(SIZE - 1, Math.floor(at))));
    stage.redraw();
  }

  function draw() {
    const place = { x: xs[column], y: ys[row] }, lines = { ...place, ...Ideas.lines(module, data, "pixel_lines", { ...data.given, ...place }) }, rgb = ["red", "green", "blue"].map((name) => lines[`rgb_${name}`]);
    for (const output of outputs) output.textContent = lines.surface !== 1 && output.closest("[data-on-a]") ? "—" : says(lines[output.dataset.line]);
    swatch.style.background = `color(srgb-linear ${rgb.join(" ")})`;
    told.innerHTML = `Pixel (${column}, ${row}) shows <b>${NAMES[lines.surface]}</b>.`;
    on_pixel([column + 0.5, row + 0.5], row * SIZE + column, `column ${column}, row ${row}: ${NAMES[lines.surface]}`);
  }

  stage.begin();
};

// What the small interactives share: a stage in the place of the still picture, panels to draw on, handles and sliders.
// What they show is computed by the simulator's module (book/simulator_module.py); here things are only drawn.
"use strict";
var Ideas = Ideas || {};

Ideas.make = function (parent, name, attributes = {}, text = "") {
  const drawn = ["svg", "g", "circle", "rect"].includes(name), made = drawn ? document.createElementNS("http://www.w3.org/2000/svg", name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.textContent = text;
  return parent.appendChild(made);
};

// A number with so many digits after the point, and a minus sign as print has it; no minus before a zero.
Ideas.say = (number, digits = 2) => {
  const text = number.toFixed(digits);
  return Number(text) === 0 ? text.replace("-", "") : text.replace("-", "−");
};
Ideas.line = (points) => "M" + points.map(([x, y]) => `${x.toFixed(2)} ${y.toFixed(2)}`).join("L");

// An arrow from a point along (dx, dy): a line and its head, at most as long as half the arrow.
Ideas.arrow = ([x, y], [dx, dy], look = "", size = 6) => {
  const length = Math.hypot(dx, dy), head = Math.min(size, length / 2), [a, b] = length ? [(head * dx) / length, (head * dy) / length] : [0, 0], tip = [x + dx, y + dy];
  const wings = [[tip[0] - a - b / 2, tip[1] - b + a / 2], tip, [tip[0] - a + b / 2, tip[1] - b - a / 2]];
  return `<path class="${look}" d="${Ideas.line([[x, y], [tip[0] - a / 2, tip[1] - b / 2]])}"/><path class="${look} head" d="${Ideas.line(wings)}Z"/>`;
};

Ideas.text = (x, y, words, look = "") => `<text class="${look}" x="${x.toFixed(1)}" y="${y.toFixed(1)}">${words}</text>`;

// Every line of a program by its name, from inputs by their names; and three of them as a vector.
Ideas.lines = function (module, { lines }, kernel, inputs) {
  const values = module.kernel(kernel, ...lines[kernel].inputs.map((name) => inputs[name]));
  return Object.fromEntries(lines[kernel].lines.map((name, n) => [name, values[n]]));
};
Ideas.vector = (lines, name, of = "") => ["x", "y", "z"].map((axis) => lines[`${name}_${axis}${of}`]);

const STEPS = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

// Tell `moved` of every place of a pressed pointer, and `stepped` of arrow keys: (right, up), ten times as far with shift.
Ideas.listen = function (target, origin, moved, stepped) {
  const at = (event) => {
    const box = origin.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  target.addEventListener("pointerdown", (event) => {
    if (event.button) return;
    event.stopPropagation();
    target.setPointerCapture(event.pointerId);
    target.focus({ preventScroll: true });
    moved(...at(event), true);
  });
  target.addEventListener("pointermove", (event) => target.hasPointerCapture(event.pointerId) && moved(...at(event), false));
  target.addEventListener("keydown", (event) => {
    if (!(event.key in STEPS) || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    stepped(...STEPS[event.key].map((step) => step * (event.shiftKey ? 10 : 1)));
  });
};

// The stage of a figure: it replaces the still picture as soon as it has been drawn.
Ideas.stage = function (figure, draw) {
  const root = document.createElement("div");
  root.className = "idea-stage";
  let width = 0, asked = 0;

  function redraw() {
    asked = asked || requestAnimationFrame(() => {
      asked = 0;
      if (root.clientWidth) draw();
    });
  }

  // A drawing of a height; `label` says what its group of handles is.
  function panel(label, height, parent = root) {
    const box = Ideas.make(parent, "div", { class: "idea-panel" });
    const svg = Ideas.make(box, "svg", { role: "group", "aria-label": label, height }), lines = Ideas.make(svg, "g", { "aria-hidden": "true" });
    const self = { box, svg, height, get width() { return box.clientWidth; }, show: (markup) => (lines.innerHTML = markup) };
    // Something to drag: `moved` takes a place on the panel, `stepped` arrow keys.
    const dragged = (name, attributes, label, moved, stepped) => {
      const own = Ideas.make(svg, name, { ...attributes, tabindex: 0, role: "slider", "aria-label": label });
      const tell = (now, words) => {
        own.setAttribute("aria-valuenow", now);
        own.setAttribute("aria-valuetext", words);
      };
      Ideas.listen(own, svg, moved, stepped);
      return [own, tell];
    };
    self.handle = (label, moved, stepped, look = "") => {
      const [own, tell] = dragged("g", { class: `idea-handle ${look}` }, label, moved, stepped);
      Ideas.make(own, "circle", { class: "reach", r: 22 });
      Ideas.make(own, "circle", { class: "dot", r: 7 });
      return ([x, y], now, words) => {
        own.setAttribute("transform", `translate(${x.toFixed(2)} ${y.toFixed(2)})`);
        tell(now, words);
      };
    };
    // The ground behind the handles, to be dragged too.
    self.backdrop = (...given) => {
      const [ground, tell] = dragged("rect", { class: "idea-ground", width: "100%", height }, ...given);
      svg.prepend(ground);
      return tell;
    };
    return self;
  }

  // A labelled slider; give(number) sets it.
  function slider(label, { min, max, step, value }, changed, say) {
    const box = Ideas.make(root, "label", { class: "idea-slider" });
    Ideas.make(box, "span", {}, label);
    const input = Ideas.make(box, "input", { type: "range", min, max, step, value }), shown = Ideas.make(box, "output");
    const give = (number) => {
      input.value = number;
      shown.textContent = say(number);
      input.setAttribute("aria-valuetext", say(number));
    };
    input.addEventListener("input", () => {
      give(Number(input.value));
      changed(Number(input.value));
    });
    give(value);
    return give;
  }

  // The renderer's picture of a state in a canvas of so many pixels a side.
  function picture(parent, size, label) {
    const canvas = Ideas.make(parent, "canvas", { width: size, height: size, role: "img", "aria-label": label }), context = canvas.getContext("2d");
    return (module, state, raster) => {
      const { stage } = module.render(state, { name: "exact" }, raster), whole = [0, raster.high];
      module.paint("paint_colors", stage, "picture", { whole: true });
      const bytes = module.bytes(stage, "picture", whole), image = new ImageData(stage.pitch, raster.high);
      image.data.set(bytes);
      context.putImageData(image, 0, 0);
    };
  }

  function begin() {
    figure.querySelector(".pixels").after(root);
    figure.classList.add("idea-live");
    new ResizeObserver(() => {
      if (root.clientWidth !== width) redraw();
      width = root.clientWidth;
    }).observe(root);
  }

  const says = () => Ideas.make(root, "p", { class: "idea-says" });
  return { root, panel, slider, picture, says, redraw, begin };
};

// A state of the simulator with the scene's defaults: field, wave numbers, amplitude, model, sphere B, lights.
Ideas.state = ({ scene }, changes = {}) => {
  const { field, ku, kv, beta, model, ball, lights } = scene;
  return { field, ku, kv, beta, model, ball, lights: lights.map(() => true), ...changes };
};

// The simulator's module, whose `kernel` knows the interactives' own kernels too.
Ideas.compiled = async function () {
  const [module, own] = await Promise.all([[Simulator.data, Simulator], [{ ...Simulator.data, ...Ideas.data }, Ideas]].map(async ([data, { program }]) => Simulator.module(data, await Simulator.compiled(program))));
  return { ...module, kernel: (name, ...inputs) => (name in Ideas.data.kernels ? own : module).kernel(name, ...inputs) };
};

document.addEventListener("DOMContentLoaded", async () => {
  const figures = [...document.querySelectorAll("figure.idea")];
  if (!figures.length) return;
  try {
    const module = (Ideas.module = await Ideas.compiled());
    for (const figure of figures) Ideas[figure.id.replace("fig-", "")](figure, module, { ...Simulator.data, ...Ideas.data });
  } catch (error) {
    if (!/WebAssembly/.test(error.message)) throw error; // without it, the still pictures stay
  }
});

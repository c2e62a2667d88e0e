// What the small interactives share: a stage in the place of the still picture, panels to draw on, handles and sliders.
// What they show is computed by the simulator's module (book/programs/simulator_module.py); here things are only drawn.
"use strict";

/** @type {Record<string, Idea>} */
const IDEAS = {};
const SIDE = 128; // pixels of a small picture
const EXACT = { name: "exact" };
const SURFACES = ["nothing", "sphere A", "sphere B", "the floor"];

/**
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Element} parent
 * @param {Tag} tag
 * @param {Record<string, string | number>} [attributes]
 */
function add_element(parent, tag, attributes, text = "") {
  return parent.appendChild(make_element(tag, attributes, text));
}

/**
 * @template {keyof SVGElementTagNameMap} Tag
 * @param {Element} parent
 * @param {Tag} tag
 * @param {Record<string, string | number>} attributes
 */
function add_shape(parent, tag, attributes) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  set_attributes(made, attributes);
  return parent.appendChild(made);
}

/** A number with so many digits after the point, as print has it; no minus before a zero. @param {number} number */
function decimal(number, digits = 2) {
  const text = number.toFixed(digits);
  return Number(text) === 0 ? text.replace("-", "") : with_minus(text);
}

/** An arrow: a line and its head, at most as long as half the arrow. @param {Point} from @param {Point} to @param {string} look @param {number} size */
function arrow_path([x, y], [end_x, end_y], look, size) {
  const [dx, dy] = [end_x - x, end_y - y];
  const length = Math.hypot(dx, dy);
  const share = length && Math.min(size, length / 2) / length;
  const [a, b] = [share * dx, share * dy];
  const shaft = line_path([
    [x, y],
    [end_x - a / 2, end_y - b / 2]
  ]);
  const head = line_path([
    [end_x - a - b / 2, end_y - b + a / 2],
    [end_x, end_y],
    [end_x - a + b / 2, end_y - b - a / 2]
  ]);
  return path_markup(look, shaft) + path_markup(`${look} head`, `${head}Z`);
}

/**
 * Every line of a program by its name, from inputs by their names.
 * @param {IdeasModule} module
 * @param {IdeasData} data
 * @param {string} name
 * @param {Record<string, number>} inputs
 */
function program_lines(module, data, name, inputs) {
  const program = data.lines[name];
  const values = module.own.kernel(name, ...program.inputs.map((input) => inputs[input]));
  return Object.fromEntries(program.lines.map((line, n) => [line, values[n]]));
}

/** So many pixels a side, of a picture that has as many or more. @param {number} whole */
const raster_of = (whole, side = SIDE) => ({ width: whole, height: whole, left: 0, top: 0, wide: side, high: side });

/** The stage of a figure: it replaces the still picture as soon as it has been drawn. @param {HTMLElement} figure */
function idea_stage(figure) {
  const root = make_element("div", { class: "idea-stage" });
  /** @type {() => void} */
  let draw;
  let width = 0;
  let asked = 0;

  function redraw() {
    asked ||= requestAnimationFrame(() => {
      asked = 0;
      if (root.clientWidth) draw();
    });
  }

  /** A drawing of a height; `label` says what its group of handles is. @param {string} label @param {number} height */
  function panel(label, height, parent = root) {
    const box = add_element(parent, "div", { class: "idea-panel" });
    const svg = add_shape(box, "svg", { role: "group", "aria-label": label, height });
    const drawing = add_shape(svg, "g", { "aria-hidden": "true" });

    /** @param {string} label @param {number[]} range @param {Moved} moved @param {Stepped} stepped */
    function handle(label, range, moved, stepped, look = "") {
      const own = add_shape(svg, "g", { class: `idea-handle ${look}` });
      const tell = as_slider(own, svg, label, range, moved, stepped);
      add_shape(own, "circle", { class: "reach", r: 22 });
      add_shape(own, "circle", { class: "dot", r: 7 });
      return (/** @type {Point} */ [x, y], /** @type {number} */ now, /** @type {string} */ words) => {
        set_attributes(own, { transform: `translate(${x.toFixed(2)} ${y.toFixed(2)})` });
        tell(now, words);
      };
    }

    /** The ground behind the handles, to be dragged too. @param {string} label @param {number[]} range @param {Moved} moved @param {Stepped} stepped */
    function backdrop(label, range, moved, stepped) {
      const own = add_shape(svg, "rect", { class: "idea-ground", width: "100%", height });
      svg.prepend(own);
      return as_slider(own, svg, label, range, moved, stepped);
    }

    /** @param {string} markup */
    function show(markup) {
      drawing.innerHTML = markup;
    }
    return { box, svg, handle, backdrop, show, width: () => box.clientWidth };
  }

  /**
   * A labelled slider; return what sets it from elsewhere.
   * @param {string} label
   * @param {{ min: number, max: number, step: number, value: number }} range
   * @param {(number: number) => void} changed
   * @param {(number: number) => string} say
   */
  function slider(label, range, changed, say = (number) => decimal(number, 3)) {
    const box = add_element(root, "label", { class: "idea-slider" });
    add_element(box, "span", {}, label);
    const input = add_element(box, "input", { type: "range", ...range });
    const shown = add_element(box, "output");
    /** @param {number} number */
    function put(number) {
      input.value = String(number);
      shown.textContent = say(number);
      input.setAttribute("aria-valuetext", say(number));
    }
    input.addEventListener("input", () => {
      put(input.valueAsNumber);
      changed(input.valueAsNumber);
      redraw();
    });
    put(range.value);
    return put;
  }

  /** Three small pictures beside each other, with their names; return what shows those of a stage. @param {string[]} names */
  function three(...names) {
    const row = add_element(root, "div", { class: "idea-three" });
    for (const [n, name] of names.entries()) add_element(row, "b", { class: PICTURES[n] }, name);
    const canvases = names.map((name) =>
      add_element(row, "canvas", { width: SIDE, height: SIDE, role: "img", "aria-label": name })
    );
    /** @param {SimulatorModule} module @param {Stage} part */
    return (module, part) => {
      for (const [n, picture] of PICTURES.entries()) module.put_into(canvases[n], part, picture);
    };
  }

  /** @param {() => void} drawing */
  function begin(drawing) {
    draw = drawing;
    find_element(figure, ".pixels").after(root);
    figure.classList.add("idea-live");
    new ResizeObserver(() => {
      if (root.clientWidth !== width) redraw();
      width = root.clientWidth;
    }).observe(root);
  }

  return {
    figure,
    root,
    panel,
    slider,
    three,
    says: () => add_element(root, "p", { class: "idea-says" }),
    redraw,
    begin
  };
}

/** The scene as a state of the simulator, with changes. @param {SimulatorData} data @param {Partial<SceneState>} [changes] */
function scene_state({ scene }, changes) {
  return { ...scene, lights: scene.lights.map(() => true), ...changes };
}

/** The simulator's module, with another one for the interactives' own kernels. @param {AllData} data */
async function ideas_module(data) {
  const [programs, own] = await Promise.all([Simulator.program, Ideas.program].map(compiled_program));
  return { ...(await simulator_module(Simulator.data, programs)), own: await simulator_module(data, own) };
}

/** Bring a figure to life. @param {HTMLElement} figure */
async function enliven(figure) {
  const data = { ...Simulator.data, ...Ideas.data };
  try {
    Ideas.module ??= ideas_module(data);
    const module = await Ideas.module;
    const stage = idea_stage(figure);
    const draw = IDEAS[figure.id.replace("fig-", "")](stage, module, data);
    if (draw) stage.begin(draw);
  } catch (error) {
    if (!error_text(error).includes("WebAssembly")) throw error; // without it, the still pictures stay
  }
}

// Not before each idea's own script has run, which comes after this one.
document.addEventListener("DOMContentLoaded", () => when_near(find_all(document, ".idea"), enliven));

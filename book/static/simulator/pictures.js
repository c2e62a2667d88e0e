// The three pictures: pixels from the page or from the workers, over them the exact loci of the creases and the cursor.
"use strict";

/**
 * @param {HTMLElement} root
 * @param {States} states
 * @param {SimulatorData} data
 * @param {SimulatorModule} module
 */
function simulator_pictures(root, states, data, module) {
  const POINTS = 257;
  const HEAD = 33; // bytes of a PNG's signature and first chunk
  const along = float64s(POINTS, (n) => n / (POINTS - 1));
  const boxes = PICTURES.map((name) => find_element(root, `[data-picture="${name}"]`));
  /** @param {string} selector @returns {HTMLCanvasElement[]} */
  const canvases = (selector) => boxes.map((box) => find_element(box, selector));
  const overlays = canvases(".over");
  /** @type {HTMLCanvasElement[]} */
  const covers = find_all(root, ".sim-bounds");
  const scale = simulator_scale(root, data);
  // What the page draws while something moves, and what the workers draw when it rests, each in canvases of its own:
  // a drawer sends what has changed since its last picture.
  const [by_page, by_workers] = [
    canvases(".pixels"),
    canvases(".pixels").map((canvas) => /** @type {HTMLCanvasElement} */ (canvas.cloneNode()))
  ].map((bases) => ({
    bases,
    mask: document.createElement("canvas"),
    levels: new Uint8Array(),
    side: 0
  }));
  let seen = by_page;
  /** @type {State | null} */
  let shown = null;
  /** @type {Uint8Array[]} */
  let bounds = [];
  let sides = [0, 0, 0]; // of the boxes, in pixels of the screen: asked for when they change, since to ask takes a layout
  let decorated = "";

  /** @param {HTMLCanvasElement} canvas */
  const context_of = (canvas, alpha = true) =>
    /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d", { alpha }));

  /** @param {HTMLCanvasElement} canvas @param {number} side */
  function resize(canvas, side) {
    canvas.width = side;
    canvas.height = side;
  }

  /** Put what was drawn of a band into its canvases. @param {Drawn} reply @param {boolean} is_pages */
  function paint({ images, band, part, codes }, is_pages) {
    const into = is_pages ? by_page : by_workers;
    if (into.side !== band.wide) {
      into.side = band.wide;
      into.levels = new Uint8Array(4 * band.wide * band.wide);
      for (const canvas of [...into.bases, into.mask]) resize(canvas, band.wide);
    }
    for (const [name, { top, bytes }] of Object.entries(images)) {
      const first = part.begin + top;
      if (name === "difference") into.levels.set(bytes, 4 * first * band.wide);
      else if (bytes.length)
        context_of(into.bases[PICTURES.indexOf(name)], false).putImageData(new ImageData(bytes, band.wide), 0, first);
    }
    if (!codes) return;
    const on_a = new ImageData(band.wide, band.high);
    for (let i = 0; i < codes.length; i++) on_a.data[4 * i + 3] = module.is_on_a(codes[i]) ? 255 : 0;
    context_of(into.mask).putImageData(on_a, 0, part.begin);
    decorated = "";
  }

  /** Show what the page or the workers have painted. @param {State} state @param {boolean} is_pages */
  function show(state, is_pages) {
    const now = is_pages ? by_page : by_workers;
    for (const [n, canvas] of now.bases.entries()) if (now !== seen) seen.bases[n].replaceWith(canvas);
    seen = now;
    shown = state;
    scale.choose(state.scale, seen.levels);
    draw();
  }

  // The difference in as many pixels as the screen has for it; the others as they are.
  function fit() {
    if (!shown) return;
    for (const [n, canvas] of seen.bases.entries()) {
      const room = sides[n] || seen.side;
      if (PICTURES[n] === "difference") put_difference(canvas, Math.min(seen.side, room));
      canvas.classList.toggle("smooth", canvas.width > room / 2 && room % canvas.width > 0);
    }
  }

  /** @param {HTMLCanvasElement} canvas @param {number} wide */
  function put_difference(canvas, wide) {
    const image = scale.colored(seen.levels, seen.side, wide);
    if (canvas.width !== image.width) resize(canvas, image.width);
    context_of(canvas, false).putImageData(image, 0, 0);
  }

  /**
   * Draw the creases as far as they are seen, over A alone.
   * @param {CanvasRenderingContext2D} context
   * @param {State} state
   */
  function draw_loci(context, state) {
    const place = module.placing_in(states.crop(state));
    const { eye, radius } = data.scene;
    const { width } = context.canvas;
    const zoom = width / state.size;
    /** @param {number} x @param {number} y @returns {Point} */
    const scaled = (x, y) => {
      const [right, below] = place(x, y);
      return [right * zoom, below * zoom];
    };
    let path = "";
    for (const { a, b, level } of module.crease_lines(state)) {
      const [x, y] = module.kernel_over("crease_point", a, b, level, along, eye, radius);
      path += line_path(Array.from(x, (_, n) => scaled(x[n], y[n])));
    }
    context.lineWidth = Math.max(1, width / context.canvas.clientWidth);
    context.strokeStyle = "white";
    context.stroke(new Path2D(path));
    context.globalCompositeOperation = "destination-in";
    context.imageSmoothingEnabled = false;
    context.drawImage(seen.mask, 0, 0, width, width);
    context.globalCompositeOperation = "source-over";
  }

  // Put the cursor's mark where it is, and draw the creases over the pictures, if they have changed.
  function decorate(state = shown) {
    if (!shown || !state) return;
    const { size, zoom, left, top, view, field, ku, kv } = shown;
    const [across, down] = states.share_of_cursor({ ...shown, column: state.column, row: state.row });
    root.style.setProperty("--across", `${100 * across}%`);
    root.style.setProperty("--down", `${100 * down}%`);
    const key = [size, zoom, left, top, view, field, ku, kv, ...sides].join();
    if (key === decorated) return;
    decorated = key;
    for (const [n, canvas] of overlays.entries()) {
      canvas.hidden = view !== "loci";
      resize(canvas, sides[n]);
      if (!canvas.hidden && canvas.width) draw_loci(context_of(canvas), shown);
    }
  }

  // The bounds of either picture's colours over it, in as many pixels as the screen has: one that is open stays seen.
  function fit_bounds() {
    for (const [n, canvas] of covers.entries()) {
      canvas.hidden = !bounds.length;
      if (canvas.hidden) continue;
      const side = bounds[n].length ** 0.5;
      const image = scale.bounds(bounds[n], side, Math.min(side, sides[n] || side));
      resize(canvas, image.width);
      context_of(canvas).putImageData(image, 0, 0);
    }
  }

  /** Show levels of bounds, or none. @param {Uint8Array[]} maps */
  function show_bounds(maps) {
    bounds = maps;
    fit_bounds();
  }

  function resized() {
    sides = boxes.map((box) => Math.round(box.clientWidth * (window.devicePixelRatio || 1)));
    draw();
  }

  function draw() {
    fit();
    fit_bounds();
    decorate();
  }

  /** A picture with all of its pixels. @param {string} name */
  function canvas_of(name) {
    const canvas = seen.bases[PICTURES.indexOf(name)];
    if (name !== "difference") return canvas;
    const whole = document.createElement("canvas");
    put_difference(whole, seen.side);
    return whole;
  }

  /** A picture as a PNG that says how it was drawn, as the renderer's own do (tEXt). @param {string} name @param {State} state */
  function file(name, state) {
    const url = canvas_of(name).toDataURL();
    if (name === "difference") return url;
    const bytes = Uint8Array.from(atob(url.slice(url.indexOf(",") + 1)), (sign) => sign.charCodeAt(0));
    const kept = text_chunk(JSON.stringify(states.record(state, name === "numeric")));
    const all = [...bytes.subarray(0, HEAD), ...kept, ...bytes.subarray(HEAD)];
    return URL.createObjectURL(new Blob([Uint8Array.from(all)], { type: "image/png" }));
  }

  return { boxes, file, paint, show, show_bounds, decorate, resized, canvas: canvas_of, still: scale.still };
}

/** A PNG's chunk of text under the renderer's own word. @param {string} text */
function text_chunk(text) {
  const content = new TextEncoder().encode(`tEXtsymbolic-rendering\0${text}`);
  let check = ~0;
  for (const byte of content) {
    check ^= byte;
    for (let bit = 0; bit < 8; bit++) check = (check >>> 1) ^ (check & 1 ? 0xedb88320 : 0);
  }
  const chunk = new DataView(new ArrayBuffer(content.length + 8));
  chunk.setUint32(0, content.length - 4);
  new Uint8Array(chunk.buffer).set(content, 4);
  chunk.setUint32(content.length + 4, ~check);
  return new Uint8Array(chunk.buffer);
}

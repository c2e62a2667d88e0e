// The three pictures: pixels from the workers, over them the exact loci of the creases and the pixel cursor; zoom.
"use strict";

/**
 * @param {HTMLElement} root
 * @param {States} states
 * @param {SimulatorData} data
 * @param {SimulatorModule} module
 * @param {Act} act
 */
function simulator_pictures(root, states, data, module, act) {
  const NAMES = ["numeric", "symbolic", "difference"];
  const SURFACE = 3;
  const A = 1;
  const GAP = 8;
  const POINTS = 257;
  const along = float64s(POINTS, (n) => n / (POINTS - 1));
  const boxes = NAMES.map((name) => find_element(root, `[data-picture="${name}"]`));
  const strip = find_element(root, ".sim-pictures");
  /** @param {string} selector @returns {HTMLCanvasElement[]} */
  const canvases = (selector) => boxes.map((box) => find_element(box, selector));
  const [bases, overlays] = [".pixels", ".over"].map(canvases);
  const mask = document.createElement("canvas");
  /** @type {State | null} */
  let shown = null;
  /** @type {{ x: number, y: number, left: number, top: number, moved: boolean } | null} */
  let dragged = null; // where the button went down, as long as it is
  let pinned = false;
  let decorated = "";

  /** @param {HTMLCanvasElement} canvas */
  const context_of = (canvas, alpha = true) =>
    /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d", { alpha }));

  // All three have one size, whatever their raster is: the largest power of two of the screen's pixels for which there
  // is room. So a pixel of the raster is a whole number of the screen's, or the other way round.
  function layout() {
    const dpr = window.devicePixelRatio || 1;
    const beside = getComputedStyle(strip).overflowX !== "auto";
    const room = beside ? (strip.clientWidth - 2 * GAP) / 3 : strip.clientWidth;
    const whole = 2 ** Math.floor(Math.log2(room * dpr)) / dpr;
    const side = whole < 0.66 * room ? Math.floor(room) : whole;
    root.style.setProperty("--side", `${side}px`);
    for (const canvas of overlays) resize(canvas, Math.round(side * dpr));
    for (const canvas of bases)
      canvas.classList.toggle("smooth", canvas.width > side * dpr || (side * dpr) % canvas.width !== 0);
    decorated = "";
    decorate();
  }

  /** @param {HTMLCanvasElement} canvas @param {number} side */
  function resize(canvas, side) {
    canvas.width = side;
    canvas.height = side;
  }

  /** @param {State} state @param {Drawn[]} replies */
  function paint(state, replies) {
    const resized = !shown || bases[0].width !== state.size;
    if (resized) for (const canvas of [...bases, mask]) resize(canvas, state.size);
    for (const { images, band, codes } of replies) {
      const begin = band.top - state.top;
      for (const [name, { top, bytes }] of Object.entries(images)) {
        if (bytes.length)
          context_of(canvas_of(name), false).putImageData(new ImageData(bytes, band.wide), 0, begin + top);
      }
      if (!codes) continue;
      const on_a = new ImageData(band.wide, band.high);
      for (let i = 0; i < codes.length; i++) on_a.data[4 * i + 3] = (codes[i] & SURFACE) === A ? 255 : 0;
      context_of(mask).putImageData(on_a, 0, begin);
      decorated = "";
    }
    shown = state;
    if (resized) layout();
  }

  /**
   * Draw the creases as far as they are seen, over A alone.
   * @param {CanvasRenderingContext2D} context
   * @param {State} state
   * @param {number} scale
   */
  function draw_loci(context, state, scale) {
    const place = module.placing_in(states.crop(state));
    const { eye, radius } = data.scene;
    context.beginPath();
    for (const { a, b, level } of module.crease_lines(state)) {
      const [x, y] = module.kernel_over("crease_point", a, b, level, along, eye, radius);
      let drawing = false;
      for (let n = 0; n < POINTS; n++) {
        const is_seen = !Number.isNaN(x[n]);
        const [right, below] = place(x[n], y[n]).map((at) => at * scale);
        if (is_seen && drawing) context.lineTo(right, below);
        else if (is_seen) context.moveTo(right, below);
        drawing = is_seen;
      }
    }
    context.lineWidth = Math.max(1, window.devicePixelRatio || 1);
    context.strokeStyle = "white";
    context.stroke();
    context.globalCompositeOperation = "destination-in";
    context.imageSmoothingEnabled = false;
    context.drawImage(mask, 0, 0, context.canvas.width, context.canvas.height);
    context.globalCompositeOperation = "source-over";
  }

  // Put the cursor's mark where it is, and draw the creases over the pictures, if they have changed.
  function decorate(state = shown) {
    if (!shown || !state) return;
    const { size, zoom, left, top, view, field, ku, kv } = shown;
    const key = [size, zoom, left, top, view === "loci", field, ku, kv].join();
    const [across, down] = states.share_of_cursor({ ...shown, column: state.column, row: state.row });
    root.style.setProperty("--across", `${100 * across}%`);
    root.style.setProperty("--down", `${100 * down}%`);
    if (key === decorated) return;
    decorated = key;
    for (const canvas of overlays) {
      const context = context_of(canvas);
      canvas.hidden = view !== "loci";
      context.clearRect(0, 0, canvas.width, canvas.height);
      if (view === "loci") draw_loci(context, shown, canvas.width / size);
    }
  }

  // Pointer and keys
  /** @param {MouseEvent} event @param {HTMLElement} box */
  function share(event, box) {
    const { x, y, width, height } = pointer_in(box, event);
    return [x / width, y / height];
  }

  /** @param {PointerEvent} event @param {HTMLElement} box */
  function point(event, box) {
    const { size, left, top } = act.state();
    const [across, down] = share(event, box).map((part) => clamp(0, Math.floor(part * size), size - 1));
    act.put({ column: left + across, row: top + down });
  }

  /** @param {PointerEvent} event @param {HTMLElement} box */
  function drag(event, box) {
    if (!dragged) return;
    const pixels = act.state().size / box.getBoundingClientRect().width;
    const dx = (event.clientX - dragged.x) * pixels;
    const dy = (event.clientY - dragged.y) * pixels;
    if (Math.abs(dx) + Math.abs(dy) < 3) return;
    dragged.moved = true;
    act.put({ left: dragged.left - dx, top: dragged.top - dy });
  }

  /** @param {KeyboardEvent} event */
  function press(event) {
    const arrow = arrow_of(event);
    if (arrow) {
      pinned = true;
      act.move([arrow[0], -arrow[1]]);
    } else if (["+", "=", "-"].includes(event.key) && !is_shortcut(event)) act.zoom(event.key === "-" ? -1 : 1);
    else return;
    event.preventDefault();
  }

  /** @param {HTMLElement} box */
  function wire(box) {
    box.addEventListener("pointerdown", ({ clientX: x, clientY: y }) => {
      const { left, top } = act.state();
      dragged = { x, y, left, top, moved: false };
    });
    box.addEventListener("pointermove", (event) => {
      if (event.pointerType !== "mouse") return;
      if (dragged && act.state().zoom > 0) drag(event, box);
      else if (!pinned) point(event, box);
    });
    box.addEventListener("pointerup", (event) => {
      if (dragged && !dragged.moved) {
        pinned = event.pointerType !== "mouse" || !pinned;
        point(event, box);
      }
      dragged = null;
    });
    for (const end of ["pointercancel", "pointerleave"]) {
      box.addEventListener(end, () => {
        dragged = null;
      });
    }
    const wheel = (/** @type {WheelEvent} */ event) => {
      if (!event.ctrlKey && document.activeElement !== box) return; // else the page scrolls
      event.preventDefault();
      act.zoom(event.deltaY < 0 ? 1 : -1, share(event, box));
    };
    box.addEventListener("wheel", wheel, { passive: false });
    box.addEventListener("keydown", press);
  }

  /** @param {string} name */
  const canvas_of = (name) => bases[NAMES.indexOf(name)];
  function release() {
    pinned = false;
  }

  boxes.forEach(wire);
  new ResizeObserver(() => shown && layout()).observe(root);
  return { paint, decorate, release, canvas: canvas_of };
}

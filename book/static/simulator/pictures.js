// The three pictures: pixels from the workers, over them the exact loci of the creases and the pixel cursor; zoom.
"use strict";

Simulator.pictures = function (root, states, data, module, act) {
  const NAMES = ["numeric", "symbolic", "difference"], SURFACE = 3, A = 1, GAP = 8, POINTS = 257;
  const boxes = NAMES.map((name) => root.querySelector(`[data-picture="${name}"]`)), strip = root.querySelector(".sim-pictures");
  const bases = boxes.map((box) => box.querySelector(".pixels")), overlays = boxes.map((box) => box.querySelector(".over"));
  const mask = document.createElement("canvas"), along = Float64Array.from({ length: POINTS }, (_, n) => n / (POINTS - 1));
  let shown = null, pinned = false, decorated = "";

  // All three have one size, whatever their raster is: the largest power of two of the screen's pixels for which there
  // is room. So a pixel of the raster is a whole number of the screen's, or the other way round.
  function layout() {
    const dpr = window.devicePixelRatio || 1, beside = getComputedStyle(strip).overflowX !== "auto";
    const room = beside ? (strip.clientWidth - 2 * GAP) / 3 : strip.clientWidth, whole = 2 ** Math.floor(Math.log2(room * dpr)) / dpr;
    const side = whole < 0.66 * room ? Math.floor(room) : whole;
    root.style.setProperty("--side", `${side}px`);
    for (const canvas of overlays) canvas.width = canvas.height = Math.round(side * dpr);
    for (const canvas of bases) canvas.classList.toggle("smooth", canvas.width > side * dpr || (side * dpr) % canvas.width !== 0);
    decorated = "";
    decorate();
  }

  function paint(state, replies) {
    const resized = !shown || bases[0].width !== state.size;
    if (resized) for (const canvas of [...bases, mask]) canvas.width = canvas.height = state.size;
    for (const { images, band, codes } of replies) {
      const begin = band.top - state.top;
      for (const [name, { top, bytes }] of Object.entries(images)) {
        if (bytes.length) bases[NAMES.indexOf(name)].getContext("2d", { alpha: false }).putImageData(new ImageData(bytes, band.wide), 0, begin + top);
      }
      if (!codes) continue;
      const on_a = new ImageData(band.wide, band.high);
      for (let i = 0; i < codes.length; i++) on_a.data[4 * i + 3] = (codes[i] & SURFACE) === A ? 255 : 0;
      mask.getContext("2d").putImageData(on_a, 0, begin);
      decorated = "";
    }
    shown = state;
    if (resized) layout();
  }

  // Where the image point (0, 0) is, in pixels of the raster from its corner, and how long a unit is.
  function frame(state) {
    const side = states.side(state), [x, y] = module.image_points({ width: side, height: side, left: 0, top: 0, wide: 2, high: 2 });
    const unit = 1 / (x[1] - x[0]);
    return { across: 0.5 - x[0] * unit, down: 0.5 + y[0] * unit, unit };
  }

  // The creases, where their factors say (theorem kink_loci): sinpi(a u + b v + c) is zero where that is a whole number.
  function draw_loci(context, state, scale) {
    const { across, down, unit } = frame(state), { eye, radius } = data.scene;
    context.beginPath();
    for (const { a, b, c } of module.creases(state)) {
      const ends = [c, c + a, c + b, c + a + b], last = Math.floor(Math.max(...ends));
      for (let level = Math.ceil(Math.min(...ends)); level <= last && (a || b); level++) {
        const [x, y] = module.kernel("crease_point", a, b, level - c, along, eye, radius);
        for (let n = 0, drawing = false; n < POINTS; n++) {
          const at = [(across - state.left + x[n] * unit) * scale, (down - state.top - y[n] * unit) * scale];
          if (!isNaN(x[n])) drawing ? context.lineTo(...at) : context.moveTo(...at);
          drawing = !isNaN(x[n]);
        }
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
    const { size, zoom, left, top, view, field, ku, kv } = shown, key = [size, zoom, left, top, view === "loci", field, ku, kv].join();
    const within = (at, begin) => `${(100 * (at - begin + 0.5)) / size}%`;
    root.style.setProperty("--across", within(state.column, left));
    root.style.setProperty("--down", within(state.row, top));
    if (key === decorated) return;
    decorated = key;
    for (const canvas of overlays) {
      const context = canvas.getContext("2d");
      canvas.hidden = view !== "loci";
      context.clearRect(0, 0, canvas.width, canvas.height);
      if (view === "loci") draw_loci(context, shown, canvas.width / size);
    }
  }

  // Pointer and keys
  const share = (event, box) => {
    const edge = box.getBoundingClientRect();
    return [(event.clientX - edge.left) / edge.width, (event.clientY - edge.top) / edge.height];
  };
  const point = (event, box) => {
    const [across, down] = share(event, box).map((s) => Math.max(0, Math.min(shown.size - 1, Math.floor(s * shown.size))));
    act.cursor(shown.left + across, shown.top + down);
  };

  let dragged = null; // where the button went down, as long as it is

  function wire(box) {
    box.addEventListener("pointerdown", (event) => {
      dragged = { x: event.clientX, y: event.clientY, left: shown.left, top: shown.top, moved: false };
    });
    box.addEventListener("pointermove", (event) => {
      if (event.pointerType !== "mouse") return;
      if (dragged && shown.zoom > 0) drag(event, box);
      else if (!pinned) point(event, box);
    });
    box.addEventListener("pointerup", (event) => {
      if (dragged && !dragged.moved) {
        pinned = event.pointerType === "mouse" ? !pinned : true;
        point(event, box);
      }
      dragged = null;
    });
    for (const end of ["pointercancel", "pointerleave"]) box.addEventListener(end, () => (dragged = null));
    box.addEventListener("wheel", (event) => {
      if (!event.ctrlKey && document.activeElement !== box) return; // else the page scrolls
      event.preventDefault();
      act.zoom(event.deltaY < 0 ? 1 : -1, ...share(event, box));
    }, { passive: false });
    box.addEventListener("keydown", keys);
  }

  function drag(event, box) {
    const pixels = shown.size / box.getBoundingClientRect().width;
    const dx = (event.clientX - dragged.x) * pixels, dy = (event.clientY - dragged.y) * pixels;
    if (Math.abs(dx) + Math.abs(dy) < 3) return;
    dragged.moved = true;
    act.pan(dragged.left - dx, dragged.top - dy);
  }

  function keys(event) {
    const far = event.shiftKey ? 10 : 1;
    const moves = { ArrowLeft: [-far, 0], ArrowRight: [far, 0], ArrowUp: [0, -far], ArrowDown: [0, far] };
    if (moves[event.key] && !event.ctrlKey && !event.altKey && !event.metaKey) {
      pinned = true;
      act.move(...moves[event.key]);
    } else if (["+", "=", "-"].includes(event.key) && !event.ctrlKey && !event.metaKey) act.zoom(event.key === "-" ? -1 : 1);
    else return;
    event.preventDefault();
  }

  boxes.forEach(wire);
  new ResizeObserver(() => shown && layout()).observe(root);
  return { paint, decorate, frame, release: () => (pinned = false), canvas: (name) => bases[NAMES.indexOf(name)] };
};

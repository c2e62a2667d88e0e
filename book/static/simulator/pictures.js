// The three pictures: pixels from the workers, over them the exact loci of the creases and the pixel cursor; zoom.
"use strict";
var Simulator = Simulator || {};

Simulator.pictures = function (root, states, data, module, act) {
  const NAMES = ["numeric", "symbolic", "difference"];
  const boxes = NAMES.map((name) => root.querySelector(`[data-picture="${name}"]`));
  const bases = boxes.map((box) => box.querySelector(".pixels")), overlays = boxes.map((box) => box.querySelector(".over"));
  const mask = document.createElement("canvas");
  let shown = null, pinned = false;

  // A pixel of the raster is a whole number of the screen's pixels; side by side where three fit.
  function layout(size) {
    const room = root.querySelector(".sim-pictures").clientWidth, dpr = window.devicePixelRatio || 1;
    const gap = 16, third = (room - 2 * gap) / 3, one = size / dpr;
    const beside = one <= third, space = beside ? third : Math.min(room, 512);
    const side = Math.max(1, Math.floor(space / one)) * one;
    root.classList.toggle("sim-stacked", !beside);
    root.style.setProperty("--side", `${side}px`);
    for (const canvas of overlays) canvas.width = canvas.height = Math.round(side * dpr);
    decorate();
  }

  function paint(state, replies) {
    const resized = !shown || bases[0].width !== state.size;
    if (resized) for (const canvas of [...bases, mask]) canvas.width = canvas.height = state.size;
    for (const { images, band, codes } of replies) {
      const top = band.top - state.top;
      for (const [name, pixels] of Object.entries(images)) {
        const bytes = new Uint8ClampedArray(pixels.buffer);
        bases[NAMES.indexOf(name)].getContext("2d").putImageData(new ImageData(bytes, band.wide), 0, top);
      }
      if (codes) {
        const on_a = new ImageData(band.wide, band.high);
        for (let i = 0; i < codes.length; i++) on_a.data[4 * i + 3] = (codes[i] & 3) === 1 ? 255 : 0;
        mask.getContext("2d").putImageData(on_a, 0, top);
      }
    }
    shown = state;
    if (resized) layout(state.size);
    else decorate();
  }

  // Where the image point (0, 0) is, in pixels of the raster from its corner, and how long a unit is.
  function frame(state) {
    const side = states.side(state), [x, y] = module.image_points({ width: side, height: side, left: 0, top: 0, wide: 2, high: 2 });
    const unit = 1 / (x[1] - x[0]);
    return { across: 0.5 - x[0] * unit, down: 0.5 + y[0] * unit, unit };
  }

  // The creases, exactly: rays where u is m/k_u, circles where v is m/k_v (theorem kink_loci).
  function draw_loci(context, state, scale) {
    const { across, down, unit } = frame(state), { eye, radius } = data.scene;
    const center = [(across - state.left) * scale, (down - state.top) * scale], reach = 2 * states.side(state) * scale;
    context.beginPath();
    for (const [coordinate, of_ku, of_kv] of data.fields[state.field].creases) {
      const k = Math.abs(of_ku * state.ku + of_kv * state.kv);
      for (let m = 0; m < k; m++) {
        if (coordinate === "u") {
          const theta = 2 * Math.PI * (m / k) - Math.PI;
          context.moveTo(...center);
          context.lineTo(center[0] + reach * Math.cos(theta), center[1] - reach * Math.sin(theta));
        } else if (m > 0 && Math.cos((Math.PI * m) / k) > radius / eye) {
          const phi = (Math.PI * m) / k, rho = module.kernel("parallel_radius", Math.sin(phi), Math.cos(phi), eye, radius);
          context.moveTo(center[0] + rho * unit * scale, center[1]);
          context.arc(...center, rho * unit * scale, 0, 2 * Math.PI);
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

  function draw_cursor(context, state, scale) {
    const x = (state.column - state.left + 0.5) * scale, y = (state.row - state.top + 0.5) * scale;
    const gap = Math.max(scale / 2 + 1, 3), arm = gap + 7 * (window.devicePixelRatio || 1);
    for (const [color, width] of [["black", 3], ["white", 1]]) {
      context.beginPath();
      for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
        context.moveTo(x + dx * gap, y + dy * gap);
        context.lineTo(x + dx * arm, y + dy * arm);
      }
      context.strokeStyle = color;
      context.lineWidth = width * (window.devicePixelRatio || 1);
      context.stroke();
    }
  }

  function decorate(state = shown) {
    if (!shown || !state) return;
    for (const canvas of overlays) {
      const context = canvas.getContext("2d"), scale = canvas.width / shown.size;
      context.clearRect(0, 0, canvas.width, canvas.height);
      if (shown.view === "loci") draw_loci(context, shown, scale);
      draw_cursor(context, { ...shown, column: state.column, row: state.row }, scale);
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

  const touches = new Map();
  let spread = 0, dragged = null;

  function wire(box) {
    box.addEventListener("pointerdown", (event) => {
      touches.set(event.pointerId, event);
      if (touches.size === 2) spread = distance();
      dragged = { x: event.clientX, y: event.clientY, left: shown.left, top: shown.top, moved: false };
    });
    box.addEventListener("pointermove", (event) => {
      if (touches.has(event.pointerId)) touches.set(event.pointerId, event);
      if (touches.size === 2) pinch(box);
      else if (touches.size === 1 && event.pointerType === "mouse" && shown.zoom > 0) drag(event, box);
      else if (!pinned && event.pointerType === "mouse") point(event, box);
    });
    box.addEventListener("pointerup", (event) => {
      if (touches.size === 1 && !dragged?.moved) {
        pinned = event.pointerType === "mouse" ? !pinned : true;
        point(event, box);
      }
    });
    for (const end of ["pointerup", "pointercancel", "pointerleave"]) box.addEventListener(end, (event) => touches.delete(event.pointerId));
    box.addEventListener("wheel", (event) => {
      if (!event.ctrlKey && document.activeElement !== box) return; // else the page scrolls
      event.preventDefault();
      act.zoom(event.deltaY < 0 ? 1 : -1, ...share(event, box));
    }, { passive: false });
    box.addEventListener("keydown", keys);
  }

  const distance = () => {
    const [a, b] = [...touches.values()];
    return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
  };

  function pinch(box) {
    const now = distance(), steps = Math.trunc(2 * Math.log2(now / spread));
    if (!steps) return;
    spread = now;
    const [a, b] = [...touches.values()];
    act.zoom(steps, ...share({ clientX: (a.clientX + b.clientX) / 2, clientY: (a.clientY + b.clientY) / 2 }, box));
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
  new ResizeObserver(() => shown && layout(shown.size)).observe(root);
  const release = () => (pinned = false);
  return { paint, decorate, frame, release, canvas: (name) => bases[NAMES.indexOf(name)] };
};

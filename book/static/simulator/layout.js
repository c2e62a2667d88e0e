// How large the simulator and its pictures are: as wide as the window lets them be, with the pictures, the curve, the
// step and the pixel in one screen.
"use strict";

/** @param {HTMLElement} root @param {() => void} resized is told when the pictures have another size */
function simulator_layout(root, resized) {
  const NARROW = 700; // pixels; a phone has less
  const BESIDE = 440; // that the curve and the step need beside a picture
  const PIXEL = 600; // that the pixel's table needs there
  const TABLE = 150; // of its height below
  const TITLE = 26;
  const PLOT = 252; // the least height of curve, stills and step, with the difference's scale
  const COMPACT = 900; // has the curve below the pictures, and the pixel beside that
  const SCENE = 176; // the least width of the sliders; a little more where there is room
  const GAP = 16;
  const LEAST = 128; // of a picture's side: a low window is scrolled
  const stage = find_element(root, ".sim-stage");
  const [apart, large] = ["apart", "large"].map((name) => find_element(root, `[data-${name}]`));
  large.hidden = !document.fullscreenEnabled;
  const page = root.closest("main") ?? document.body;
  let is_apart = false;
  let last = "";

  /** The largest side for which there is room, if it can be in whole multiples of the raster's pixels. @param {number} room @param {number} size */
  function side_for(room, size) {
    const ratio = window.devicePixelRatio || 1;
    const pixels = Math.max(LEAST, room) * ratio;
    const whole = pixels >= size ? Math.floor(pixels / size) * size : size / 2 ** Math.ceil(Math.log2(size / pixels));
    return (whole < 0.66 * pixels ? Math.floor(pixels) : whole) / ratio;
  }

  // Break out of the text's column, to the window's edge.
  function spread() {
    const { left } = page.getBoundingClientRect();
    const width = document.documentElement.clientWidth - left;
    const edge = width < NARROW ? 8 : 24;
    const shift = left + edge - root.getBoundingClientRect().left + (parseFloat(root.style.marginLeft) || 0);
    root.style.marginLeft = `${shift}px`;
    root.style.width = `${width - 2 * edge}px`;
  }

  /** The sides of the wiper's picture, or of all three, and of the difference; whether the pixel stands beside. @param {number} size */
  function sides(size) {
    const wide = stage.clientWidth;
    const above = stage.getBoundingClientRect().top - root.getBoundingClientRect().top;
    const bar =
      document.fullscreenElement === root ? 0 : (document.querySelector(".bd-header-article")?.clientHeight ?? 0);
    const high = window.innerHeight - bar - above - TITLE;
    /** @param {number} room */
    function alike(room) {
      const side = side_for(room, size);
      return { side, small: side, is_tall: false };
    }
    if (wide < NARROW) return alike(wide);
    if (is_apart) return alike(Math.min((wide - 2 * GAP) / 3, high - PLOT - TABLE));
    if (wide < COMPACT) return alike(Math.min((wide - SCENE) / 2 - GAP, high - PLOT - TITLE));
    const [below, beside] = [Math.min(high - TABLE, wide - BESIDE), Math.min(high, wide - PIXEL)].map((room) =>
      side_for(room, size)
    );
    const side = Math.max(below, beside);
    const is_tall = beside > below;
    const small = side_for(Math.min(wide - side - 2 * GAP - 1.3 * SCENE, side - PLOT - (is_tall ? TABLE : 0)), size);
    return { side, small, is_tall };
  }

  /** @param {number} size */
  function fit(size) {
    spread();
    if (!stage.clientWidth) return; // a page of the mailed file that is not open
    const { side, small, is_tall } = sides(size);
    root.style.setProperty("--side", `${side}px`);
    root.style.setProperty("--small", `${small}px`);
    root.classList.toggle("sim-tall", is_tall);
    root.classList.toggle("sim-compact", root.clientWidth >= NARROW && root.clientWidth < COMPACT);
    const now = [side, small, window.devicePixelRatio].join();
    if (now !== last) resized();
    last = now;
  }

  /** @param {number} size */
  function toggle_apart(size) {
    is_apart = root.classList.toggle("sim-apart");
    apart.setAttribute("aria-pressed", String(is_apart));
    fit(size);
  }

  function toggle_large() {
    if (document.fullscreenElement) document.exitFullscreen();
    else root.requestFullscreen();
  }

  document.addEventListener("fullscreenchange", () =>
    large.setAttribute("aria-pressed", String(document.fullscreenElement === root))
  );
  return { fit, page, toggle_apart, toggle_large };
}

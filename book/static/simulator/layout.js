// How large the pictures are. The style sheet says how much room there is for them (`--room`); here a side is cut down to
// whole multiples of the raster's pixels, and the simulator is widened to the window's edge.
"use strict";

/** @param {HTMLElement} root @param {() => void} resized is told when the pictures have another size */
function simulator_layout(root, resized) {
  const EDGE = 24; // pixels beside the simulator, 8 on a phone
  const [stage, room] = [".sim-stage", ".sim-room"].map((place) => find_element(root, place));
  const [apart, large] = ["apart", "large"].map((name) => find_element(root, `[data-${name}]`));
  large.hidden = !document.fullscreenEnabled;
  const page = root.closest("main") ?? document.body;

  /** The largest side for which there is room, in whole multiples of the raster's pixels if that can be. @param {number} size */
  function side_for(size) {
    const ratio = window.devicePixelRatio || 1;
    const pixels = room.clientWidth * ratio;
    const whole = pixels >= size ? Math.floor(pixels / size) * size : size / 2 ** Math.ceil(Math.log2(size / pixels));
    return (whole < 0.8 * pixels ? Math.floor(pixels) : whole) / ratio;
  }

  // Break out of the text's column, to the window's edge.
  function spread() {
    const { left } = page.getBoundingClientRect();
    const width = document.documentElement.clientWidth - left;
    const edge = Math.min(EDGE, width / 50);
    const shift = left + edge - root.getBoundingClientRect().left + (parseFloat(root.style.marginLeft) || 0);
    root.style.marginLeft = `${shift}px`;
    root.style.width = `${width - 2 * edge}px`;
  }

  /** @param {number} size */
  function fit(size) {
    spread();
    if (stage.clientWidth) root.style.setProperty("--side", `${side_for(size)}px`); // else a page of the mailed file that is not open
  }

  /** The largest of some sizes that is not above the side in the screen's pixels. @param {number[]} sizes */
  const size_of_screen = (sizes) =>
    Math.max(...sizes.filter((size, n) => n < 2 || size <= room.clientWidth * (window.devicePixelRatio || 1)));

  function toggle_apart() {
    apart.setAttribute("aria-pressed", String(root.classList.toggle("sim-apart")));
  }

  function toggle_large() {
    if (document.fullscreenElement) document.exitFullscreen();
    else root.requestFullscreen();
  }

  document.addEventListener("fullscreenchange", () =>
    large.setAttribute("aria-pressed", String(document.fullscreenElement === root))
  );
  const seen = new ResizeObserver(resized);
  for (const frame of find_all(root, ".sim-frame")) seen.observe(frame);
  return { fit, page, room, size_of_screen, toggle_apart, toggle_large };
}

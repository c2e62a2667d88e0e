// The reader's hand on the pictures: pointer, fingers, wheel and keys.
"use strict";

/** @param {ReturnType<typeof simulator_pictures>} pictures @param {Act} act */
function simulator_hand(pictures, act) {
  const STEADY = 4; // pixels that a click may move
  const TURN = 50; // pixels of the wheel that zoom by a step: a notch has more, a finger on a pad sends many small ones
  /** @type {Map<number, Point>} */
  const fingers = new Map();
  let begun = begin();
  let pinned = false;
  let turned = 0; // of the wheel

  function begin() {
    const { left, top, zoom } = act.state();
    const points = [...fingers.values()];
    return { left, top, zoom, point: points[0] ?? [0, 0], apart: apart(points), moved: points.length > 1 };
  }

  /** @param {Point[]} points */
  function apart([one, other]) {
    return other ? Math.hypot(one[0] - other[0], one[1] - other[1]) : 0;
  }

  /** @param {Place} event @param {HTMLElement} box */
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
  function drag({ clientX, clientY }, box) {
    const { size, zoom } = act.state();
    const [dx, dy] = [clientX - begun.point[0], clientY - begun.point[1]];
    begun.moved ||= Math.hypot(dx, dy) >= STEADY;
    const pixels = size / box.clientWidth;
    if (begun.moved && zoom > 0) act.put({ left: begun.left - dx * pixels, top: begun.top - dy * pixels });
  }

  /** @param {HTMLElement} box */
  function pinch(box) {
    const points = [...fingers.values()];
    const steps = Math.round(2 * Math.log2(apart(points) / begun.apart));
    const middle = { clientX: (points[0][0] + points[1][0]) / 2, clientY: (points[0][1] + points[1][1]) / 2 };
    const missing = begun.zoom + steps - act.state().zoom;
    if (missing) act.zoom(missing, share(middle, box));
  }

  /** @param {KeyboardEvent} event */
  function press(event) {
    if (!["+", "=", "-"].includes(event.key) || is_shortcut(event)) return;
    event.preventDefault();
    act.zoom(event.key === "-" ? -1 : 1);
  }

  /** @param {PointerEvent} event */
  const put = ({ pointerId, clientX, clientY }) => fingers.set(pointerId, [clientX, clientY]);

  /** @param {HTMLElement} box */
  function wire(box) {
    box.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      box.setPointerCapture(event.pointerId);
      put(event);
      begun = begin();
    });
    box.addEventListener("pointermove", (event) => {
      if (!fingers.has(event.pointerId)) {
        if (event.pointerType === "mouse" && !pinned) point(event, box);
        return;
      }
      put(event);
      if (fingers.size > 1) pinch(box);
      else drag(event, box);
    });
    for (const end of /** @type {("pointerup" | "pointercancel")[]} */ (["pointerup", "pointercancel"])) {
      box.addEventListener(end, (event) => {
        if (!fingers.delete(event.pointerId)) return;
        const { moved } = begun;
        begun = { ...begin(), moved: moved && fingers.size > 0 };
        if (moved || event.type !== "pointerup") return;
        pinned = event.pointerType !== "mouse" || !pinned;
        point(event, box);
      });
    }
    const wheel = (/** @type {WheelEvent} */ event) => {
      if (!event.ctrlKey && document.activeElement !== box) return; // else the page scrolls
      event.preventDefault();
      turned = clamp(-TURN, turned - event.deltaY, TURN);
      const steps = Math.trunc(turned / TURN);
      turned -= steps * TURN;
      if (steps) act.zoom(steps, share(event, box));
    };
    box.addEventListener("wheel", wheel, { passive: false });
    box.addEventListener("keydown", press);
    follow_arrows(box, (right, up) => {
      pinned = true;
      act.move([right, -up]);
    });
  }

  pictures.boxes.forEach(wire);
  return {
    release() {
      pinned = false;
    }
  };
}

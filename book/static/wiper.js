// A wiper: two pictures in one place, a line between what is seen of the first and of the second, and a knob that moves
// it. The page writes
//     <div data-wiper="how much of the numeric picture is shown"><img …><img …></div>
// with two children of one size; the words name the knob, a slider: drag it, or use the arrow keys, Home and End. The
// second child is cut off at --wiper, half the width without scripts. The look is in wiper.css.
"use strict";

/** @param {HTMLElement} box */
function make_wiper(box) {
  const knob = make_element("i", { class: "wiper-knob" });
  let share = 50;

  /** @param {number} to per cent of the width */
  function put(to) {
    share = clamp(0, to, 100);
    box.style.setProperty("--wiper", `${share}%`);
    tell(Math.round(share), `${Math.round(share)} %`);
  }

  const tell = as_slider(
    knob,
    box,
    box.dataset.wiper ?? "",
    [0, 100],
    (x, _, begins) => begins || put((100 * x) / box.clientWidth),
    (right, up) => put(share + right + up)
  );
  put(share);
  box.append(knob);
}

when_ready(() => find_all(document, "[data-wiper]").forEach(make_wiper));

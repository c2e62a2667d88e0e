// A wiper: two pictures in one place, a line between what is seen of the first and of the second, and a knob that moves
// it. The page writes
//     <div data-wiper="how much of the numeric picture is shown"><img …><img …></div>
// with two children of one size; the words name the knob, a slider: drag it, or use the arrow keys, Home and End. The
// second child is cut off at --wiper, half the width without scripts. The look is in wiper.css.
"use strict";

/** @param {HTMLElement} box */
function make_wiper(box) {
  const knob = make_element("i", {
    ...{ class: "wiper-knob", role: "slider", tabindex: 0, "aria-label": box.dataset.wiper ?? "" },
    ...{ "aria-valuemin": 0, "aria-valuemax": 100 }
  });
  let share = 50;

  /** @param {number} to per cent of the width */
  function put(to) {
    share = clamp(0, to, 100);
    box.style.setProperty("--wiper", `${share}%`);
    set_attributes(knob, { "aria-valuenow": Math.round(share), "aria-valuetext": `${Math.round(share)} %` });
  }

  follow_pointer(knob, box, (x, _, begins) => begins || put((100 * x) / box.clientWidth));
  follow_arrows(knob, (right, up) => put(share + right + up));
  knob.addEventListener("keydown", (event) => {
    const to = { Home: 0, End: 100 }[event.key];
    if (to === undefined || is_shortcut(event)) return;
    event.preventDefault();
    put(to);
  });
  put(share);
  box.append(knob);
}

when_ready(() => find_all(document, "[data-wiper]").forEach(make_wiper));

// A wiper: two pictures in one place, a line between what is seen of the first and of the second, and a knob that moves
// it. The page writes
//     <div data-wiper="how much of the numeric picture is shown"><img …><img …></div>
// with two children of one size; the words name the knob, the browser's own slider. The second child is cut off at --wiper,
// half the width without scripts. The look is in wiper.css.
"use strict";

/** @param {HTMLElement} box */
function make_wiper(box) {
  const knob = make_element("input", { type: "range", class: "wiper-knob", "aria-label": box.dataset.wiper ?? "" });
  knob.addEventListener("input", () => box.style.setProperty("--wiper", `${knob.value}%`));
  box.append(knob);
}

when_ready(() => find_all(document, "[data-wiper]").forEach(make_wiper));

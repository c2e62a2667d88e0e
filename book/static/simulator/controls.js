// The controls: what they show is the state, and what they are given is checked before it becomes the state.
"use strict";

Simulator.controls = function (root, states, act) {
  const holders = [...root.querySelectorAll("[data-parameter]")];

  // epsilon's slider is logarithmic.
  const to_slider = (name, value) => (name === "eps" ? Math.log10(value) : value);
  const from_slider = (name, position) => (name === "eps" ? Number((10 ** position).toPrecision(3)) : position);

  function say(holder, text) {
    const place = holder.querySelector(".sim-error"), input = holder.querySelector("input[type=text]");
    if (place) place.textContent = text;
    if (input) input.setAttribute("aria-invalid", text ? "true" : "false");
  }

  function attempt(holder, make) {
    try {
      act.set(make());
      say(holder, "");
      put_all(holder, act.state());
    } catch (error) {
      say(holder, error.message);
    }
  }

  function wire(holder) {
    const name = holder.dataset.parameter;
    for (const input of holder.querySelectorAll("input, select")) {
      if (input.type === "range") {
        input.addEventListener("input", () => attempt(holder, () => ({ [name]: from_slider(name, Number(input.value)) })));
      } else if (input.type === "checkbox") {
        const index = Number(input.dataset.index);
        const value = () => (name === "lights" ? act.state().lights.map((on, n) => (n === index ? input.checked : on)) : input.checked);
        input.addEventListener("change", () => attempt(holder, () => ({ [name]: value() })));
      } else input.addEventListener("change", () => attempt(holder, () => ({ [name]: states.read(name, input.value) })));
    }
  }

  function put(input, name, state) {
    const value = state[name];
    if (input.type === "range") {
      const position = String(to_slider(name, value));
      if (input !== document.activeElement || from_slider(name, Number(input.value)) !== value) input.value = position;
      input.setAttribute("aria-valuetext", name === "eps" ? value.toExponential() : String(value));
    } else if (input.type === "checkbox") input.checked = name === "lights" ? value[Number(input.dataset.index)] : value;
    else if (input.type === "radio") input.checked = input.value === String(value);
    else if (input.type === "text") {
      if (input.getAttribute("aria-invalid") !== "true") input.value = name === "eps" && value < 1e-3 ? value.toExponential() : String(value);
    } else input.value = String(value);
  }

  let shown = {};

  function put_all(holder, state) {
    for (const input of holder.querySelectorAll("input, select")) put(input, holder.dataset.parameter, state);
  }

  // Show what has changed.
  function show(state) {
    for (const holder of holders) if (shown[holder.dataset.parameter] !== state[holder.dataset.parameter]) put_all(holder, state);
    shown = state;
  }

  // A new state from elsewhere takes the place of what could not be read.
  function clear() {
    for (const holder of holders) say(holder, "");
    shown = {};
  }

  holders.forEach(wire);
  return { show, clear };
};

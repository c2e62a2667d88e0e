// The controls: what they show is the state, and what they are given is checked before it becomes the state.
"use strict";

/** @param {HTMLElement} root @param {States} states @param {Act} act */
function simulator_controls(root, states, act) {
  const holders = find_all(root, "[data-parameter]").map((holder) => {
    /** @type {HTMLInputElement[]} */
    const inputs = find_all(holder, "input, select");
    return { name: holder.dataset.parameter ?? "", complaint: holder.querySelector(".sim-error"), inputs };
  });
  /** @typedef {typeof holders[number]} Holder */
  /** @type {Partial<State>} */
  let shown = {};

  // epsilon's slider is logarithmic.
  /** @param {string} name @param {number} value */
  const to_slider = (name, value) => (name === "eps" ? Math.log10(value) : value);
  /** @param {string} name @param {number} position */
  const from_slider = (name, position) => (name === "eps" ? power_of_ten(position) : position);

  /** @param {Holder} holder @param {string} text */
  function say({ complaint, inputs }, text) {
    if (complaint) complaint.textContent = text;
    for (const input of inputs) if (input.type === "text") input.setAttribute("aria-invalid", String(text !== ""));
  }

  /** What an input's place or text means for the state. @param {Holder} holder @param {HTMLInputElement} input */
  function value_of({ name }, input) {
    if (input.type === "range") return from_slider(name, Number(input.value));
    if (input.type !== "checkbox") return states.read(name, input.value);
    if (name !== "lights") return input.checked;
    return act.state().lights.map((on, n) => (n === Number(input.dataset.index) ? input.checked : on));
  }

  /** @param {Holder} holder @param {HTMLInputElement} input */
  function attempt(holder, input) {
    try {
      const value = value_of(holder, input);
      say(holder, "");
      shown = { ...shown, [holder.name]: null }; // what was typed is written anew
      act.set({ [holder.name]: value });
    } catch (error) {
      say(holder, error_text(error));
    }
  }

  /** @param {HTMLInputElement} input @param {string} name @param {State} state */
  function put(input, name, state) {
    const value = state[name];
    const in_powers = name === "eps" && (input.type === "range" || value < 1e-3);
    const text = in_powers ? value.toExponential() : String(value);
    if (input.type === "range") {
      const is_held = input === document.activeElement && from_slider(name, Number(input.value)) === value;
      if (!is_held) input.value = String(to_slider(name, value));
      input.setAttribute("aria-valuetext", text);
    } else if (input.type === "checkbox")
      input.checked = name === "lights" ? value[Number(input.dataset.index)] : value;
    else if (input.type === "radio") input.checked = input.value === text;
    else if (input.getAttribute("aria-invalid") !== "true") input.value = text;
  }

  /** @param {Holder} holder @param {State} state */
  function put_all({ inputs, name }, state) {
    for (const input of inputs) put(input, name, state);
  }

  /** Show what has changed. @param {State} state */
  function show(state) {
    for (const holder of holders) if (shown[holder.name] !== state[holder.name]) put_all(holder, state);
    shown = state;
  }

  // A new state from elsewhere takes the place of what could not be read.
  function clear() {
    for (const holder of holders) say(holder, "");
    shown = {};
  }

  for (const holder of holders) {
    for (const input of holder.inputs)
      input.addEventListener(input.type === "range" ? "input" : "change", () => attempt(holder, input));
  }
  return { show, clear };
}

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

  /** What a slider's place stands for: epsilon's is logarithmic. @param {string} name @param {HTMLInputElement} input */
  const slid_to = (name, { valueAsNumber }) => (name === "eps" ? power_of_ten(valueAsNumber) : valueAsNumber);

  /** @param {Holder} holder @param {string} text */
  function say({ complaint, inputs }, text) {
    if (complaint) complaint.textContent = text;
    for (const input of inputs) if (input.type === "text") input.setAttribute("aria-invalid", String(text !== ""));
  }

  /** What an input's place or text means for the state. @param {Holder} holder @param {HTMLInputElement} input */
  function value_of({ name }, input) {
    if (input.type === "range") return slid_to(name, input);
    if (input.type !== "checkbox") return states.read(name, input.value);
    if (name !== "lights") return Number(input.checked);
    return act.state().lights.map((on, n) => (n === Number(input.dataset.index) ? input.checked : on));
  }

  /** A formula that is being typed is drawn whenever it can be read, and else left alone. @param {Holder} holder @param {HTMLInputElement} input */
  function attempt(holder, input, is_typing = false) {
    try {
      const value = value_of(holder, input);
      say(holder, "");
      shown = { ...shown, [holder.name]: null }; // what was typed is written anew
      act.set({ [holder.name]: value });
    } catch (error) {
      if (is_typing) return;
      say(holder, error_text(error));
      const { at, length, text } = /** @type {{ at?: number, length: number, text: string }} */ (error);
      if (at === undefined || input !== document.activeElement) return;
      input.value = text; // in the letters that were read
      input.setSelectionRange(at, at + length);
    }
  }

  /** @param {HTMLInputElement} input @param {string} name @param {State} state */
  function put(input, name, state) {
    const value = state[name];
    const in_powers = name === "eps" && (input.type === "range" || value < 1e-3);
    const text = in_powers ? value.toExponential() : String(value);
    if (input.type === "range") {
      if (input !== document.activeElement || slid_to(name, input) !== value)
        input.value = String(name === "eps" ? Math.log10(value) : value);
      input.setAttribute("aria-valuetext", text);
    } else if (input.type === "checkbox")
      input.checked = name === "lights" ? value[Number(input.dataset.index)] : value;
    else if (input.type === "radio") input.checked = input.value === text;
    else if (input.getAttribute("aria-invalid") !== "true" && (name !== "h" || input !== document.activeElement))
      input.value = text;
  }

  /** Show what has changed. @param {State} state */
  function show(state) {
    for (const { inputs, name } of holders)
      if (shown[name] !== state[name]) for (const input of inputs) put(input, name, state);
    shown = state;
  }

  // A new state from elsewhere takes the place of what could not be read.
  function clear() {
    for (const holder of holders) say(holder, "");
    shown = {};
  }

  for (const holder of holders) {
    for (const input of holder.inputs) {
      input.addEventListener(input.type === "range" ? "input" : "change", () => attempt(holder, input));
      if (holder.name === "h") input.addEventListener("input", () => attempt(holder, input, true));
    }
  }
  return { show, clear };
}

// The statement, line by line, for the reader to change: press a term to turn its sign, or type. The kernel then tries
// the old certificate on the new statement.
"use strict";
var Checker = Checker || {};

// The lines of a statement that can be changed: {label, path, before, after, names}. The value at `path` is a
// polynomial, or with `names` a list of names.
Checker.lines = function (statement, { spelled }) {
  const RELATIONS = { "=": " = 0", "!=": " ≠ 0", ">": " > 0", ">=": " ≥ 0" };
  if (statement.kind === "separation") {
    const uses = statement.lines.map(([name], n) => ({ label: "line", path: ["lines", n, 1], before: [...spelled(name), " uses "] }));
    const ends = ["outputs", "avoid"].map((key) => ({ label: key, path: [key], before: [] }));
    return [...uses, ...ends].map((line) => ({ ...line, after: "", names: true }));
  }
  const given = (key) => ({ of, is, step, new: name }, n) => {
    const path = [key, n, "of"], label = { assume: "given", define: "where", show: "to show" }[step ?? "assume"] ?? "where";
    const before = name ? [...spelled(name), { root: " = √( ", inverse: " = 1 / ( ", define: " = " }[step]] : [];
    return { label, path, before, after: is ? RELATIONS[is] : step === "define" ? "" : " )" };
  };
  if (statement.kind !== "induction") return statement.steps.map(given("steps"));
  const states = (key, when) => (name) => ({ label: key, path: [key, name], before: [...spelled(name), when, " = "], after: "" });
  const shown = statement.show.map((_, n) => ({ label: "to show", path: ["show", n], before: [], after: " = 0 for every n" }));
  return [...statement.assume.map(given("assume")), ...Object.keys(statement.start).map(states("start", " at first")),
    ...Object.keys(statement.next).map(states("next", " next")), ...shown];
};

Checker.editor = function (root, statements, polynomials, clerk, told) {
  const make = Checker.make, { typeset, term, sorted, spelled, text, parse } = polynomials;
  const at = (tree, path) => path.reduce((branch, key) => branch[key], tree);
  const copies = statements.map(({ statement }) => structuredClone(statement));
  const verdict = make("div", { class: "check-verdict", role: "status" }), list = make("ol", { class: "check-lines" });
  const back = make("button", { type: "button" }, "Put everything back");
  let chosen = 0, opened = null, asked = 0;

  const lists = (names) => make("span", {}, ...names.flatMap((name, n) => [n ? ", " : "", ...spelled(name)]));
  // Whether a line says something else than at first; the order of terms says nothing.
  const form = (value) => JSON.stringify(Array.isArray(value) ? value : sorted(value));
  const differs = ({ path }) => form(at(copies[chosen], path)) !== form(at(statements[chosen].statement, path));
  const known = (statement) => new Set([...(statement.variables ?? []), ...(statement.state ?? []),
    ...(statement.steps ?? []).flatMap((step) => step.new ?? [])]);

  function show_line(line, button) {
    const { before, after, names, path } = line, value = at(copies[chosen], path);
    button.replaceChildren(...before.map((node) => (node.cloneNode ? node.cloneNode(true) : node)), names ? lists(value) : typeset(value), after);
    button.parentElement.classList.toggle("check-changed", differs(line));
  }

  // The chips and the box of the line that is open.
  function open(line, item, button) {
    const close = opened?.item === item;
    if (opened) {
      opened.panel.remove();
      opened.button.setAttribute("aria-expanded", "false");
    }
    opened = null;
    if (close) return;
    const id = `${root.id}-box`, chips = make("div", { class: "check-chips", role: "group", "aria-labelledby": `${id}-chips` }), error = make("p", { class: "check-error", id: `${id}-error` });
    const box = make("input", { type: "text", id, "aria-describedby": error.id, autocomplete: "off", autocapitalize: "off", spellcheck: "false" });
    const label = make("label", { for: id }, line.names ? "Names, with blanks between them" : "Or type: 3/2 x^2 y − 1");
    const panel = make("div", { class: "check-panel" }, chips, label, box, error);
    const value = () => at(copies[chosen], line.path);

    function put(next) {
      at(copies[chosen], line.path.slice(0, -1))[line.path.at(-1)] = next;
      error.textContent = "";
      box.removeAttribute("aria-invalid");
      show_line(line, button);
      try_it();
    }

    function show_chips(focused) {
      if (line.names) return;
      const terms = sorted(value()).map(([monomial, coefficient], n) => {
        const chip = make("button", { type: "button" }, term(monomial, coefficient, n === 0));
        chip.addEventListener("click", () => {
          const turned = coefficient.startsWith("-") ? coefficient.slice(1) : `-${coefficient}`;
          put({ ...value(), [monomial]: turned });
          box.value = text(value());
          show_chips(n);
        });
        return chip;
      });
      chips.replaceChildren(...(terms.length ? [make("span", { id: `${id}-chips` }, "Turn a sign:"), ...terms] : []));
      if (focused !== undefined) chips.querySelectorAll("button")[focused].focus();
    }

    box.addEventListener("input", () => {
      try {
        put(line.names ? box.value.trim().split(/[\s,]+/).filter(Boolean) : parse(box.value, known(copies[chosen])));
        show_chips();
      } catch (why) {
        error.textContent = `Not yet a ${line.names ? "list" : "polynomial"}: ${why.message}.`;
        box.setAttribute("aria-invalid", "true");
      }
    });
    box.value = line.names ? value().join(" ") : text(value());
    show_chips();
    item.append(panel);
    button.setAttribute("aria-expanded", "true");
    opened = { item, button, panel };
  }

  async function try_it() {
    const now = ++asked, statement = copies[chosen], changed = Checker.lines(statement, polynomials).some(differs);
    back.disabled = !changed;
    if (!changed) return verdict.replaceChildren(make("p", {}, "The statement is as it was. Press a line to change it."));
    const answer = await clerk.check(statement, statements[chosen].certificate).catch((why) => ({ failed: why.message }));
    if (now === asked) verdict.replaceChildren(...told(answer, statement));
  }

  function show() {
    opened = null;
    const lines = Checker.lines(copies[chosen], polynomials);
    list.replaceChildren(...lines.map((line) => {
      const button = make("button", { type: "button", "aria-expanded": "false", class: "check-line" });
      const item = make("li", {}, make("span", { class: "check-label" }, line.label), button);
      button.addEventListener("click", () => open(line, item, button));
      show_line(line, button);
      return item;
    }));
    try_it();
  }

  back.addEventListener("click", () => {
    copies[chosen] = structuredClone(statements[chosen].statement);
    show();
  });
  const choice = make("select", { id: `${root.id}-statement` }, ...statements.map(({ name }, n) => make("option", { value: n }, name)));
  choice.addEventListener("change", () => {
    chosen = Number(choice.value);
    show();
  });
  const which = make("p", { class: "check-which" }, make("label", { for: choice.id }, "Statement "), choice);
  root.append(...(statements.length > 1 ? [which] : []), list, verdict, make("p", {}, back));
  show();
};

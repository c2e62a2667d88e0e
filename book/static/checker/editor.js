// The statement, line by line, for the reader to change: press a term to turn its sign, or type. The kernel then tries
// the old certificate on the new statement.
"use strict";

/** @param {Statement} statement @param {PolynomialTexts} polynomials @returns {Line[]} */
function statement_lines(statement, { spelled, zero }) {
  /** @param {string} label @param {Path} path @param {(Node | string)[]} [before] @returns {Line} */
  const line = (label, path, before = [], after = "", names = false) => ({ label, path, before, after, names });
  /** @param {string} key @param {string} when */
  const states = (key, when) =>
    Object.keys(statement[key]).map((name) => line(key, [key, name], [spelled(name), when, " = "]));
  /** @param {string} key @returns {(step: Step, n: number) => Line} */
  const relation = (key) => (step, n) => {
    const { step: kind = "assume", is, new: name = "" } = step;
    const path = [key, n, "of"];
    if (is) return line(kind === "show" ? "to show" : "given", path, [], zero(is));
    const [sign, after] = { root: [" = √( ", " )"], inverse: [" = 1 / ( ", " )"] }[kind] ?? [" = "];
    return line("where", path, [spelled(name), sign], after);
  };
  const { kind, steps = [], lines = [], assume = [], show = [] } = statement;
  if (kind === "separation")
    return [
      ...lines.map(([name], n) => line("line", ["lines", n, 1], [spelled(name), " uses "], "", true)),
      ...["outputs", "avoid"].map((key) => line(key, [key], [], "", true))
    ];
  if (kind !== "induction") return steps.map(relation("steps"));
  return [
    ...assume.map(relation("assume")),
    ...states("start", " at first"),
    ...states("next", " next"),
    ...show.map((_, n) => line("to show", ["show", n], [], " = 0 for every n"))
  ];
}

/**
 * @param {HTMLElement} root
 * @param {NamedCase[]} cases
 * @param {PolynomialTexts} polynomials
 * @param {Clerk} clerk
 * @param {(answer: Answer, statement: Statement) => HTMLElement[]} told what is said of an answer
 */
function statement_editor(root, cases, polynomials, clerk, told) {
  const { typeset, term, sorted, spelled, text, parse } = polynomials;
  const copies = cases.map(({ statement }) => structuredClone(statement));
  const verdict = verdict_box();
  const list = make_element("ol", { class: "check-lines" });
  const back = make_button("Put everything back", () => {
    copies[chosen] = structuredClone(cases[chosen].statement);
    show();
  });
  /** @type {{ item: Element, button: Element, panel: Element } | null} */
  let opened = null;
  let chosen = 0;
  let asked = 0;

  /** @param {Statement} statement @param {Path} path @returns {any} */
  const at = (statement, path) => path.reduce((branch, key) => branch[key], /** @type {any} */ (statement));
  /** @param {string[]} names */
  const listed = (names) => make_element("span", {}, ...names.flatMap((name, n) => [n ? ", " : "", spelled(name)]));
  /** The order of terms says nothing. @param {any} value */
  const form = (value) => JSON.stringify(Array.isArray(value) ? value : sorted(value));
  /** Whether a line says something else than at first. @param {Line} line */
  const differs = ({ path }) => form(at(copies[chosen], path)) !== form(at(cases[chosen].statement, path));

  /** @param {Statement} statement */
  function known({ variables = [], state = [], steps = [] }) {
    return new Set([...variables, ...state, ...steps.flatMap((step) => step.new ?? [])]);
  }

  /** @param {Line} line @param {Element} item @param {Element} button */
  function show_line(line, item, button) {
    const value = at(copies[chosen], line.path);
    const before = line.before.map((node) => (node instanceof Node ? node.cloneNode(true) : node));
    button.replaceChildren(...before, line.names ? listed(value) : typeset(value), line.after);
    item.classList.toggle("check-changed", differs(line));
  }

  /** Open the chips and the box of a line, or close what is open. @param {Line} line @param {Element} item @param {Element} button */
  function open(line, item, button) {
    const is_open = opened?.item === item;
    opened?.panel.remove();
    opened?.button.setAttribute("aria-expanded", "false");
    opened = null;
    if (is_open) return;
    const id = `${root.id}-box`;
    const error = make_element("p", { class: "check-error", id: `${id}-error` });
    const chips = make_element("div", { class: "check-chips", role: "group", "aria-labelledby": `${id}-chips` });
    const plain = { autocomplete: "off", autocapitalize: "off", spellcheck: "false" };
    const box = make_element("input", { type: "text", id, "aria-describedby": error.id, ...plain });
    const words = line.names ? "Names, with blanks between them" : "Or type: 3/2 x^2 y − 1";
    const label = make_element("label", { for: id }, words);
    const panel = make_element("div", { class: "check-panel" }, chips, label, box, error);
    const value = () => at(copies[chosen], line.path);

    /** @param {PolynomialData | string[]} next */
    function put(next) {
      at(copies[chosen], line.path.slice(0, -1))[line.path[line.path.length - 1]] = next;
      error.textContent = "";
      box.removeAttribute("aria-invalid");
      show_line(line, item, button);
      try_it();
    }

    function show_chips() {
      if (line.names) return;
      const terms = sorted(value()).map(([monomial, coefficient], n) => {
        return make_button(term(monomial, coefficient, !n), () => {
          const turned = coefficient.startsWith("-") ? coefficient.slice(1) : `-${coefficient}`;
          put({ ...value(), [monomial]: turned });
          box.value = text(value());
          show_chips();
          chips.querySelectorAll("button")[n].focus();
        });
      });
      chips.replaceChildren(...terms);
      if (terms.length) chips.prepend(make_element("span", { id: `${id}-chips` }, "Turn a sign:"));
    }

    box.addEventListener("input", () => {
      try {
        put(
          line.names
            ? box.value
                .trim()
                .split(/[\s,]+/)
                .filter(Boolean)
            : parse(box.value, known(copies[chosen]))
        );
        show_chips();
      } catch (why) {
        error.textContent = `Not yet a ${line.names ? "list" : "polynomial"}: ${error_text(why)}.`;
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
    const now = ++asked;
    const statement = copies[chosen];
    back.disabled = !statement_lines(statement, polynomials).some(differs);
    if (back.disabled)
      return verdict.replaceChildren(make_element("p", {}, "The statement is as it was. Press a line to change it."));
    const answer = clerk.check(statement, cases[chosen].certificate);
    const said = await answer.then((found) => told(found, statement), no_verdict);
    if (now === asked) verdict.replaceChildren(...said);
  }

  function show() {
    opened = null;
    const items = statement_lines(copies[chosen], polynomials).map((line) => {
      const button = make_button("", () => open(line, item, button), { "aria-expanded": "false", class: "check-line" });
      const item = make_element("li", {}, make_element("span", { class: "check-label" }, line.label), button);
      show_line(line, item, button);
      return item;
    });
    list.replaceChildren(...items);
    try_it();
  }

  const options = cases.map(({ name }, n) => make_element("option", { value: n }, name));
  const choice = make_element("select", { id: `${root.id}-statement` }, ...options);
  choice.addEventListener("change", () => {
    chosen = Number(choice.value);
    show();
  });
  const label = make_element("label", { for: choice.id }, "Statement ");
  if (cases.length > 1) root.append(make_element("p", { class: "check-which" }, label, choice));
  root.append(list, verdict, make_element("p", {}, back));
  show();
}

// A theorem's card: the button that checks it, what was checked in words, and the button that lets the reader doubt it.
"use strict";

/** @param {Element} place @param {CardData} data @param {Clerk} clerk */
function checker_card(place, data, clerk) {
  const polynomials = polynomial_texts(data.names);
  const { related, typeset, spelled } = polynomials;
  /** @type {NamedCase[]} */
  const cases = data.claims.flatMap(({ claim, statements }) =>
    statements.map((pair, n) => {
      const number = statements.length > 1 ? `, case ${n + 1}` : "";
      return { ...pair, name: claim.replaceAll("_", " ") + number };
    })
  );
  const id = `doubt-${data.theorem}`;
  const verdict = verdict_box();
  const button = make_button("Check it here", () => show_verdict(button, verdict, check));
  const doubt = make_button("Change the statement", open_editor, { "aria-expanded": "false", "aria-controls": id });
  const details = make_element("div");
  const panel = make_element("div", { class: "check-editor", id, hidden: "" });

  /** @param {number} n @param {string} word */
  const number = (n, word, plural = `${word}s`) => `${n.toLocaleString("en-GB")} ${n === 1 ? word : plural}`;
  /** @param {number} time */
  const took = (time) => (time < 1 ? "less than 1 ms" : time < 1000 ? `${Math.round(time)} ms` : seconds(time));
  /** @param {Statement} statement @param {...string} kinds */
  const steps = (statement, ...kinds) => (statement.steps ?? []).filter(({ step = "" }) => kinds.includes(step));

  /** @param {Answer} answer @param {Statement} statement */
  function rejected({ work, time, reason, residual }, { kind }, name = "") {
    const at = kind === "derivation" ? `, at line ${work.step + 1}` : "";
    const parts = [verdict_line("Rejected", `, after ${took(time)}${name && `: ${name}`}${at}: ${reason}.`)];
    const [before, after] =
      kind === "refutation" ? ["Left side less right side, there: ", "."] : ["Left over: ", ". It should be 0."];
    if (residual) parts.push(make_element("p", { class: "check-residual" }, before, typeset(residual), after));
    return parts;
  }

  /** What becomes of a changed statement. @param {Answer} answer @param {Statement} statement */
  function told(answer, statement) {
    if (!answer.accepted) return rejected(answer, statement);
    const why = {
      refutation: "the point refutes the statement as it now reads, too.",
      separation: "the outputs still use nothing that was to be avoided.",
      derivation: "",
      induction: ""
    };
    const proved =
      "the certificate proves the statement as it now reads. No proof uses what was changed, or it makes no " +
      "difference to any identity (as −x for x does not, under a square).";
    return [verdict_line("Accepted all the same", `, after ${took(answer.time)}: ${why[statement.kind] || proved}`)];
  }

  /** What was done, by kinds of statements. @param {Answer[]} answers */
  function done(answers) {
    /** @param {...string} kinds */
    const of = (...kinds) => answers.filter((_, n) => kinds.includes(cases[n].statement.kind));
    const [proved, refuted, separated] = [of("derivation", "induction"), of("refutation"), of("separation")];
    const inductions = of("induction").length;
    const given = total(cases, ({ statement }) => steps(statement, "assume").length);
    /** @param {Answer[]} list */
    const identities = (list) => total(list, ({ work }) => work.identities);
    const sentences = [];
    if (proved.length)
      sentences.push(
        `${number(proved.length, "statement")} under ${number(given, "hypothesis", "hypotheses")}` +
          `${inductions ? `, ${inductions} of them by induction` : ""}: ` +
          `${number(identities(proved), "polynomial identity", "polynomial identities")} multiplied out, ` +
          `${number(
            total(proved, ({ work }) => work.products),
            "product"
          )} of terms, and nothing is left over.`
      );
    if (refuted.length) {
      const others = identities(refuted) - refuted.length;
      sentences.push(
        `${number(refuted.length, "counterexample")} put in, in exact fractions: the claim is false there, ` +
          `and ${number(others, "other condition holds", "other conditions hold")}.`
      );
    }
    if (separated.length)
      sentences.push(
        `${number(separated.length, "program")} followed: ${number(identities(separated), "line")} ` +
          "that the outputs need use nothing that was to be avoided."
      );
    return sentences.join(" ");
  }

  /** @param {NamedCase} named */
  function what({ name, statement, certificate }) {
    /** @param {string} key @param {string[]} after */
    const named = (key, ...after) => make_element("span", {}, ...spelled(key), ...after);
    /** @param {{ of: PolynomialData, is?: string }[]} list */
    const relations = (list) => list.map(({ of, is = "=" }) => related(of, is));
    const claimed = statement.kind === "refutation" ? "Claimed, and false" : "Shown";
    const point = Object.entries(certificate.point ?? {}).map(([key, value]) => named(key, ` = ${value}`));
    /** @type {Record<string, HTMLElement[]>} */
    const parts = {
      Given: relations(statement.assume ?? steps(statement, "assume")),
      At: point,
      "For every n": (statement.show ?? []).map((p) => related(p, "=")),
      [claimed]: relations(steps(statement, "show")),
      Outputs: (statement.outputs ?? []).map((key) => named(key)),
      Avoided: (statement.avoid ?? []).map((key) => named(key))
    };
    const items = Object.entries(parts)
      .filter(([, list]) => list.length)
      .map(([word, list]) => make_element("li", {}, `${word}: `, ...list.flatMap((part, n) => [n ? "; " : "", part])));
    const aside = steps(statement, "define", "root", "inverse").length;
    const with_aside = aside ? `, with ${number(aside, "abbreviation")}` : "";
    return make_element("li", {}, name, with_aside, make_element("ul", {}, ...items));
  }

  function limits() {
    const link = /** @type {Element} */ (find_element(place, ":scope > a").cloneNode(true));
    link.removeAttribute("hidden");
    const nothing = cases.some(({ statement }) =>
      steps(statement, "show").some(({ of }) => Object.keys(of).length === 0)
    );
    const expanded = nothing
      ? " Where a line reads 0 = 0, the translation has multiplied out, and nothing is left to prove."
      : "";
    const given = data.given.length ? ` Among the hypotheses, and so not proved here: ${data.given.join("; ")}.` : "";
    const before = "Not checked here: that these polynomials say what the words above say. ";
    return make_element("p", { class: "check-limits" }, before, link, `.${expanded}${given}`);
  }

  async function check() {
    details.replaceChildren();
    const answers = await Promise.all(cases.map(({ statement, certificate }) => clerk.check(statement, certificate)));
    const time = took(total(answers, (answer) => answer.time));
    const list = make_element("ol", {}, ...cases.map(what));
    details.append(make_element("details", {}, make_element("summary", {}, "What was checked"), list));
    const wrong = answers.findIndex((answer) => !answer.accepted);
    if (wrong >= 0) return rejected(answers[wrong], cases[wrong].statement, cases[wrong].name);
    return [verdict_line("Accepted", `, in ${time}, by this browser. ${done(answers)}`), limits()];
  }

  function open_editor() {
    if (!panel.hasChildNodes()) statement_editor(panel, cases, polynomials, clerk, told);
    panel.hidden = !panel.hidden;
    doubt.setAttribute("aria-expanded", String(!panel.hidden));
  }

  put_checker(place, make_element("p", { class: "check-buttons" }, button, doubt), verdict, details, panel);
}

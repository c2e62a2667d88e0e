// A theorem's card: the button that checks it, what was checked in words, and the button that lets the reader doubt it.
"use strict";

/** @param {Element} place @param {CardData} data @param {Clerk} clerk */
function checker_card(place, data, clerk) {
  const polynomials = polynomial_texts(data.names);
  /** @type {NamedCase[]} */
  const cases = data.claims.flatMap(({ claim, statements }) =>
    statements.map((pair, n) => {
      const number = statements.length > 1 ? `, case ${n + 1}` : "";
      return { ...pair, name: claim.replaceAll("_", " ") + number };
    })
  );
  const id = `doubt-${data.theorem}`;
  const verdict = verdict_box();
  const limits = find_element(place, ".check-limits");
  const button = make_button("Check it here", () => show_verdict(button, verdict, check));
  const doubt = make_button("Read or change the statement", open_editor, {
    "aria-expanded": "false",
    "aria-controls": id
  });
  const panel = make_element("div", { class: "check-editor", id, hidden: "" });

  /** @param {number} n @param {string} word */
  const number = (n, word, plural = `${word}s`) => `${n.toLocaleString("en-GB")} ${n === 1 ? word : plural}`;
  /** @param {number} time */
  const took = (time) => number(Math.ceil(time), "ms", "ms");
  /** @param {Answer} answer @param {Statement} statement */
  function rejected({ work, time, reason, residual }, { kind }, name = "") {
    const at = kind === "derivation" ? `, at line ${work.step + 1}` : "";
    const parts = [verdict_line("Rejected", `, after ${took(time)}${name && `: ${name}`}${at}: ${reason}.`)];
    const [before, after] =
      kind === "refutation" ? ["Left side less right side, there: ", "."] : ["Left over: ", ". It should be 0."];
    if (residual)
      parts.push(make_element("p", { class: "check-residual" }, before, polynomials.typeset(residual), after));
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
    /** @param {string} kinds */
    const of = (kinds) => answers.filter((_, n) => kinds.includes(cases[n].statement.kind));
    /** @param {Answer[]} list @param {"identities" | "products"} what */
    const sum = (list, what) => total(list, ({ work }) => work[what]);
    const [proved, refuted, separated] = ["derivation induction", "refutation", "separation"].map(of);
    const given = cases.flatMap(({ statement }) => statement.steps ?? []).filter(({ step }) => step === "assume");
    const others = sum(refuted, "identities") - refuted.length;
    return [
      proved.length &&
        `${number(proved.length, "statement")} under ${number(given.length, "hypothesis", "hypotheses")}: ` +
          `${number(sum(proved, "identities"), "polynomial identity", "polynomial identities")} multiplied out, ` +
          `${number(sum(proved, "products"), "product")} of terms, and nothing is left over.`,
      refuted.length &&
        `${number(refuted.length, "counterexample")} put in, in exact fractions: the claim is false there, ` +
          `and ${number(others, "other condition holds", "other conditions hold")}.`,
      separated.length &&
        `${number(separated.length, "program")} followed: ${number(sum(separated, "identities"), "line")} ` +
          "that the outputs need use nothing that was to be avoided."
    ]
      .filter(Boolean)
      .join(" ");
  }

  async function check() {
    const answers = await Promise.all(cases.map(({ statement, certificate }) => clerk.check(statement, certificate)));
    const time = took(total(answers, (answer) => answer.time));
    const wrong = answers.findIndex((answer) => !answer.accepted);
    if (wrong >= 0) return rejected(answers[wrong], cases[wrong].statement, cases[wrong].name);
    return [verdict_line("Accepted", `, in ${time}, by this browser. ${done(answers)}`), limits];
  }

  function open_editor() {
    if (!panel.hasChildNodes()) statement_editor(panel, cases, polynomials, clerk, told);
    panel.hidden = !panel.hidden;
    doubt.setAttribute("aria-expanded", String(!panel.hidden));
  }

  put_checker(place, [button, doubt], verdict, panel);
}

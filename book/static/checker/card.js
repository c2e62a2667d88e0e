// A theorem's card: the button that checks it, and what was checked in words.
"use strict";

/** @param {Element} place @param {TheoremData} data @param {Clerk} clerk */
function checker_card(place, data, clerk) {
  /** @type {NamedCase[]} */
  const cases = data.claims.flatMap(({ claim, statements }) =>
    statements.map((pair, n) => {
      const number = statements.length > 1 ? `, case ${n + 1}` : "";
      return { ...pair, name: claim.replaceAll("_", " ") + number };
    })
  );
  const verdict = verdict_box();
  const limits = find_element(place, ".check-limits");
  const button = make_button("Check it here", () => show_verdict(button, verdict, check));

  /** @param {number} n @param {string} word */
  const number = (n, word, plural = `${word}s`) => `${n.toLocaleString("en-GB")} ${n === 1 ? word : plural}`;
  /** @param {number} time */
  const took = (time) => number(Math.ceil(time), "ms", "ms");
  /** @param {Answer} answer @param {NamedCase} tried */
  function rejected({ work, time, reason, residual }, { statement: { kind }, name }) {
    const at = kind === "derivation" ? `, at line ${work.step + 1}` : "";
    const parts = [verdict_line("Rejected", `, after ${took(time)}: ${name}${at}: ${reason}.`)];
    const [before, after] =
      kind === "refutation" ? ["Left side less right side, there: ", "."] : ["Left over: ", ". It should be 0."];
    const terms = Object.entries(residual ?? {}).map(([monomial, coefficient]) => `${coefficient} ${monomial}`);
    if (residual) parts.push(make_element("p", { class: "check-residual" }, before, terms.join(" + "), after));
    return parts;
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
    if (wrong >= 0) return rejected(answers[wrong], cases[wrong]);
    return [verdict_line("Accepted", `, in ${time}, by this browser. ${done(answers)}`), limits];
  }

  put_checker(place, [button], verdict);
}

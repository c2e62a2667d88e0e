// A theorem's card: the button that checks it, what was checked in words, and the button that lets the reader doubt it.
"use strict";
var Checker = Checker || {};

Checker.card = function (place, data, clerk) {
  const make = Checker.make, polynomials = Checker.polynomials(data.names), { related, typeset } = polynomials;
  const statements = data.claims.flatMap(({ claim, statements }) =>
    statements.map((pair, n) => ({ ...pair, name: claim.replaceAll("_", " ") + (statements.length > 1 ? `, case ${n + 1}` : "") })));
  const button = make("button", { type: "button" }, "Check it here");
  const doubt = make("button", { type: "button", "aria-expanded": "false", "aria-controls": `doubt-${data.theorem}` }, "Change the statement");
  const verdict = make("div", { class: "check-verdict", role: "status" }), details = make("div");
  const panel = make("div", { class: "check-editor", id: `doubt-${data.theorem}`, hidden: "" });

  const number = (n, word, plural = `${word}s`) => `${n.toLocaleString("en-GB")} ${n === 1 ? word : plural}`;
  const took = (time) => (time < 1 ? "less than 1 ms" : time < 1000 ? `${Math.round(time)} ms` : `${(time / 1000).toFixed(1)} s`);
  const total = (answers, count) => answers.reduce((sum, answer) => sum + count(answer), 0);
  const line = (kind, word, ...rest) => make("p", { class: `check-${kind}` }, make("strong", {}, word), ...rest);
  const steps = (statement, kind) => (statement.steps ?? []).filter(({ step }) => step === kind);

  function rejected(answer, statement, name) {
    const at = { derivation: `, at line ${answer.work.step + 1}`, refutation: "", induction: "", separation: "" }[statement.kind];
    const parts = [line("rejected", "Rejected", `, after ${took(answer.time)}${name ? `: ${name}` : ""}${at}: ${answer.reason}.`)];
    const [before, after] = statement.kind === "refutation" ? ["Left side less right side, there: ", "."] : ["Left over: ", ". It should be 0."];
    if (answer.residual) parts.push(make("p", { class: "check-residual" }, before, typeset(answer.residual), after));
    return parts;
  }

  const no_verdict = (why) => [line("rejected", "No verdict", `: ${why}.`)];

  // What becomes of a changed statement.
  function told(answer, statement) {
    if (answer.failed) return no_verdict(answer.failed);
    if (!answer.accepted) return rejected(answer, statement);
    const why = {
      refutation: "the point refutes the statement as it now reads, too.",
      separation: "the outputs still use nothing that was to be avoided.",
    }[statement.kind] ?? "the certificate proves the statement as it now reads. No proof uses what was changed, or it makes no " +
      "difference to any identity (as −x for x does not, under a square).";
    return [line("accepted", "Accepted all the same", `, after ${took(answer.time)}: ${why}`)];
  }

  // What was done, by kinds of statements.
  function done(answers) {
    const of = (kind) => answers.filter((_, n) => statements[n].statement.kind === kind), sentences = [];
    const proved = [...of("derivation"), ...of("induction")], refuted = of("refutation"), separated = of("separation");
    const given = statements.reduce((sum, { statement }) => sum + steps(statement, "assume").length, 0);
    const identities = (list) => total(list, (answer) => answer.work.identities);
    if (proved.length) sentences.push(`${number(proved.length, "statement")} under ${number(given, "hypothesis", "hypotheses")}` +
      `${of("induction").length ? `, ${of("induction").length} of them by induction` : ""}: ${number(identities(proved), "polynomial identity", "polynomial identities")} multiplied out, ` +
      `${number(total(proved, (answer) => answer.work.products), "product")} of terms, and nothing is left over.`);
    if (refuted.length) sentences.push(`${number(refuted.length, "counterexample")} put in, in exact fractions: the claim is false there, and ${number(identities(refuted) - refuted.length, "other condition")} hold${identities(refuted) - refuted.length === 1 ? "s" : ""}.`);
    if (separated.length) sentences.push(`${number(separated.length, "program")} followed: ${number(identities(separated), "line")} that the outputs need use nothing that was to be avoided.`);
    return sentences.join(" ");
  }

  function what({ name, statement, certificate }) {
    const listed = (word, parts) => (parts.length ? [make("li", {}, `${word}: `, ...parts.flatMap((part, n) => [n ? "; " : "", part]))] : []);
    const named = (key) => make("span", {}, ...polynomials.spelled(key));
    const all = (kind) => steps(statement, kind).map(({ of, is }) => related(of, is));
    const point = Object.entries(certificate.point ?? {}).map(([key, value]) => make("span", {}, ...polynomials.spelled(key), ` = ${value}`));
    const aside = ["define", "root", "inverse"].reduce((sum, kind) => sum + steps(statement, kind).length, 0);
    const items = statement.kind === "induction"
      ? [...listed("Given", statement.assume.map(({ of, is }) => related(of, is))), ...listed("For every n", statement.show.map((p) => related(p, "=")))]
      : statement.kind === "separation"
        ? [...listed("Outputs", statement.outputs.map(named)), ...listed("Avoided", statement.avoid.map(named))]
        : [...listed("Given", all("assume")), ...listed("At", point), ...listed(statement.kind === "refutation" ? "Claimed, and false" : "Shown", all("show"))];
    return make("li", {}, name, ...(aside ? [`, with ${number(aside, "abbreviation")}`] : []), make("ul", {}, ...items));
  }

  function limits() {
    const link = make("a", { href: data.trusted }, "The translation is trusted");
    const nothing = statements.some(({ statement }) => steps(statement, "show").some(({ of }) => Object.keys(of).length === 0));
    const expanded = nothing ? " Where a line reads 0 = 0, the translation has multiplied out, and nothing is left to prove." : "";
    const given = data.given.length ? ` Among the hypotheses, and so not proved here: ${data.given.join("; ")}.` : "";
    return make("p", { class: "check-limits" }, `Not checked here: that these polynomials say what the words above say. `, link, `.${expanded}${given}`);
  }

  async function check() {
    button.disabled = true;
    try {
      const answers = await Promise.all(statements.map(({ statement, certificate }) => clerk.check(statement, certificate)));
      const time = total(answers, (answer) => answer.time), wrong = answers.findIndex((answer) => !answer.accepted);
      if (wrong >= 0) verdict.replaceChildren(...rejected(answers[wrong], statements[wrong].statement, statements[wrong].name));
      else verdict.replaceChildren(line("accepted", "Accepted", `, in ${took(time)}, by this browser. ${done(answers)}`), limits());
      details.replaceChildren(make("details", {}, make("summary", {}, "What was checked"), make("ol", {}, ...statements.map(what))));
    } catch (why) {
      verdict.replaceChildren(...no_verdict(why.message));
      details.replaceChildren();
    }
    button.disabled = false;
  }

  button.addEventListener("click", check);
  doubt.addEventListener("click", () => {
    if (!panel.hasChildNodes()) Checker.editor(panel, statements, polynomials, clerk, told);
    panel.hidden = !panel.hidden;
    doubt.setAttribute("aria-expanded", String(!panel.hidden));
  });
  place.querySelector(".check-body")?.remove(); // of a page that was saved with its buttons
  place.append(make("div", { class: "check-body" }, make("p", { class: "check-buttons" }, button, doubt), verdict, details, panel));
};

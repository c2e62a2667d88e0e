// A kernel that decides whether a certificate proves a statement, written from the documented format (the page "What is
// trusted"), not from another kernel. Whole numbers are BigInt, coefficients are fractions, nothing is rounded.
"use strict";
var Checker = Checker || {};

Checker.kernel = function () {
  class Rejected extends Error {
    constructor(reason, residual) {
      super(reason);
      this.residual = residual;
    }
  }

  function insist(condition, reason, residual) {
    if (!condition) throw new Rejected(reason, residual);
  }

  let work; // what a check has done so far: counted for the reader, never asked by a rule

  // Fractions are [numerator, denominator], in lowest terms, the denominator positive.
  function gcd(a, b) {
    while (b) [a, b] = [b, a % b];
    return a < 0n ? -a : a;
  }

  function reduced(top, bottom) {
    const common = gcd(top, bottom);
    return [top / common, bottom / common];
  }

  const whole = (a, b) => a[1] === 1n && b[1] === 1n;
  const plus = (a, b) => (whole(a, b) ? [a[0] + b[0], 1n] : reduced(a[0] * b[1] + b[0] * a[1], a[1] * b[1]));
  const times = (a, b) => (whole(a, b) ? [a[0] * b[0], 1n] : reduced(a[0] * b[0], a[1] * b[1]));

  const NUMBER = /^-?[0-9]{1,500}(?:\/[0-9]{1,500})?$/, NAME = /^(?:[A-Za-z][A-Za-z0-9_]{0,99}|(?:cos|sin)\([A-Za-z0-9_*\/()+-]{1,99}\))$/;

  // A fraction from its text, which has to be in lowest terms.
  function fraction(text) {
    insist(typeof text === "string" && NUMBER.test(text), `"${text}" is not a fraction`);
    const [top, bottom = "1"] = text.split("/");
    insist(!/^0+$/.test(bottom), `"${text}" is not a fraction`);
    const value = reduced(BigInt(top), BigInt(bottom));
    insist(text === (value[1] === 1n ? `${value[0]}` : `${value[0]}/${value[1]}`), `"${text}" is not a fraction in lowest terms`);
    return value;
  }

  // The form of what is read. `object` insists on these keys and no others, `list` on a list (of so many items).
  const MOST = 100000, RELATIONS = ["=", "!=", ">", ">="];

  function object(data, ...keys) {
    insist(data?.constructor === Object, `an object with ${keys.join(", ")} is missing`);
    const found = Object.keys(data);
    insist(found.length === keys.length && keys.every((key) => Object.hasOwn(data, key)), `${found.join(", ")} stand where ${keys.join(", ")} should`);
    return data;
  }

  function list(data, check, length) {
    insist(Array.isArray(data) && data.length <= MOST && (length ?? data.length) === data.length, "a list is missing, or has another length");
    data.forEach((item) => check(item));
    return data;
  }

  const is_name = (text) => insist(typeof text === "string" && NAME.test(text), `"${text}" is not a name`);
  const is_index = (value) => insist(Number.isInteger(value) && value >= 0 && value <= MOST, `there is no fact ${value}`);
  const is_relation = (text) => insist(RELATIONS.includes(text), `there is no relation "${text}"`);

  function is_polynomial(data) {
    insist(data?.constructor === Object && Object.keys(data).length <= MOST, "a polynomial is missing");
    for (const [monomial, coefficient] of Object.entries(data)) {
      const names = monomial === "" ? [] : monomial.split(" ").map((factor) => {
        const [name, power = "2", ...more] = factor.split("^");
        insist(/^(?:[2-9]|[1-9][0-9]{1,2})$/.test(power) && more.length === 0, `"${factor}" is not a power with an exponent from 2 to 999`);
        is_name(name);
        return name;
      });
      insist(new Set(names).size === names.length, `"${monomial}" has a name twice`);
      insist(fraction(coefficient)[0] !== 0n, `"${monomial}" has the coefficient 0`);
    }
  }

  function is_proof(proof) {
    insist(["ideal", "contradiction"].includes(proof?.rule), `there is no rule "${proof?.rule}"`);
    const pair = (item) => list(item, () => {}, 2) && (is_index(item[0]), is_polynomial(item[1]));
    if (proof.rule === "ideal") return list(object(proof, "rule", "cofactors").cofactors, pair);
    object(proof, "rule", "positive", "sum", "cofactors");
    list(proof.positive, is_index);
    list(proof.sum, (item) => list(item, () => {}, 3) && (fraction(item[0]), is_polynomial(item[1]), list(item[2], is_index)));
    return list(proof.cofactors, pair);
  }

  function is_step(step) {
    const kinds = { assume: "is", show: "is", define: "new", root: "new", inverse: "new" };
    insist(typeof step?.step === "string" && Object.hasOwn(kinds, step.step), `there is no step "${step?.step}"`);
    const key = kinds[step.step];
    object(step, "step", key, "of");
    (key === "is" ? is_relation : is_name)(step[key]);
    is_polynomial(step.of);
  }

  // A polynomial is a Map from words to coefficients other than 0. The word of x²y is "x x y": names in a fixed order.
  const ONE = [1n, 1n], MINUS = [-1n, 1n];
  const constant = (value) => new Map(value[0] ? [["", value]] : []);
  const variable = (name) => new Map([[name, ONE]]);

  function put(polynomial, word, coefficient) {
    const known = polynomial.get(word), sum = known ? plus(known, coefficient) : coefficient;
    if (sum[0]) polynomial.set(word, sum);
    else polynomial.delete(word);
  }

  function join(a, b) {
    return a && b ? `${a} ${b}`.split(" ").sort().join(" ") : a || b;
  }

  function product(p, q) {
    const found = new Map();
    for (const [a, c] of p) for (const [b, d] of q) put(found, join(a, b), times(c, d));
    work.products += p.size * q.size;
    return found;
  }

  // p + factor · q, for a number as the factor.
  function combined(p, q, factor = ONE) {
    const found = new Map(p);
    for (const [word, c] of q) put(found, word, times(factor, c));
    return found;
  }

  // The polynomial {"x^2 y": "-3/2", "": "1"}; `scope` has what each name stands for.
  function read(data, scope) {
    is_polynomial(data);
    let total = new Map();
    for (const [monomial, coefficient] of Object.entries(data)) {
      let term = constant(fraction(coefficient));
      for (const factor of monomial.split(" ").filter((text) => text !== "")) {
        const [name, power = "1"] = factor.split("^");
        insist(scope.has(name), `${name} stands for nothing here`);
        for (let i = 0; i < Number(power); i++) term = product(term, scope.get(name));
      }
      total = combined(total, term);
    }
    return total;
  }

  // Polynomials and relations: a fact or goal is {p, is}, which says that p is = 0, ≠ 0, > 0 or ≥ 0.
  const NEGATION = { "=": [ONE, "!="], "!=": [ONE, "="], ">": [MINUS, ">="], ">=": [MINUS, ">"] }; // not p > 0: −p ≥ 0

  function known(facts, index, relations) {
    insist(Number.isInteger(index) && index >= 0 && index < facts.length, `there is no fact ${index}`);
    insist(relations.includes(facts[index].is), `fact ${index} is "${facts[index].is} 0", not ${relations.join(" or ")}`);
    return facts[index];
  }

  // Π of facts that are > 0 (or of squares, where ≠ 0 is known), + Σ c s² Π of facts that are ≥ 0: it is positive.
  function positive(proof, facts, scope) {
    let total = constant(ONE);
    for (const index of proof.positive) {
      const { p, is } = known(facts, index, [">", "!="]);
      total = product(is === ">" ? p : product(p, p), total);
    }
    for (const [weight, root, indices] of proof.sum) {
      const c = fraction(weight), s = read(root, scope);
      insist(c[0] >= 0n, "a square has a negative weight");
      let term = product(constant(c), product(s, s));
      for (const index of indices) term = product(term, known(facts, index, [">", ">="]).p);
      total = combined(total, term);
    }
    return total;
  }

  function prove(goal, facts, proof, scope) {
    let left = goal.p;
    if (proof.rule === "ideal") insist(goal.is === "=", "membership in an ideal proves equations only");
    else {
      const [sign, is] = NEGATION[goal.is];
      facts = [...facts, { p: combined(new Map(), goal.p, sign), is }];
      left = positive(proof, facts, scope);
    }
    for (const [index, cofactor] of proof.cofactors)
      left = combined(left, product(read(cofactor, scope), known(facts, index, ["="]).p), MINUS); // − q g
    work.identities++;
    insist(left.size === 0, "the two sides differ", left);
  }

  // A name may stand for something once only.
  function introduce(scope, name, polynomial) {
    insist(!scope.has(name), `${name} is introduced twice`);
    scope.set(name, polynomial);
  }

  // Goes through the steps of a derivation, and yields every goal to be met with the facts and the scope of its place.
  // `stands(name)` is what a variable, a root or an inverse stands for: itself, or a number.
  function* goals(statement, facts, stands) {
    const scope = new Map();
    object(statement, "version", "kind", "variables", "steps");
    list(statement.variables, is_name);
    list(statement.steps, is_step);
    for (const name of statement.variables) introduce(scope, name, stands(name));
    for (const [index, step] of statement.steps.entries()) {
      const p = read(step.of, scope), { step: kind, is, new: name } = step;
      work.step = index;
      if (kind === "assume" || kind === "show") {
        if (kind === "show") yield { goal: { p, is }, facts, scope };
        facts.push({ p, is });
      } else if (kind === "define") introduce(scope, name, p);
      else if (kind === "root") {
        yield { goal: { p, is: ">=" }, facts, scope };
        const y = stands(name);
        introduce(scope, name, y);
        facts.push({ p: combined(product(y, y), p, MINUS), is: "=" }, { p: y, is: ">=" });
      } else {
        yield { goal: { p, is: "!=" }, facts, scope };
        introduce(scope, name, stands(name));
        facts.push({ p: combined(product(stands(name), p), constant(ONE), MINUS), is: "=" });
      }
    }
  }

  function derivation(statement, certificate) {
    let number = 0;
    list(object(certificate, "proofs").proofs, is_proof);
    for (const { goal, facts, scope } of goals(statement, [], variable)) {
      insist(number < certificate.proofs.length, "a proof is missing");
      prove(goal, facts, certificate.proofs[number++], scope);
    }
    insist(number === certificate.proofs.length, "a proof is left over");
    insist(statement.steps.some(({ step }) => step === "show"), "nothing is claimed");
  }

  // A point at which everything holds but the last goal: names stand for numbers. π is none of them, a cosine has its sine.
  function refutation(statement, certificate) {
    const { point } = object(certificate, "point"), asked = new Set();
    const at = (name) => {
      insist(name !== "pi", "π is one number, and no coordinate");
      insist(point?.constructor === Object && Object.hasOwn(point, name), `the point has no ${name}`);
      asked.add(name);
      return constant(fraction(point[name]));
    };
    const holds = ({ p, is }) => {
      const sign = p.get("")?.[0] ?? 0n;
      work.identities++;
      return { "=": sign === 0n, "!=": sign !== 0n, ">": sign > 0n, ">=": sign >= 0n }[is];
    };
    const facts = [], obligations = [...goals(statement, facts, at)].map(({ goal }) => goal);
    insist(statement.steps.at(-1)?.step === "show", "nothing is claimed at the end");
    insist(Object.keys(point ?? {}).every((name) => asked.has(name)), "the point has a name too many");
    for (const name of asked)
      if (name.endsWith(")")) {
        const [c, s] = ["cos", "sin"].map((word) => at(word + name.slice(3)));
        insist(combined(combined(product(c, c), product(s, s)), constant(ONE), MINUS).size === 0, `${name} is off the circle`);
      }
    const claim = facts.pop();
    obligations.pop();
    for (const each of [...facts, ...obligations]) insist(holds(each), "a hypothesis fails at the point", each.p);
    insist(!holds(claim), "the claim holds at the point", claim.p);
  }

  function induction(statement, certificate) {
    object(statement, "version", "kind", "variables", "state", "assume", "start", "next", "show");
    const { base, step } = object(certificate, "base", "step"), { variables, state } = statement, fixed = new Map(), now = new Map();
    for (const names of [variables, state]) list(names, is_name);
    for (const proofs of [base, step]) list(proofs, is_proof);
    for (const name of variables) introduce(fixed, name, variable(name));
    for (const name of [...variables, ...state]) introduce(now, name, variable(name));
    list(statement.assume, (given) => is_relation(object(given, "of", "is").is));
    const facts = statement.assume.map(({ of, is }) => ({ p: read(of, fixed), is }));
    const moved = (values, scope) => {
      object(values, ...state);
      return new Map([...fixed, ...state.map((name) => [name, read(values[name], scope)])]);
    };
    const start = moved(statement.start, fixed), next = moved(statement.next, now);
    const claims = list(statement.show, is_polynomial);
    insist(claims.length > 0, "nothing is claimed");
    insist(base.length === claims.length && step.length === claims.length, "a base or a step is missing");
    const carried = claims.map((claim) => ({ p: read(claim, now), is: "=" }));
    claims.forEach((claim, i) => {
      work.step = i;
      prove({ p: read(claim, start), is: "=" }, facts, base[i], now);
      prove({ p: read(claim, next), is: "=" }, [...facts, ...carried], step[i], now);
    });
  }

  function separation(statement, certificate) {
    object(statement, "version", "kind", "lines", "outputs", "avoid");
    for (const names of [statement.outputs, statement.avoid, object(certificate, "reached").reached]) list(names, is_name);
    list(statement.lines, (line) => list(line, () => {}, 2) && (is_name(line[0]), list(line[1], is_name)));
    insist(statement.outputs.length > 0 && statement.avoid.length > 0, "nothing is claimed");
    const reached = new Set(certificate.reached);
    const needed = statement.lines.filter(([name]) => reached.has(name));
    work.identities += needed.length;
    for (const [name, uses] of [["the output", statement.outputs], ...needed])
      for (const use of uses) insist(reached.has(use), `${name} needs ${use}, which the certificate does not list`);
    for (const name of statement.avoid) insist(!reached.has(name), `${name}, which was to be avoided, is reached`);
  }

  const KINDS = { derivation, refutation, induction, separation };

  // A residual in the format's own form, {"x^2 y": "-3/2"}.
  function written(polynomial) {
    const powers = (word) =>
      word.replace(/(?<!\S)(\S+)((?: \1)+)(?!\S)/g, (_, name, more) => `${name}^${1 + more.length / (name.length + 1)}`);
    const entry = ([word, [top, bottom]]) => [powers(word), bottom === 1n ? `${top}` : `${top}/${bottom}`];
    return Object.fromEntries([...polynomial].map(entry));
  }

  // Returns {accepted, reason, residual, work: {identities, products, step}}. What is malformed proves nothing either.
  function check(statement, certificate) {
    work = { identities: 0, products: 0, step: 0 };
    try {
      insist(statement.version === 1, "only version 1 of the format is known");
      insist(typeof statement.kind === "string" && Object.hasOwn(KINDS, statement.kind), `there is no kind "${statement.kind}"`);
      KINDS[statement.kind](statement, certificate);
      return { accepted: true, work };
    } catch (why) {
      const residual = why.residual && written(why.residual);
      return { accepted: false, reason: why.message, residual, work };
    }
  }

  return { check };
};

// Data from its text, which has to be its own canonical form: no key twice, no number that a double rounds.
Checker.parsed = function (text, indent) {
  const data = JSON.parse(text);
  if (JSON.stringify(data, null, indent) !== text) throw new Error("the text is not its own canonical form");
  return data;
};

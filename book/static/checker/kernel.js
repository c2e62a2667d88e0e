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

  function fraction(text) {
    const parts = /^(-?\d+)(?:\/(\d+))?$/.exec(text);
    insist(parts && !/^0+$/.test(parts[2]), `"${text}" is not a fraction`);
    return reduced(BigInt(parts[1]), BigInt(parts[2] ?? 1));
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
    insist(data?.constructor === Object, "a polynomial is missing");
    let total = new Map();
    for (const [monomial, coefficient] of Object.entries(data)) {
      let term = constant(fraction(coefficient));
      for (const factor of monomial.split(" ").filter((text) => text !== "")) {
        const [, name, power = "1"] = /^([^^]+)(?:\^([1-9]\d{0,2}))?$/.exec(factor) ?? [];
        insist(name !== undefined, `"${factor}" is not a power with an exponent from 1 to 999`);
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
    if (proof.rule === "cases") {
      const on = read(proof.on, scope);
      const branches = { "<": { p: combined(new Map(), on, MINUS), is: ">" }, "=": { p: on, is: "=" }, ">": { p: on, is: ">" } };
      for (const [name, fact] of Object.entries(branches)) prove(goal, [...facts, fact], proof.branches[name], scope);
      return;
    }
    insist(["ideal", "contradiction"].includes(proof.rule), `there is no rule "${proof.rule}"`);
    insist(Object.hasOwn(NEGATION, goal.is), `there is no relation "${goal.is}"`);
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
    for (const name of statement.variables) introduce(scope, name, stands(name));
    for (const [index, step] of statement.steps.entries()) {
      const p = read(step.of, scope), { step: kind, is, new: name } = step;
      work.step = index;
      if (kind === "assume" || kind === "show") {
        insist(Object.hasOwn(NEGATION, is), `there is no relation "${is}"`);
        if (kind === "show") yield { goal: { p, is }, facts, scope };
        facts.push({ p, is });
      } else if (kind === "define") introduce(scope, name, p);
      else if (kind === "root") {
        yield { goal: { p, is: ">=" }, facts, scope };
        const y = stands(name);
        introduce(scope, name, y);
        facts.push({ p: combined(product(y, y), p, MINUS), is: "=" }, { p: y, is: ">=" });
      } else if (kind === "inverse") {
        yield { goal: { p, is: "!=" }, facts, scope };
        introduce(scope, name, stands(name));
        facts.push({ p: combined(product(stands(name), p), constant(ONE), MINUS), is: "=" });
      } else insist(false, `there is no step "${kind}"`);
    }
  }

  function derivation(statement, certificate) {
    let number = 0;
    for (const { goal, facts, scope } of goals(statement, [], variable)) {
      insist(number < certificate.proofs.length, "a proof is missing");
      prove(goal, facts, certificate.proofs[number++], scope);
    }
  }

  // A point at which everything holds but the last goal: names stand for numbers.
  function refutation(statement, certificate) {
    const at = (name) => {
      insist(Object.hasOwn(certificate.point, name), `the point has no ${name}`);
      return constant(fraction(certificate.point[name]));
    };
    const holds = ({ p, is }) => {
      const sign = p.get("")?.[0] ?? 0n;
      work.identities++;
      return { "=": sign === 0n, "!=": sign !== 0n, ">": sign > 0n, ">=": sign >= 0n }[is];
    };
    const facts = [], obligations = [...goals(statement, facts, at)].map(({ goal }) => goal);
    insist(statement.steps.at(-1)?.step === "show", "nothing is claimed at the end");
    const claim = facts.pop();
    obligations.pop();
    for (const each of [...facts, ...obligations]) insist(holds(each), "a hypothesis fails at the point", each.p);
    insist(!holds(claim), "the claim holds at the point", claim.p);
  }

  function induction(statement, certificate) {
    const { variables, state } = statement, fixed = new Map(), now = new Map();
    for (const name of variables) introduce(fixed, name, variable(name));
    for (const name of [...variables, ...state]) introduce(now, name, variable(name));
    const facts = statement.assume.map(({ of, is }) => ({ p: read(of, fixed), is }));
    const moved = (values, scope) => {
      insist(state.every((name) => Object.hasOwn(values, name)), "a state is not given");
      return new Map([...fixed, ...state.map((name) => [name, read(values[name], scope)])]);
    };
    const start = moved(statement.start, fixed), next = moved(statement.next, now);
    const claims = [...statement.show, ...certificate.strengthen], { base, step } = certificate;
    insist(base.length === claims.length && step.length === claims.length, "a base or a step is missing");
    const carried = claims.map((claim) => ({ p: read(claim, now), is: "=" }));
    claims.forEach((claim, i) => {
      work.step = i;
      prove({ p: read(claim, start), is: "=" }, facts, base[i], now);
      prove({ p: read(claim, next), is: "=" }, [...facts, ...carried], step[i], now);
    });
  }

  function separation(statement, certificate) {
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
      insist(Object.hasOwn(KINDS, statement.kind), `there is no kind "${statement.kind}"`);
      KINDS[statement.kind](statement, certificate);
      return { accepted: true, work };
    } catch (why) {
      const residual = why.residual && written(why.residual);
      return { accepted: false, reason: why.message, residual, work };
    }
  }

  return { check };
};

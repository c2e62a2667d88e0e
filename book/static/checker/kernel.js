// A kernel that decides whether a certificate proves a statement, written from the documented format (the page "What is
// trusted"), not from another kernel. Whole numbers are BigInt, coefficients are fractions, nothing is rounded.
"use strict";
var Checker = Checker || {};

Checker.kernel = function () {
  function insist(condition, reason, residual) {
    if (!condition) throw Object.assign(new Error(reason), { residual });
  }

  let work; // what a check has done so far: counted for the reader, never asked by a rule

  // Fractions are [numerator, denominator], in lowest terms, the denominator positive.
  function reduced(top, bottom) {
    let [a, b] = [top, bottom];
    while (b) [a, b] = [b, a % b];
    const common = a < 0n ? -a : a;
    return [top / common, bottom / common];
  }

  const ONE = [1n, 1n], MINUS = [-1n, 1n];
  const whole = (a, b) => a[1] === 1n && b[1] === 1n;
  const plus = (a, b) => (whole(a, b) ? [a[0] + b[0], 1n] : reduced(a[0] * b[1] + b[0] * a[1], a[1] * b[1]));
  const times = (a, b) => (whole(a, b) ? [a[0] * b[0], 1n] : reduced(a[0] * b[0], a[1] * b[1]));
  const printed = ([top, bottom]) => (bottom === 1n ? `${top}` : `${top}/${bottom}`);

  // A fraction from its text, which has to be in lowest terms.
  function fraction(text) {
    const [, top, bottom = "1"] = (typeof text === "string" && /^(-?[0-9]{1,500})(?:\/([0-9]{1,500}))?$/.exec(text)) || [];
    insist(top && !/^0+$/.test(bottom), `"${text}" is not a fraction`);
    const value = reduced(BigInt(top), BigInt(bottom));
    insist(printed(value) === text, `"${text}" is not a fraction in lowest terms`);
    return value;
  }

  // The form of what is read. A form is a function that insists, [form of each item], [forms of so many items], or
  // {key: form}: these keys and no others.
  const MOST = 100000, any = () => {};

  function has_form(data, form) {
    if (typeof form === "function") form(data);
    else if (Array.isArray(form)) {
      insist(Array.isArray(data) && data.length <= MOST && [1, data.length].includes(form.length), "a list is missing, or has another length");
      data.forEach((item, i) => has_form(item, form[i] ?? form[0]));
    } else {
      const wanted = Object.keys(form), found = keys(data, `an object with ${wanted.join(", ")}`);
      insist(found.length === wanted.length && wanted.every((key) => found.includes(key)), `${found.join(", ")} stand where ${wanted.join(", ")} should`);
      for (const key of wanted) has_form(data[key], form[key]);
    }
  }

  function keys(data, what) {
    const simple = data !== null && typeof data === "object" && Object.getPrototypeOf(data) === Object.prototype;
    insist(simple && Object.keys(data).length <= MOST, `${what} is missing`);
    return Object.keys(data);
  }

  const NAME = "(?:[A-Za-z][A-Za-z0-9_]{0,99}|(?:cos|sin)\\([A-Za-z0-9_*/()+-]{1,99}\\))", POWER = `${NAME}(?:\\^(?:[2-9]|[1-9][0-9]{1,2}))?`;
  const [ONE_NAME, MONOMIAL] = [NAME, `(?:${POWER}(?: ${POWER})*)?`].map((form) => new RegExp(`^${form}$`));
  const name = (text) => insist(typeof text === "string" && ONE_NAME.test(text), `"${text}" is not a name`);
  const index = (value) => insist(Number.isInteger(value) && value >= 0 && value <= MOST, `there is no fact ${value}`);
  const HOLDS = { "=": (sign) => sign === 0n, "!=": (sign) => sign !== 0n, ">": (sign) => sign > 0n, ">=": (sign) => sign >= 0n };
  const relation = (text) => insist(Object.keys(HOLDS).includes(text), `there is no relation "${text}"`);
  const by_name = (form) => (data) => keys(data, "an object").forEach((key) => (name(key), form(data[key])));

  // [[name, exponent as text], …] of "x^2 y".
  const powers = (monomial) => monomial.split(" ").filter(Boolean).map((factor) => [...factor.split("^"), "1"].slice(0, 2));

  function polynomial(data) {
    for (const monomial of keys(data, "a polynomial")) {
      insist(MONOMIAL.test(monomial), `"${monomial}" is no product of powers of names, each exponent from 2 to 999`);
      insist(new Map(powers(monomial)).size === powers(monomial).length, `"${monomial}" has a name twice`);
      insist(fraction(data[monomial])[0] !== 0n, `"${monomial}" has the coefficient 0`);
    }
  }

  // What has one of several kinds: the kind stands at a key, and says which the other keys are.
  const kinds = (key, forms) => (data) => {
    insist(typeof data?.[key] === "string" && Object.hasOwn(forms, data[key]), `there is no ${key} "${data?.[key]}"`);
    has_form(data, { [key]: any, ...forms[data[key]] });
  };
  const cofactors = [[index, polynomial]], sum = [[fraction, polynomial, [index]]];
  const proofs = [kinds("rule", { ideal: { cofactors }, contradiction: { positive: [index], sum, cofactors } })];
  const said = { is: relation, of: polynomial }, made = { new: name, of: polynomial };
  const steps = [kinds("step", { assume: said, show: said, define: made, root: made, inverse: made })];
  const version = (value) => insist(value === 1, "only version 1 of the format is known");
  const values = by_name(polynomial), all = { kind: any, version, variables: [name] };
  const RULES = {
    derivation: [derivation, { ...all, steps }, { proofs }],
    refutation: [refutation, { ...all, steps }, { point: by_name(fraction) }],
    induction: [induction, { ...all, state: [name], assume: [said], start: values, next: values, show: [polynomial] }, { base: proofs, step: proofs }],
    separation: [separation, { kind: any, version, lines: [[name, [name]]], outputs: [name], avoid: [name] }, { reached: [name] }],
  };

  // A polynomial is a Map from words to coefficients other than 0. The word of x²y is "x x y": names in a fixed order.
  const constant = (value) => new Map(value[0] ? [["", value]] : []);
  const variable = (name) => new Map([[name, ONE]]);
  const join = (a, b) => (a && b ? `${a} ${b}`.split(" ").sort().join(" ") : a || b);

  // Adds factor · word · q to p, and returns it: a number, and names that are multiplied.
  function add(p, q, factor = ONE, word = "") {
    for (const [other, c] of q) {
      const product = join(word, other), value = times(factor, c), total = p.has(product) ? plus(p.get(product), value) : value;
      if (total[0]) p.set(product, total);
      else p.delete(product);
    }
    return p;
  }

  const less = (p, q) => add(new Map(p), q, MINUS);

  function product(p, q) {
    work.products += p.size * q.size;
    return [...p].reduce((found, [word, c]) => add(found, q, c, word), new Map());
  }

  // The polynomial {"x^2 y": "-3/2", "": "1"}; `scope` has what each name stands for.
  function read(data, scope) {
    const total = new Map();
    for (const [monomial, coefficient] of Object.entries(data)) {
      let term = constant(fraction(coefficient));
      for (const [name, power] of powers(monomial)) {
        insist(scope.has(name), `${name} stands for nothing here`);
        for (let i = 0; i < Number(power); i++) term = product(term, scope.get(name));
      }
      add(total, term);
    }
    return total;
  }

  // A fact or goal is {p, is}, which says that the polynomial p is = 0, ≠ 0, > 0 or ≥ 0.
  const NEGATION = { "=": [ONE, "!="], "!=": [ONE, "="], ">": [MINUS, ">="], ">=": [MINUS, ">"] }; // not p > 0: −p ≥ 0

  function prove({ p, is }, facts, { rule, positive, sum, cofactors }, scope) {
    const known = (index, ...relations) => {
      insist(index < facts.length, `there is no fact ${index}`);
      insist(relations.includes(facts[index].is), `fact ${index} is "${facts[index].is} 0", not ${relations.join(" or ")}`);
      return facts[index];
    };
    let left = p;
    if (rule === "ideal") insist(is === "=", "membership in an ideal proves equations only");
    else {
      // Π of facts that are > 0 (or of squares, where ≠ 0 is known), + Σ c s² Π of facts that are ≥ 0: it is positive.
      const [sign, opposite] = NEGATION[is];
      facts = [...facts, { p: add(new Map(), p, sign), is: opposite }];
      const strict = positive.map((index) => known(index, ">", "!="));
      left = strict.flatMap(({ p, is }) => (is === ">" ? [p] : [p, p])).reduce(product, constant(ONE));
      for (const [weight, root, indices] of sum) {
        const c = fraction(weight), s = read(root, scope);
        insist(c[0] >= 0n, "a square has a negative weight");
        left = add(left, [s, s, ...indices.map((index) => known(index, ">", ">=").p)].reduce(product, constant(c)));
      }
    }
    for (const [index, cofactor] of cofactors) left = less(left, product(read(cofactor, scope), known(index, "=").p));
    work.identities++;
    insist(left.size === 0, "the two sides differ", left);
  }

  // A name may stand for something once only. `stands(name)` is what: itself, or a number.
  function introduce(scope, names, stands = variable) {
    for (const name of names) {
      insist(!scope.has(name), `${name} is introduced twice`);
      scope.set(name, stands(name));
    }
    return scope;
  }

  // Goes through the steps of a derivation, and yields every goal to be met with the facts and the scope of its place.
  function* goals(statement, facts, stands) {
    const scope = introduce(new Map(), statement.variables, stands);
    for (const [number, { step: kind, is, new: name, of }] of statement.steps.entries()) {
      const p = read(of, scope), goal = { p, is: { root: ">=", inverse: "!=" }[kind] ?? is };
      work.step = number;
      if (kind === "show" || kind === "root" || kind === "inverse") yield { goal, facts, scope };
      if (is) facts.push(goal);
      else introduce(scope, [name], kind === "define" ? () => p : stands);
      const y = scope.get(name);
      if (kind === "root") facts.push({ p: less(product(y, y), p), is: "=" }, { p: y, is: ">=" });
      if (kind === "inverse") facts.push({ p: less(product(y, p), constant(ONE)), is: "=" });
    }
  }

  function derivation(statement, { proofs }) {
    const waiting = [...proofs];
    for (const { goal, facts, scope } of goals(statement, [], variable)) {
      insist(waiting.length > 0, "a proof is missing");
      prove(goal, facts, waiting.shift(), scope);
    }
    insist(waiting.length === 0, "a proof is left over");
    insist(statement.steps.some(({ step }) => step === "show"), "nothing is claimed");
  }

  // A point at which everything holds but the last goal: names stand for numbers. π is none of them, a cosine has its sine.
  function refutation(statement, { point }) {
    const made = statement.steps.filter(({ step }) => step === "root" || step === "inverse"), facts = [];
    const asked = [...statement.variables, ...made.map(({ new: name }) => name)];
    has_form(point, Object.fromEntries(asked.map((name) => [name, any])));
    insist(!asked.includes("pi"), "π is one number, and no coordinate");
    const at = (name) => constant(fraction(point[name]));
    const holds = ({ p, is }) => {
      work.identities++;
      return HOLDS[is](p.get("")?.[0] ?? 0n);
    };
    const obligations = [...goals(statement, facts, at)].map(({ goal }) => goal).slice(0, -1), claim = facts.pop();
    insist(statement.steps.at(-1)?.step === "show", "nothing is claimed at the end");
    for (const name of asked.filter((name) => name.endsWith(")"))) {
      const pair = ["cos", "sin"].map((word) => word + name.slice(3));
      insist(pair.every((each) => asked.includes(each)), `${name} stands alone`);
      const [c, s] = pair.map(at), off = less(add(product(c, c), product(s, s)), constant(ONE));
      insist(off.size === 0, `${name} is off the circle`);
    }
    for (const each of [...facts, ...obligations]) insist(holds(each), "a hypothesis fails at the point", each.p);
    insist(!holds(claim), "the claim holds at the point", claim.p);
  }

  function induction({ variables, state, assume, start, next, show }, certificate) {
    const fixed = introduce(new Map(), variables), now = introduce(new Map(fixed), state);
    const given = assume.map(({ of, is }) => ({ p: read(of, fixed), is }));
    const equations = (scope) => show.map((claim) => ({ p: read(claim, scope), is: "=" }));
    const moved = (values, scope) => {
      has_form(values, Object.fromEntries(state.map((name) => [name, any])));
      return new Map([...fixed, ...state.map((name) => [name, read(values[name], scope)])]);
    };
    const cases = [[certificate.base, moved(start, fixed), given], [certificate.step, moved(next, now), [...given, ...equations(now)]]];
    insist(show.length > 0, "nothing is claimed");
    for (const [proofs, scope, facts] of cases) {
      insist(proofs.length === show.length, "a base or a step is missing");
      equations(scope).forEach((goal, number) => prove(goal, facts, proofs[(work.step = number)], now));
    }
  }

  function separation({ lines, outputs, avoid }, certificate) {
    const reached = new Set(certificate.reached), needed = lines.filter(([name]) => reached.has(name));
    insist(outputs.length > 0 && avoid.length > 0, "nothing is claimed");
    work.identities += needed.length;
    for (const [name, uses] of [["the output", outputs], ...needed])
      for (const use of uses) insist(reached.has(use), `${name} needs ${use}, which the certificate does not list`);
    for (const name of avoid) insist(!reached.has(name), `${name}, which was to be avoided, is reached`);
  }

  // A residual in the format's own form, {"x^2 y": "-3/2"}.
  function written(polynomial) {
    const shorter = (word) =>
      word.replace(/(?<!\S)(\S+)((?: \1)+)(?!\S)/g, (_, name, more) => `${name}^${1 + more.length / (name.length + 1)}`);
    return Object.fromEntries([...polynomial].map(([word, value]) => [shorter(word), printed(value)]));
  }

  // Returns {accepted, reason, residual, work: {identities, products, step}}. What is malformed proves nothing either.
  function check(statement, certificate) {
    work = { identities: 0, products: 0, step: 0 };
    try {
      insist(Object.keys(RULES).includes(statement.kind), `there is no kind "${statement.kind}"`);
      const [rule, said, shown] = RULES[statement.kind];
      has_form(statement, said);
      has_form(certificate, shown);
      rule(statement, certificate);
      return { accepted: true, work };
    } catch (why) {
      return { accepted: false, reason: why.message, residual: why.residual && written(why.residual), work };
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

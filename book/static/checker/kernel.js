// A kernel that decides whether a certificate proves a statement, written from the documented format (the page "What is
// trusted"), not from another kernel. Whole numbers are BigInt, coefficients are fractions, nothing is rounded.
"use strict";

function certificate_kernel() {
  /** @param {unknown} condition @param {string} reason @param {Polynomial} [residual] @returns {asserts condition} */
  function insist(condition, reason, residual) {
    if (!condition) throw Object.assign(new Error(reason), { residual });
  }

  let work = { identities: 0, products: 0, step: 0 }; // counted for the reader, never asked by a rule

  /** @param {bigint} top @param {bigint} bottom @returns {Fraction} */
  function reduced(top, bottom) {
    let [a, b] = [top, bottom];
    while (b) [a, b] = [b, a % b];
    const common = a < 0n ? -a : a;
    return [top / common, bottom / common];
  }

  /** @type {Fraction} */
  const ONE = [1n, 1n];
  /** @type {Fraction} */
  const MINUS = [-1n, 1n];
  /** @param {Fraction} a @param {Fraction} b */
  const plus = (a, b) => reduced(a[0] * b[1] + b[0] * a[1], a[1] * b[1]);
  /** @param {Fraction} a @param {Fraction} b */
  const times = (a, b) => reduced(a[0] * b[0], a[1] * b[1]);
  /** @param {Fraction} fraction */
  const printed = ([top, bottom]) => (bottom === 1n ? `${top}` : `${top}/${bottom}`);

  /** A fraction from its text, which has to be in lowest terms. @param {unknown} text */
  function fraction(text) {
    const [, top, bottom = "1"] = /^(-?[0-9]{1,500})(?:\/([0-9]{1,500}))?$/.exec(`${text}`) ?? [];
    insist(top && !/^0+$/.test(bottom), `"${text}" is not a fraction`);
    const value = reduced(BigInt(top), BigInt(bottom));
    insist(printed(value) === text, `"${text}" is not a fraction in lowest terms`);
    return value;
  }

  // The form of what is read. A form is a function that insists, [form of each item], [forms of so many items], or
  // {key: form}: these keys and no others.
  const MOST = 100000;
  const any = () => {};

  /** @param {any} data @param {any} form */
  function has_form(data, form) {
    if (typeof form === "function") form(data);
    else if (Array.isArray(form)) {
      insist(
        Array.isArray(data) && data.length <= MOST && [1, data.length].includes(form.length),
        "a list is missing, or has another length"
      );
      for (const [i, item] of data.entries()) has_form(item, form[i] ?? form[0]);
    } else {
      const wanted = Object.keys(form);
      const found = keys(data, `an object with ${wanted.join(", ")}`);
      insist(
        found.length === wanted.length && wanted.every((key) => found.includes(key)),
        `${found.join(", ")} stand where ${wanted.join(", ")} should`
      );
      for (const key of wanted) has_form(data[key], form[key]);
    }
  }

  /** @param {any} data @param {string} what */
  function keys(data, what) {
    const simple = data !== null && typeof data === "object" && Object.getPrototypeOf(data) === Object.prototype;
    insist(simple && Object.keys(data).length <= MOST, `${what} is missing`);
    return Object.keys(data);
  }

  const NAME = "(?:[A-Za-z][A-Za-z0-9_]{0,99}|(?:cos|sin)\\([A-Za-z0-9_*/()+-]{1,99}\\))";
  const POWER = `${NAME}(?:\\^(?:[2-9]|[1-9][0-9]{1,2}))?`;
  const [ONE_NAME, MONOMIAL] = [NAME, `(?:${POWER}(?: ${POWER})*)?`].map((form) => new RegExp(`^${form}$`));
  /** @param {any} text */
  function name(text) {
    insist(typeof text === "string" && ONE_NAME.test(text), `"${text}" is not a name`);
  }
  /** @param {any} value */
  function index(value) {
    insist(Number.isInteger(value) && value >= 0 && value <= MOST, `there is no fact ${value}`);
  }
  /** @type {Record<string, (sign: bigint) => boolean>} */
  const HOLDS = {
    "=": (sign) => sign === 0n,
    "!=": (sign) => sign !== 0n,
    ">": (sign) => sign > 0n,
    ">=": (sign) => sign >= 0n
  };
  /** @param {any} text */
  function relation(text) {
    insist(Object.keys(HOLDS).includes(text), `there is no relation "${text}"`);
  }
  /** @param {(value: any) => void} form @returns {(data: any) => void} */
  const by_name = (form) => (data) => {
    for (const key of keys(data, "an object")) {
      name(key);
      form(data[key]);
    }
  };

  /** The names of "x^2 y", each with its exponent as text. @param {string} monomial @returns {[string, string][]} */
  function powers(monomial) {
    const factors = monomial.split(" ").filter(Boolean);
    return factors.map((factor) => {
      const [name, power = "1"] = factor.split("^");
      return [name, power];
    });
  }

  /** @param {any} data */
  function polynomial(data) {
    for (const monomial of keys(data, "a polynomial")) {
      insist(MONOMIAL.test(monomial), `"${monomial}" is no product of powers of names, each exponent from 2 to 999`);
      insist(new Map(powers(monomial)).size === powers(monomial).length, `"${monomial}" has a name twice`);
      insist(fraction(data[monomial])[0] !== 0n, `"${monomial}" has the coefficient 0`);
    }
  }

  // What has one of several kinds: the kind stands at a key, and says which the other keys are.
  /** @param {string} key @param {Record<string, object>} forms @returns {(data: any) => void} */
  const kinds = (key, forms) => (data) => {
    insist(typeof data?.[key] === "string" && Object.hasOwn(forms, data[key]), `there is no ${key} "${data?.[key]}"`);
    has_form(data, { [key]: any, ...forms[data[key]] });
  };
  const cofactors = [[index, polynomial]];
  const sum = [[fraction, polynomial, [index]]];
  const proofs = [kinds("rule", { ideal: { cofactors }, contradiction: { positive: [index], sum, cofactors } })];
  const said = { is: relation, of: polynomial };
  const made = { new: name, of: polynomial };
  const steps = [kinds("step", { assume: said, show: said, define: made, root: made, inverse: made })];
  /** @param {any} value */
  function version(value) {
    insist(value === 1, "only version 1 of the format is known");
  }
  const values = by_name(polynomial);
  const all = { kind: any, version, variables: [name] };
  /** @type {Record<string, [(statement: any, certificate: any) => void, object, object]>} */
  const RULES = {
    derivation: [derivation, { ...all, steps }, { proofs }],
    refutation: [refutation, { ...all, steps }, { point: by_name(fraction) }],
    induction: [
      induction,
      { ...all, state: [name], assume: [said], start: values, next: values, show: [polynomial] },
      { base: proofs, step: proofs }
    ],
    separation: [
      separation,
      { kind: any, version, lines: [[name, [name]]], outputs: [name], avoid: [name] },
      { reached: [name] }
    ]
  };

  /** @param {Fraction} value @returns {Polynomial} */
  const constant = (value) => new Map(value[0] ? [["", value]] : []);
  /** @param {string} name @returns {Polynomial} */
  const variable = (name) => new Map([[name, ONE]]);
  /** @param {string} a @param {string} b */
  const join = (a, b) => (a && b ? `${a} ${b}`.split(" ").sort().join(" ") : a || b);

  /** Adds factor · word · q to p, and returns it: a number, and names that are multiplied. @param {Polynomial} p @param {Polynomial} q */
  function add(p, q, factor = ONE, word = "") {
    for (const [other, c] of q) {
      const product = join(word, other);
      const value = times(factor, c);
      const old = p.get(product);
      const total = old ? plus(old, value) : value;
      if (total[0]) p.set(product, total);
      else p.delete(product);
    }
    return p;
  }

  /** @param {Polynomial} p @param {Polynomial} q */
  const less = (p, q) => add(new Map(p), q, MINUS);

  const LARGE = 1n << BigInt(MOST);
  /** @param {Polynomial} p */
  const degree = (p) => [...p.keys()].reduce((most, word) => Math.max(most, word ? word.split(" ").length : 0), 0);

  /** One that would take more than seconds is refused. @param {Polynomial} p @param {Polynomial} q */
  function product(p, q) {
    work.products += p.size * q.size;
    insist(p.size * q.size * (1 + degree(p) + degree(q)) <= MOST, "a product is too long");
    for (const [top] of [...p.values(), ...q.values()]) insist(-LARGE < top && top < LARGE, "a number is too long");
    return [...p].reduce((found, [word, c]) => add(found, q, c, word), constant([0n, 1n]));
  }

  /** The polynomial {"x^2 y": "-3/2", "": "1"}. @param {PolynomialData} data @param {Scope} scope */
  function read(data, scope) {
    const total = constant([0n, 1n]);
    for (const [monomial, coefficient] of Object.entries(data)) {
      let term = constant(fraction(coefficient));
      for (const [name, power] of powers(monomial)) {
        const value = scope.get(name);
        insist(value, `${name} stands for nothing here`);
        for (let i = 0; i < Number(power); i++) term = product(term, value);
      }
      add(total, term);
    }
    return total;
  }

  /** @type {Record<string, [Fraction, string]>} */
  const NEGATION = { "=": [ONE, "!="], "!=": [ONE, "="], ">": [MINUS, ">="], ">=": [MINUS, ">"] }; // not p > 0: −p ≥ 0

  /** @param {Fact} goal @param {Fact[]} given @param {any} proof @param {Scope} scope */
  function prove({ p, is }, given, { rule, positive, sum, cofactors }, scope) {
    let facts = given;
    /** @param {number} index @param {...string} relations */
    const known = (index, ...relations) => {
      insist(index < facts.length, `there is no fact ${index}`);
      insist(
        relations.includes(facts[index].is),
        `fact ${index} is "${facts[index].is} 0", not ${relations.join(" or ")}`
      );
      return facts[index];
    };
    let left = p;
    if (rule === "ideal") insist(is === "=", "membership in an ideal proves equations only");
    else {
      // Π of facts that are > 0 (or of squares, where ≠ 0 is known), + Σ c s² Π of facts that are ≥ 0: it is positive.
      const [sign, opposite] = NEGATION[is];
      facts = [...facts, { p: add(new Map(), p, sign), is: opposite }];
      left = constant(ONE);
      for (const index of positive) {
        const { p, is } = known(index, ">", "!=");
        left = product(left, p);
        if (is === "!=") left = product(left, p);
      }
      for (const [weight, root, indices] of sum) {
        const c = fraction(weight);
        const s = read(root, scope);
        insist(c[0] >= 0n, "a square has a negative weight");
        const others = indices.map((/** @type {number} */ index) => known(index, ">", ">=").p);
        left = add(left, [s, s, ...others].reduce(product, constant(c)));
      }
    }
    for (const [index, cofactor] of cofactors) left = less(left, product(read(cofactor, scope), known(index, "=").p));
    work.identities++;
    insist(left.size === 0, "the two sides differ", left);
  }

  /** A name may stand for something once only. `stands(name)` is what: itself, or a number. @param {Scope} scope @param {string[]} names */
  function introduce(scope, names, stands = variable) {
    for (const name of names) {
      insist(!scope.has(name), `${name} is introduced twice`);
      scope.set(name, stands(name));
    }
    return scope;
  }

  /**
   * Goes through the steps of a derivation, and yields every goal to be met with the facts and the scope of its place.
   * @param {any} statement
   * @param {Fact[]} facts
   * @param {(name: string) => Polynomial} stands
   */
  function* goals(statement, facts, stands) {
    const scope = introduce(new Map(), statement.variables, stands);
    for (const [number, { step: kind, is, new: name, of }] of statement.steps.entries()) {
      const p = read(of, scope);
      const goal = { p, is: kind === "root" ? ">=" : kind === "inverse" ? "!=" : is };
      work.step = number;
      if (["show", "root", "inverse"].includes(kind)) yield { goal, facts, scope };
      if (is) facts.push(goal);
      else {
        const y = kind === "define" ? p : stands(name);
        introduce(scope, [name], () => y);
        if (kind === "root") facts.push({ p: less(product(y, y), p), is: "=" }, { p: y, is: ">=" });
        if (kind === "inverse") facts.push({ p: less(product(y, p), constant(ONE)), is: "=" });
      }
    }
  }

  /** @param {any} statement @param {any} certificate */
  function derivation(statement, { proofs }) {
    const waiting = [...proofs];
    for (const { goal, facts, scope } of goals(statement, [], variable)) {
      insist(waiting.length > 0, "a proof is missing");
      prove(goal, facts, waiting.shift(), scope);
    }
    insist(waiting.length === 0, "a proof is left over");
    insist(
      statement.steps.some((/** @type {Step} */ { step }) => step === "show"),
      "nothing is claimed"
    );
  }

  /**
   * A point at which everything holds but the last goal: names stand for numbers. π is none of them, a cosine has its
   * sine.
   * @param {any} statement
   * @param {any} certificate
   */
  function refutation(statement, { point }) {
    /** @type {Fact[]} */
    const facts = [];
    const asked = [...statement.variables];
    for (const { step, new: name } of statement.steps) if (step === "root" || step === "inverse") asked.push(name);
    has_form(point, Object.fromEntries(asked.map((name) => [name, any])));
    insist(!asked.includes("pi"), "π is one number, and no coordinate");
    /** @param {string} name */
    const at = (name) => constant(fraction(point[name]));
    /** @param {Fact} fact */
    const holds = ({ p, is }) => {
      work.identities++;
      return HOLDS[is](p.get("")?.[0] ?? 0n);
    };
    const obligations = [...goals(statement, facts, at)].map(({ goal }) => goal).slice(0, -1);
    const claim = facts.pop();
    insist(claim && statement.steps.at(-1).step === "show", "nothing is claimed at the end");
    for (const name of asked.filter((name) => name.endsWith(")"))) {
      const pair = ["cos", "sin"].map((word) => word + name.slice(3));
      insist(
        pair.every((each) => asked.includes(each)),
        `${name} stands alone`
      );
      const [c, s] = pair.map(at);
      const off = less(add(product(c, c), product(s, s)), constant(ONE));
      insist(off.size === 0, `${name} is off the circle`);
    }
    for (const each of [...facts, ...obligations]) insist(holds(each), "a hypothesis fails at the point", each.p);
    insist(!holds(claim), "the claim holds at the point", claim.p);
  }

  /** @param {any} statement @param {any} certificate */
  function induction({ variables, state, assume, start, next, show }, certificate) {
    const fixed = introduce(new Map(), variables);
    const now = introduce(new Map(fixed), state);
    /** @type {Fact[]} */
    const given = assume.map((/** @type {Fact & Step} */ { of, is }) => ({ p: read(of, fixed), is }));
    /** @param {Scope} scope @returns {Fact[]} */
    const equations = (scope) =>
      show.map((/** @type {PolynomialData} */ claim) => ({ p: read(claim, scope), is: "=" }));
    /** @param {any} values @param {Scope} scope */
    const moved = (values, scope) => {
      has_form(values, Object.fromEntries(state.map((/** @type {string} */ name) => [name, any])));
      return introduce(new Map(fixed), state, (name) => read(values[name], scope));
    };
    const cases = [
      { proofs: certificate.base, scope: moved(start, fixed), facts: given },
      { proofs: certificate.step, scope: moved(next, now), facts: [...given, ...equations(now)] }
    ];
    insist(show.length > 0, "nothing is claimed");
    for (const { proofs, scope, facts } of cases) {
      insist(proofs.length === show.length, "a base or a step is missing");
      for (const [number, goal] of equations(scope).entries()) {
        work.step = number;
        prove(goal, facts, proofs[number], now);
      }
    }
  }

  /** @param {any} statement @param {any} certificate */
  function separation({ lines, outputs, avoid }, certificate) {
    const reached = new Set(certificate.reached);
    /** @type {[string, string[]][]} */
    const needed = lines.filter((/** @type {[string, string[]]} */ [name]) => reached.has(name));
    insist(outputs.length > 0 && avoid.length > 0, "nothing is claimed");
    work.identities += needed.length;
    for (const [name, uses] of [["the output", outputs], ...needed])
      for (const use of uses) insist(reached.has(use), `${name} needs ${use}, which the certificate does not list`);
    for (const name of avoid) insist(!reached.has(name), `${name}, which was to be avoided, is reached`);
  }

  /** A residual in the format's own form, {"x^2 y": "-3/2"}. @param {Polynomial} polynomial */
  function written(polynomial) {
    /** @param {string} word */
    const shorter = (word) =>
      word.replace(
        /(?<!\S)(\S+)((?: \1)+)(?!\S)/g,
        (_, name, more) => `${name}^${1 + more.length / (name.length + 1)}`
      );
    return Object.fromEntries(Array.from(polynomial, ([word, value]) => [shorter(word), printed(value)]));
  }

  /** What is malformed proves nothing either. @param {any} statement @param {any} certificate @returns {Verdict} */
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
      const { message, residual } = /** @type {Error & { residual?: Polynomial }} */ (why);
      return { accepted: false, reason: message, residual: residual && written(residual), work };
    }
  }

  return { check };
}

/** Data from its text, which has to be its own canonical form: no key twice, no number that a double rounds. @param {string} text */
function parsed_canonical(text) {
  const data = JSON.parse(text);
  if (JSON.stringify(data) !== text) throw new Error("the text is not its own canonical form");
  return data;
}

// The reader's own h(u, v): a text read as `--field-expression` reads it, but for `x if c else y` and conditions that are
// joined; its slopes by the rules of differentiation, and both run over points of the chart.
"use strict";

/**
 * Read a formula of u and v; throw an Error whose `at` is where in the text it goes wrong. Equal parts are one node.
 * @param {string} text
 * @param {{ ku: number, kv: number }} wave_numbers
 */
function formula_of(text, { ku, kv }) {
  const DEEPEST = 40;
  const LARGEST_POWER = 64;
  const PART = /\s*(?:(\d+\.?\d*(?:e[+-]?\d+)?|\.\d+(?:e[+-]?\d+)?)|([a-z_]\w*)|(\*\*|[<>]=?|[-+*/%^(),])|(\S))/giy;
  /** @type {Map<string, FormulaNode>} */
  const nodes = new Map();

  /** @param {string} op @param {...(FormulaNode | number)} parts @returns {FormulaNode} */
  function node(op, ...parts) {
    const key = [op, ...parts.map((part) => (typeof part === "number" ? part : `#${part.id}`))].join(" ");
    const args = parts.filter((part) => typeof part !== "number");
    const [value = NaN] = parts.filter((part) => typeof part === "number");
    if (!nodes.has(key)) nodes.set(key, { id: nodes.size, op, args, value });
    return /** @type {FormulaNode} */ (nodes.get(key));
  }
  /** @param {number} value */
  const number = (value) => node("number", value);
  /** @param {FormulaNode} a @param {number} value */
  const is = (a, value) => a.op === "number" && a.value === value;
  const [ZERO, ONE, PI] = [number(0), number(1), node("pi")];

  /** @param {FormulaNode} a @param {FormulaNode} b */
  function sum(a, b) {
    if (is(a, 0)) return b;
    if (is(b, 0)) return a;
    return a.op === "number" && b.op === "number" ? number(a.value + b.value) : node("sum", a, b);
  }
  /** @param {FormulaNode} a @param {FormulaNode} b @returns {FormulaNode} */
  function product(a, b) {
    if (is(a, 0) || is(b, 0)) return ZERO;
    if (is(a, 1)) return b;
    if (is(b, 1)) return a;
    return a.op === "number" && b.op === "number" ? number(a.value * b.value) : node("product", a, b);
  }
  /** @param {FormulaNode} a @param {number} n */
  function power(a, n) {
    if (n === 0) return ONE;
    if (n === 1) return a;
    return a.op === "number" ? number(a.value ** n) : node("power", a, n);
  }
  /** @param {FormulaNode} a @param {FormulaNode} b */
  const difference = (a, b) => sum(a, product(number(-1), b));

  /** A node divided by π where π is a factor of every term; else null. @param {FormulaNode} a @returns {FormulaNode | null} */
  function over_pi(a) {
    if (a === PI) return ONE;
    if (is(a, 0)) return a;
    if (a.op !== "sum" && a.op !== "product") return null;
    const [first, second] = a.args;
    const parts = a.args.map(over_pi);
    if (a.op === "sum") return parts[0] && parts[1] && sum(parts[0], parts[1]);
    if (parts[0]) return product(parts[0], second);
    return parts[1] && product(first, parts[1]);
  }
  /** An angle in half-turns, term by term. @param {FormulaNode} a @returns {FormulaNode} */
  function half_turns(a) {
    if (a.op === "sum") return sum(half_turns(a.args[0]), half_turns(a.args[1]));
    return over_pi(a) ?? product(a, number(1 / Math.PI));
  }

  /** @param {string} op @returns {(a: FormulaNode) => FormulaNode} */
  const of_one = (op) => (a) => node(op, a);
  const [sinpi, cospi, exp, log, abs, sign, floor] = ["sinpi", "cospi", "exp", "log", "abs", "sign", "floor"].map(
    of_one
  );
  /** @param {FormulaNode} a @param {FormulaNode} b */
  const quotient = (a, b) => product(a, power(b, -1));
  /** @param {FormulaNode} a @param {FormulaNode} b */
  const mod = (a, b) => difference(a, product(b, floor(quotient(a, b))));
  /** @param {FormulaNode} a */
  const atan = (a) => product(PI, node("atan2pi", a));
  /** @param {FormulaNode} a */
  const ceiling = (a) => product(number(-1), floor(product(number(-1), a)));
  /** @param {FormulaNode} a @param {FormulaNode} b */
  const pow = (a, b) => (b.op === "number" ? power(a, b.value) : exp(product(b, log(a))));
  /** Their arguments are as many as are written here. @type {Record<string, (...args: FormulaNode[]) => FormulaNode>} */
  const CALLS = {
    ...{
      sinpi,
      cospi,
      exp,
      log,
      abs,
      Abs: abs,
      sign,
      floor,
      mod,
      Mod: mod,
      atan,
      arctan: atan,
      ceiling,
      ceil: ceiling,
      pow,
      Pow: pow
    },
    sin: (a) => sinpi(half_turns(a)),
    cos: (a) => cospi(half_turns(a)),
    tan: (a) => quotient(sinpi(half_turns(a)), cospi(half_turns(a))),
    tanh: (a) => difference(ONE, quotient(number(2), sum(exp(product(number(2), a)), ONE))),
    sqrt: (a) => power(a, 0.5),
    frac: (a) => mod(a, ONE),
    round: (a) => floor(sum(a, number(0.5))),
    Heaviside: (a) => product(number(0.5), sum(ONE, sign(a))),
    clip: (a, low, high) => node("max", low, node("min", high, a))
  };
  /** @type {Record<string, FormulaNode>} */
  const NAMES = {
    u: node("u"),
    v: node("v"),
    k_u: number(ku),
    k_v: number(kv),
    ku: number(ku),
    kv: number(kv),
    pi: PI,
    E: number(Math.E)
  };
  const known = [...Object.keys({ ...NAMES, ...CALLS }), "max, min, where, Piecewise"].join(", ");

  const parts = Array.from(text.matchAll(PART), (found) => {
    const [whole, digits, name, sign, other] = found;
    const word = whole.trim();
    return { word, digits, name, sign: sign ?? other, at: found.index + whole.length - word.length };
  });
  /** @type {Partial<typeof parts[number]> & { word: string, at: number }} */
  const END = { word: "the end", at: text.length };
  let next = 0;
  let depth = 0;
  const here = () => parts[next] ?? END;

  /** @param {string} why @param {{ word: string, at: number }} [part] */
  const refused = (why, { word, at } = here()) =>
    Object.assign(new Error(`h(u, v) is not read from ${word.slice(0, 20)} on: ${why}`), { at, length: word.length });

  /** @param {...string} signs */
  function taken(...signs) {
    const sign = here().sign;
    if (sign === undefined || !signs.includes(sign)) return "";
    next++;
    return sign;
  }
  /** @param {string} sign */
  function expect(sign) {
    if (!taken(sign)) throw refused(`here is a ${sign} missing`);
  }

  /** @returns {FormulaNode} */
  function read_sum() {
    if (++depth > DEEPEST) throw refused(`at most ${DEEPEST} brackets lie in each other`);
    let a = read_product();
    for (let sign = taken("+", "-"); sign; sign = taken("+", "-")) {
      const b = read_product();
      a = sign === "+" ? sum(a, b) : difference(a, b);
    }
    depth--;
    return a;
  }
  function read_product() {
    let a = read_signed();
    for (let sign = taken("*", "/", "%"); sign; sign = taken("*", "/", "%"))
      a = (sign === "*" ? product : sign === "/" ? quotient : mod)(a, read_signed());
    return a;
  }
  /** @returns {FormulaNode} */
  function read_signed() {
    if (taken("-")) return product(number(-1), read_signed());
    return taken("+") ? read_signed() : read_power();
  }
  function read_power() {
    const base = read_one();
    const at = here();
    if (!taken("**", "^")) return base;
    const exponent = read_signed();
    if (exponent.op === "number" && !(Math.abs(exponent.value) <= LARGEST_POWER))
      throw refused(`a power is at most ${LARGEST_POWER}`, at);
    return pow(base, exponent);
  }
  /** @returns {FormulaNode[]} */
  function read_arguments() {
    const list = [read_sum()];
    while (taken(",")) list.push(read_sum());
    expect(")");
    return list;
  }
  /** @returns {FormulaNode} */
  function read_one() {
    const part = here();
    if (part.digits !== undefined) {
      next++;
      return number(Number(part.digits));
    }
    if (taken("(")) {
      const a = read_sum();
      expect(")");
      return a;
    }
    if (part.name === undefined) throw refused(`here is a number, a name or a bracket missing`);
    next++;
    const is_called = taken("(") !== "";
    if (!is_called && Object.hasOwn(NAMES, part.name)) return NAMES[part.name];
    if (is_called && part.name === "Piecewise") return read_pieces();
    if (is_called && part.name === "where") return read_where();
    const list = is_called ? read_arguments() : [];
    if (Object.hasOwn(CALLS, part.name) && list.length === CALLS[part.name].length) return CALLS[part.name](...list);
    const lower = part.name.toLowerCase();
    if (["max", "min"].includes(lower) && list.length > 1) return list.reduce((a, b) => node(lower, a, b));
    throw refused(`known are ${known}`, part);
  }
  /** Read a comparison; return what is chosen by it of two. @returns {(a: FormulaNode, b: FormulaNode) => FormulaNode} */
  function read_condition() {
    const left = read_sum();
    const relation = taken("<", "<=", ">", ">=");
    if (!relation) throw refused("a condition is one of <, <=, >, >=");
    const right = read_sum();
    const gap = relation[0] === "<" ? difference(left, right) : difference(right, left); // below 0 where it holds
    return (a, b) => node("choice", gap, a, b, relation.length - 1);
  }
  // Both after their bracket: where(x < y, a, b), and Piecewise((a, x < y), (b, x >= z), (c, True)).
  function read_where() {
    const choose = read_condition();
    expect(",");
    const list = read_arguments();
    if (list.length !== 2) throw refused("where takes a condition and two values");
    return choose(list[0], list[1]);
  }
  /** @returns {FormulaNode} */
  function read_pieces() {
    expect("(");
    const a = read_sum();
    expect(",");
    if (here().name === "True") {
      next++;
      expect(")");
      expect(")");
      return a;
    }
    const choose = read_condition();
    expect(")");
    expect(",");
    return choose(a, read_pieces());
  }

  /** @type {Map<string, FormulaNode>} */
  const slopes = new Map();
  /** The derivative by u or v; at a crease the mean of both sides. @param {FormulaNode} of @param {string} by @returns {FormulaNode} */
  function slope(of, by) {
    const key = `${of.id} ${by}`;
    const slope_now = slopes.get(key) ?? slope_of(of, by);
    slopes.set(key, slope_now);
    return slope_now;
  }
  /** @param {FormulaNode} of @param {string} by @returns {FormulaNode} */
  function slope_of(of, by) {
    const { op, args, value } = of;
    const [a, b] = args;
    const [a_by, b_by, c_by] = args.map((part) => slope(part, by));
    if (op === by) return ONE;
    if (op === "sum") return sum(a_by, b_by);
    if (op === "product") return sum(product(a_by, b), product(a, b_by));
    if (op === "power") return product(product(number(value), power(a, value - 1)), a_by);
    if (op === "sinpi") return product(product(PI, node("cospi", a)), a_by);
    if (op === "cospi") return product(product(PI, product(number(-1), node("sinpi", a))), a_by);
    if (op === "exp") return product(of, a_by);
    if (op === "log") return quotient(a_by, a);
    if (op === "atan2pi") return quotient(a_by, product(PI, sum(ONE, power(a, 2))));
    if (op === "abs") return product(node("sign", a), a_by);
    if (op === "choice") return node("choice", a, b_by, c_by, value);
    if (op !== "max" && op !== "min") return ZERO;
    const steep = product(node("sign", difference(a, b)), difference(a_by, b_by));
    return product(number(0.5), sum(sum(a_by, b_by), op === "max" ? steep : product(number(-1), steep)));
  }

  const height = read_sum();
  if (here() !== END) throw refused("here the formula could end");
  /** @type {FormulaNode[]} */
  const switches = []; // where one of these is 0 there may be a crease
  for (const { op, args } of [...nodes.values()]) {
    if (["abs", "sign", "choice"].includes(op)) switches.push(args[0]);
    if (op === "floor") switches.push(sinpi(args[0]));
    if (op === "max" || op === "min") switches.push(difference(args[0], args[1]));
  }
  return { height, gradient: [slope(height, "u"), slope(height, "v")], switches };
}

/**
 * A field made of a text, at its wave numbers, or an Error where it is not finite. What it computes has no proved bound.
 * @param {{ h?: string, ku: number, kv: number }} state
 * @param {KernelOver} kernel_over
 */
function own_field({ h = "", ku, kv }, kernel_over) {
  const CHUNK = 512;
  const GRID = 65;
  const SEAM = 1e-9;
  const { abs, sign, max, min, floor } = Math;
  /** @type {Record<string, (a: number, b: number) => number>} */
  const CHOICES = { abs, sign, max, min, floor };
  const { height, gradient, switches } = formula_of(h, { ku, kv });

  /** @param {FormulaNode[]} wanted all that they need, each after its parts */
  function in_order(wanted) {
    /** @type {Map<number, FormulaNode>} */
    const needed = new Map();
    /** @param {FormulaNode} of */
    function visit(of) {
      if (needed.has(of.id)) return;
      needed.set(of.id, of);
      of.args.forEach(visit);
    }
    wanted.forEach(visit);
    return [...needed.values()].sort((a, b) => a.id - b.id);
  }

  /** Compute a node of so many points into its own array. @param {FormulaNode} of @param {number} count @param {Record<string, Float64Array>} at */
  function compute(of, count, at) {
    const { op, args, value } = of;
    if (op in at) {
      of.out = at[op];
      return;
    }
    const [a, b, c] = args.map((part) => /** @type {Float64Array} */ (part.out));
    if (["sinpi", "cospi", "exp", "log", "atan2pi"].includes(op)) {
      [of.out] = kernel_over(op, a.subarray(0, count), Number(op === "atan2pi"));
      return;
    }
    of.out ??= new Float64Array(CHUNK);
    const { out } = of;
    if (op === "number") out.fill(value);
    else if (op === "pi") out.fill(Math.PI);
    else if (op === "sum") for (let i = 0; i < count; i++) out[i] = a[i] + b[i];
    else if (op === "product") for (let i = 0; i < count; i++) out[i] = a[i] * b[i];
    else if (op in CHOICES) for (let i = 0; i < count; i++) out[i] = CHOICES[op](a[i], b?.[i]);
    else if (op === "choice") for (let i = 0; i < count; i++) out[i] = a[i] < 0 || (value && a[i] === 0) ? b[i] : c[i];
    else if (value === 2) for (let i = 0; i < count; i++) out[i] = a[i] * a[i];
    else if (value === -1) for (let i = 0; i < count; i++) out[i] = 1 / a[i];
    else if (Math.abs(value) === 0.5) for (let i = 0; i < count; i++) out[i] = Math.sqrt(value < 0 ? 1 / a[i] : a[i]);
    else for (let i = 0; i < count; i++) out[i] = a[i] ** value;
  }

  /** Return a function of points, u and v, that computes nodes there. @param {FormulaNode[]} wanted */
  function over(wanted) {
    const order = in_order(wanted);
    /** @param {Float64Array} u @param {Float64Array} v */
    return (u, v) => {
      const made = wanted.map(() => new Float64Array(u.length));
      for (let start = 0; start < u.length; start += CHUNK) {
        const count = Math.min(CHUNK, u.length - start);
        const at = { u: u.subarray(start, start + count), v: v.subarray(start, start + count) };
        for (const of of order) compute(of, count, at);
        for (const [n, { out }] of wanted.entries())
          made[n].set(/** @type {Float64Array} */ (out).subarray(0, count), start);
      }
      return made;
    };
  }

  const own = { height: over([height]), gradient: over(gradient), switches: over(switches), has_seam: false };
  const shares = Array.from({ length: GRID }, (_, n) => n / (GRID - 1));
  const u = Float64Array.from(shares.flatMap((share) => shares.map(() => share)));
  const v = Float64Array.from(shares.flatMap(() => shares));
  const [here] = own.height(u, v);
  for (const plane of [here, ...own.gradient(u, v)]) {
    const bad = plane.findIndex((number) => !Number.isFinite(number));
    if (bad >= 0) throw new Error(`h(u, v) or a slope of it is not finite at u = ${u[bad]}, v = ${v[bad]}`);
  }
  own.has_seam = shares.some((_, n) => Math.abs(here[n] - here[here.length - GRID + n]) > SEAM);
  return own;
}

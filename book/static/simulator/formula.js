// The reader's own h(u, v): a text read as `--field-expression` reads it (proofs/printers/text.py); its slopes by the rules of
// differentiation, and both run over points of the chart.
"use strict";

/**
 * Read a formula of u and v; throw an Error whose `at` is where in the text it goes wrong. Equal parts are one node.
 * @param {string} text
 * @param {{ ku: number, kv: number }} wave_numbers
 */
function formula_of(text, { ku, kv }) {
  const LONGEST = 2000;
  const DEEPEST = 40;
  const MOST_CHOICES = 40;
  const LARGEST_POWER = 64;
  const MOST_BITS = 256; // of a number
  const [MOST_OPERATIONS, OF_A_FUNCTION] = [1000, 10];
  const FUNCTIONS = ["sinpi", "cospi", "exp", "log", "abs", "sign", "floor", "atan2pi"]; // of one number
  const HINT = "write 2*u for 2u, 4*sin(u) for 4 sin(u), abs(u) for |u|, sin(u)**2, where(u < v, 1, 2)";
  const PART = /\s*(?:(\d+\.?\d*(?:e[+-]?\d+)?|\.\d+(?:e[+-]?\d+)?)|([a-z_]\w*)|(\*\*|[<>]=?|[-+*/%^(),&|])|(\S))/giy;
  const CHOICES = ["abs", "sign", "max", "min", "piecewise", "where"]; // in small letters
  /** @type {Map<string, FormulaNode>} */
  const nodes = new Map();
  /** @type {FormulaPart | undefined} */
  let made_at; // the part of the text by which nodes are made

  /** @param {string} op @param {...(FormulaNode | number)} parts @returns {FormulaNode} */
  function node(op, ...parts) {
    const key = [op, ...parts.map((part) => (typeof part === "number" ? part : `#${part.id}`))].join(" ");
    const args = parts.filter((part) => typeof part !== "number");
    const [value = NaN] = parts.filter((part) => typeof part === "number");
    const in_parts = args.reduce((sum, part) => sum + part.operations, 0);
    const operations =
      value % 1 === 0 && op === "power" // which is printed as a product
        ? Math.abs(value) * (1 + in_parts)
        : in_parts + (FUNCTIONS.includes(op) ? OF_A_FUNCTION : 1);
    if (!nodes.has(key)) nodes.set(key, { id: nodes.size, op, args, value, operations, part: made_at });
    return /** @type {FormulaNode} */ (nodes.get(key));
  }
  /** @param {number} value */
  function number(value) {
    if (value !== 0 && !(Math.abs(Math.log2(Math.abs(value))) <= MOST_BITS))
      throw refused("a number is from 2**-256 to 2**256", made_at);
    return node("number", value);
  }
  /** @param {FormulaNode} a @param {number} value */
  const is = (a, value) => a.op === "number" && a.value === value;
  const [ZERO, ONE, PI] = [number(0), number(1), node("pi", Math.PI)];

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
    const [[a_base, a_power], [b_base, b_power]] = [a, b].map(as_power);
    if (a_base === b_base) return power(a_base, a_power + b_power);
    return a.op === "number" && b.op === "number" ? number(a.value * b.value) : node("product", a, b);
  }
  /** @param {FormulaNode} a @returns {[FormulaNode, number]} */
  const as_power = (a) => (a.op === "power" ? [a.args[0], a.value] : [a, 1]);
  /** @param {FormulaNode} a @param {number} n @returns {FormulaNode} */
  function power(a, n) {
    if (n === 0) return ONE;
    if (n === 1) return a;
    if (!(Math.abs(n) <= LARGEST_POWER)) throw refused(`a power is at most ${LARGEST_POWER}`, made_at);
    if (a.op === "power" && n % 1 === 0) return power(a.args[0], a.value * n);
    if (a.op === "power" && a.value === 2 && n === 0.5) return abs(a.args[0]);
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
  const [sinpi, cospi, exp, log, abs, sign, floor, atan2pi] = FUNCTIONS.map(of_one);
  /** @type {Set<FormulaNode>} */
  const conditions = new Set(); // nodes that are 1 where something holds, else 0
  /** @param {FormulaNode} a */
  function condition(a) {
    conditions.add(a);
    return a;
  }
  /** Whether a node is below 0, or at 0. @param {FormulaNode} a @param {number} or_at_0 */
  const below = (a, or_at_0) => condition(node("below", a, or_at_0));
  /** @param {FormulaNode} a @param {FormulaNode} b */
  const and = (a, b) => condition(node("product", a, b));
  /** @param {FormulaNode} a @param {FormulaNode} b */
  const or = (a, b) => condition(node("sum", a, node("sum", b, product(number(-1), node("product", a, b)))));
  /** @param {FormulaNode} a @param {FormulaNode} b */
  const quotient = (a, b) => product(a, power(b, -1));
  /** @param {FormulaNode} a @param {FormulaNode} b */
  const mod = (a, b) => difference(a, product(b, floor(quotient(a, b))));
  /** @param {FormulaNode} a @param {FormulaNode} b */
  const pow = (a, b) => (b.op === "number" ? power(a, b.value) : exp(product(b, log(a))));
  /** Their arguments are as many as are written here. @type {Record<string, (...args: FormulaNode[]) => FormulaNode>} */
  const CALLS = {
    ...{ sinpi, cospi, exp, log, abs, sign, floor, pow },
    where: (test, a, b) => node("choice", test, a, b),
    sin: (a) => sinpi(half_turns(a)),
    cos: (a) => cospi(half_turns(a)),
    sqrt: (a) => power(a, 0.5),
    atan: (a) => product(PI, atan2pi(a))
  };
  /** The same by those, of x, y and z; with how many these are. @type {Record<string, string>} */
  const BY_TEXT = {
    "Abs 1": "abs(x)",
    "ln 1": "log(x)",
    "arctan 1": "atan(x)",
    "tan 1": "sin(x)/cos(x)",
    "tanh 1": "1 - 2/(exp(2*x) + 1)",
    "sinh 1": "(exp(x) - exp(-x))/2",
    "cosh 1": "(exp(x) + exp(-x))/2",
    "frac 1": "x % 1",
    "fract 1": "x % 1",
    "ceil 1": "-floor(-x)",
    "ceiling 1": "-floor(-x)",
    "round 1": "floor(x + 1/2)",
    "Heaviside 1": "(1 + sign(x))/2",
    "Heaviside 2": "(1 + sign(x))/2",
    "step 2": "(1 + sign(y - x))/2",
    "mod 2": "x % y",
    "Mod 2": "x % y",
    "Pow 2": "pow(x, y)",
    "log 2": "log(x)/log(y)",
    "atan2pi 2": "atan(x*exp(-log(y)))/pi",
    "clip 3": "max(y, min(z, x))",
    "clamp 3": "max(y, min(z, x))",
    "mix 3": "x + (y - x)*z",
    "smoothstep 3": "clip((z - x)/(y - x), 0, 1)**2*(3 - 2*clip((z - x)/(y - x), 0, 1))"
  };
  /** @type {Record<string, FormulaNode>} */
  const NAMES = {
    u: node("u", 1), // which argument it is
    v: node("v", 2),
    k_u: number(ku),
    k_v: number(kv),
    ku: number(ku),
    kv: number(kv),
    pi: PI,
    E: number(Math.E),
    True: below(number(-1), 0)
  };
  const by_text = Object.keys(BY_TEXT).map((key) => key.split(" ")[0]);
  const known = [...new Set([...Object.keys({ ...NAMES, ...CALLS }), ...by_text, "max", "min", "Piecewise"])];

  /** @param {string} text */
  const parts_of = (text) =>
    Array.from(text.matchAll(PART), (found) => {
      const [whole, digits, name, sign, other] = found;
      const word = whole.trim();
      return { word, digits, name, sign: sign ?? other, at: found.index + whole.length - word.length };
    });
  let parts = parts_of(text);
  /** @type {FormulaNode[]} */
  let xyz = [];
  /** @type {FormulaPart} */
  const END = { word: "the end", at: text.length };
  let next = 0;
  let depth = 0;
  let choices = 0;
  let inside = 0; // of how many choices
  const here = () => parts[next] ?? END;

  /** @param {string} why @param {FormulaPart} [part] */
  function refused(why, part = here()) {
    const { word, at } = part.whole ?? part;
    return Object.assign(new Error(`h(u, v) is not read from ${word.slice(0, 20)} on: ${why}`), {
      at,
      length: word.length,
      text
    });
  }

  /** @param {FormulaPart} part */
  const unknown = (part) => refused(`known are ${known.join(", ")}; ${HINT}`, part);

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

  /** Return a node if it is a condition where one belongs, else a value. @param {FormulaNode} a @returns {FormulaNode} */
  function of_kind(a, is_condition = false, part = here()) {
    if (conditions.has(a) === is_condition) return a;
    throw refused("of a condition write the values, as in where(u < v, 1, 2)", part);
  }
  /** What each sign makes of two nodes, those that bind least first. @type {Record<string, (a: FormulaNode, b: FormulaNode) => FormulaNode>[]} */
  const LEVELS = [
    { or },
    { and },
    {
      "<": (a, b) => below(difference(a, b), 0),
      "<=": (a, b) => below(difference(a, b), 1),
      ">": (a, b) => below(difference(b, a), 0),
      ">=": (a, b) => below(difference(b, a), 1)
    },
    { "|": or },
    { "&": and },
    { "+": sum, "-": difference },
    { "*": product, "/": quotient, "%": mod }
  ];
  /** @returns {FormulaNode} */
  function read_level(level = 0) {
    if (level === LEVELS.length) return read_signed();
    let a = read_level(level + 1);
    for (let part = here(); Object.hasOwn(LEVELS[level], part.word); part = here()) {
      next++;
      const join = LEVELS[level][part.word];
      const is_condition = [and, or].includes(join);
      of_kind(a, is_condition, part);
      const b = of_kind(read_level(level + 1), is_condition, part);
      made_at = part;
      a = join(a, b);
    }
    return a;
  }
  /** Read a value, a condition, or either. @param {boolean | null} is_condition @returns {FormulaNode} */
  function read(is_condition = false) {
    const begin = here();
    const a = read_level();
    if (here().word !== "if") return is_condition === null ? a : of_kind(a, is_condition, begin);
    next++;
    inside++;
    const condition = read(true);
    if (here().word !== "else") throw refused("write a if u < v else b");
    next++;
    const other = read();
    inside--;
    chosen(2);
    return node("choice", condition, of_kind(a, false, begin), other);
  }
  /** @returns {FormulaNode} */
  function read_signed() {
    if (++depth > DEEPEST) throw refused("too many brackets lie in each other");
    const sign = taken("-", "+");
    const a = sign ? of_kind(read_signed()) : read_power();
    depth--;
    return sign === "-" ? product(number(-1), a) : a;
  }
  function read_power() {
    const base = read_one();
    const part = here();
    if (!taken("**", "^")) return base;
    const exponent = of_kind(read_signed());
    made_at = part;
    return pow(of_kind(base, false, part), exponent);
  }
  /** @returns {FormulaNode[]} */
  function read_arguments(list = [read()]) {
    while (taken(",") && here().word !== ")") list.push(read());
    expect(")");
    return list;
  }
  /** Count a choice of so many parts, as text.py does. @param {number} parts */
  function chosen(parts) {
    choices += Math.max(1, parts * (parts - 1)) * 2 ** inside;
    if (choices > MOST_CHOICES) throw refused("there are too many choices, some inside others");
  }
  /** @returns {FormulaNode} */
  function read_one() {
    const part = here();
    if (part.digits !== undefined) {
      next++;
      made_at = part;
      return number(Number(part.digits));
    }
    if (taken("(")) {
      const a = read(null);
      expect(")");
      return a;
    }
    if (part.name === undefined) throw refused(`here is a number, a name or a bracket missing: ${HINT}`);
    next++;
    if (!taken("(")) {
      const value = Object.hasOwn(NAMES, part.name) ? NAMES[part.name] : xyz["xyz".indexOf(part.name)];
      if (value) return value;
      throw unknown(part);
    }
    const lower = part.name.toLowerCase();
    const is_choice = CHOICES.includes(lower);
    inside += Number(is_choice);
    const list = part.name === "Piecewise" ? read_pieces() : read_arguments([read(part.name === "where")]);
    inside -= Number(is_choice);
    if (is_choice && !xyz.length) chosen(part.name === "where" ? 2 : list.length);
    made_at = part;
    if (part.name === "Piecewise") return list.reduceRight((other, piece) => node("choice", ...piece.args, other));
    if (["max", "Max", "min", "Min"].includes(part.name)) return list.reduce((a, b) => node(lower, a, b));
    const { length } = list;
    const text = BY_TEXT[`${part.name} ${length}`];
    if (text) return read_other(text, list, part);
    if (!known.includes(part.name)) throw unknown(part);
    if (CALLS[part.name]?.length !== length) throw refused(`it takes no ${length} values`, part);
    return CALLS[part.name](...list);
  }
  /** What a text makes of x, y and z; its parts stand for one of the reader's. @param {string} text @param {FormulaNode[]} list @param {FormulaPart} whole */
  function read_other(text, list, whole) {
    const kept = { parts, next, xyz };
    parts = parts_of(text).map((part) => ({ ...part, whole: whole.whole ?? whole }));
    next = 0;
    xyz = list;
    const made = read();
    ({ parts, next, xyz } = kept);
    return made;
  }
  /** Each value with its condition, as a node, and the last value. @returns {FormulaNode[]} */
  function read_pieces() {
    expect("(");
    const value = read();
    expect(",");
    const test = read(true);
    expect(")");
    if (test === NAMES.True) {
      expect(")");
      return [value];
    }
    if (!taken(",")) throw refused("the last piece is for all else: (1, True)");
    return [node("piece", test, value), ...read_pieces()];
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
    made_at = of.part;
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
    if (op === "choice") return node("choice", a, b_by, c_by);
    if (op !== "max" && op !== "min") return ZERO;
    const steep = product(node("sign", difference(a, b)), difference(a_by, b_by));
    return product(number(0.5), sum(sum(a_by, b_by), op === "max" ? steep : product(number(-1), steep)));
  }

  /** All nodes that these need, each after its parts. @param {FormulaNode[]} wanted @param {Set<FormulaNode>} needed so far */
  function nodes_of(wanted, needed = new Set()) {
    for (const each of wanted) {
      if (!needed.has(each)) nodes_of(each.args, needed);
      needed.add(each);
    }
    return [...needed];
  }

  if (text.length > LONGEST) throw refused(`at most ${LONGEST} letters`, END);
  const height = read();
  if (here() !== END) throw refused(`here the formula could end: ${HINT}`);
  if (2 * height.operations > MOST_OPERATIONS) throw refused("there are too many operations, slopes included");
  /** @type {FormulaNode[]} */
  const switches = []; // where one of these is 0 there may be a crease
  for (const { op, args } of nodes_of([height])) {
    if (["abs", "sign", "below"].includes(op)) switches.push(args[0]);
    if (op === "floor") switches.push(sinpi(args[0]));
    if (op === "max" || op === "min") switches.push(difference(args[0], args[1]));
  }
  const wanted = [[height], [slope(height, "u"), slope(height, "v")], switches];
  return { wanted, count: nodes.size, nodes_of, refused };
}

/**
 * A field made of a text, at its wave numbers, or an Error where it is not finite: compiled for this page, on the module's
 * memory and with its functions. What it computes has no proved bound.
 * @param {{ h?: string, ku: number, kv: number }} state
 * @param {Emitted} emitted
 * @param {WebAssembly.Imports} imports
 * @param {OverPoints} over_points
 */
function own_field({ h = "", ku, kv }, { head, codes, functions }, imports, over_points) {
  const GRID = 65;
  const SEAM = 1e-9;
  const LARGEST = 2 ** 1000;
  const ADVICE = "keep what it divides by off 0, and what it takes a root or log of above, as in sqrt(x**2 + 1e-4)";
  /** What an operation makes of numbers, the second its own where it has one part. @type {any} */
  const AT = {
    __proto__: Math,
    sum: (/** @type {number} */ a, /** @type {number} */ b) => a + b,
    product: (/** @type {number} */ a, /** @type {number} */ b) => a * b,
    power: Math.pow,
    atan2pi: (/** @type {number} */ a) => Math.atan(a) / Math.PI,
    sinpi: (/** @type {number} */ a) => Math.sin(Math.PI * a),
    cospi: (/** @type {number} */ a) => Math.cos(Math.PI * a)
  };
  const { wanted, count, nodes_of, refused } = formula_of(h, { ku, kv });

  /** @type {Map<FormulaNode, number[]>} */
  const ranges = new Map(); // between what numbers a node lies on the chart
  /** @param {FormulaNode} of */
  function ends_of({ op, args, value }) {
    const [a, b] = args.map((part) => /** @type {number[]} */ (ranges.get(part))).slice(op === "choice" ? 1 : 0);
    if (op === "number" || op === "pi") return [value, value];
    if (op === "u" || op === "v" || op === "below") return [0, 1];
    if (op === "sign") return [-1, 1];
    const [low, high] = a;
    const ends = op === "choice" ? [...a, ...b] : a.flatMap((x) => (b ?? [value]).map((y) => AT[op](x, y)));
    if ((op === "abs" || op === "power") && low < 0 && high > 0) ends.push(AT[op](0, value));
    for (const [sign, at] of Object.entries({ sinpi: [0.5, -0.5], cospi: [0, 1] }[op] ?? []))
      if (at + 2 * Math.ceil((low - at) / 2) <= high) ends.push(sign === "0" ? 1 : -1);
    return [Math.min(...ends), Math.max(...ends)]; // NaN if one of them is
  }
  for (const each of nodes_of(wanted.flat())) {
    const ends = ends_of(each);
    if (!ends.every((end) => Math.abs(end) < LARGEST))
      throw refused(`it, or a slope, is not shown to be finite and real on the chart: ${ADVICE}`, each.part);
    ranges.set(each, ends);
  }

  // WebAssembly's codes: 0x20 gets a local variable, 0x21 sets it, 0x22 does both; 0x28 loads an int32, 0x41 and 0x44 are
  // constants; 0x6a adds, 0x6c multiplies, 0x49 compares; 0x03 begins a loop, 0x0d goes back to it, 0x0b ends it.
  /** A number in WebAssembly's spelling, LEB128. @param {number} number @returns {number[]} */
  const leb = (number) => (number < 128 ? [number] : [(number & 127) | 128, ...leb(number >> 7)]);
  /** @param {number[]} bytes */
  const sized = (bytes) => [...leb(bytes.length), ...bytes];
  /** @param {number} value */
  const constant = (value) => [0x44, ...new Uint8Array(Float64Array.of(value).buffer), ...codes.everywhere];
  /** Where the points' numbers are in the array of this argument. @param {number} argument */
  const address = (argument) => [0x20, 0, 0x28, 2, ...leb(8 * argument), 0x20, 1, 0x6a];
  /** A node's local variable, after the function's argument and how far the points are. @param {FormulaNode} of */
  const place = ({ id }) => leb(2 + id);
  /** @param {FormulaNode} of */
  const local = (of) => [0x20, ...place(of)];

  /** What computes a node of its parts. @param {FormulaNode} of */
  function code_of({ op, args, value }) {
    const parts = args.flatMap(local);
    if (op === "number" || op === "pi") return constant(value);
    if (op === "u" || op === "v") return [...address(value), ...codes.load];
    if (op === "below" && value) return [...parts, ...codes.at_most];
    if (op !== "power") return [...parts, ...codes[op]];
    const size = Math.abs(value);
    const code = [...parts];
    if (size === 0.5) code.push(...codes.root);
    else if (size % 1) code.push(...codes.log, ...constant(size), ...codes.product, ...codes.exp);
    else for (let n = 1; n < size; n++) code.push(...parts, ...codes.product);
    return value < 0 ? [...constant(1), ...code, ...codes.quotient] : code;
  }

  /** A function over points, two at a time: of the address of int64 numbers, how many points, then addresses of u, of v, and for each node. @param {FormulaNode[]} wanted */
  const body_of = (wanted) =>
    sized([
      ...[2, 1, 0x7f, ...leb(count), 0x7b, 0x03, 0x40],
      ...nodes_of(wanted).flatMap((each) => [...code_of(each), 0x21, ...place(each)]),
      ...wanted.flatMap((each, n) => [...address(3 + n), ...local(each), ...codes.store]),
      ...[0x20, 1, 0x41, 16, 0x6a, 0x22, 1, 0x20, 0, 0x28, 2, 0, 0x41, 8, 0x6c, 0x49, 0x0d, 0, 0x0b, 0x0b]
    ]);
  const program = [
    ...head,
    ...[3, 4, 3, 0, 0, 0], // three functions
    ...[7, 13, 3, ...wanted.flatMap((_, n) => [1, 0x30 + n, 0, functions + n])], // exported by their numbers
    ...[10, ...sized([3, ...wanted.flatMap(body_of)])]
  ];
  const { exports } = new WebAssembly.Instance(new WebAssembly.Module(Uint8Array.from(program)), imports);
  const [height, gradient, switches] = wanted.map(
    ({ length }, n) =>
      (/** @type {Float64Array} */ u, /** @type {Float64Array} */ v) =>
        over_points(/** @type {any} */ (exports[n]), [2, length], u, v)
  );
  const u = float64s(2 * GRID, (n) => Number(n >= GRID));
  const v = float64s(2 * GRID, (n) => (n % GRID) / (GRID - 1));
  const [here] = height(u, v);
  const has_seam = here.subarray(GRID).some((there, n) => Math.abs(there - here[n]) > SEAM);
  return { height, gradient, switches, has_seam };
}

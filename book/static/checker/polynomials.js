// Polynomials as the reader sees and types them. `names` says how a name is spelled: [[text, kind], …] with the kinds
// i (italic), r (upright) and s (subscript).
"use strict";
var Checker = Checker || {};

// An element: make("p", { class: "x" }, child, "text", …).
Checker.make = function (tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) if (value !== undefined) element.setAttribute(name, value);
  element.append(...children);
  return element;
};

Checker.polynomials = function (names) {
  const make = Checker.make, MOST = 40; // terms that are typeset
  const TAGS = { i: "var", r: "span", s: "sub" }, RELATIONS = { "=": "=", "!=": "≠", ">": ">", ">=": "≥" };

  const factors = (monomial) => monomial.split(" ").filter(Boolean).map((text) => text.split("^"));
  const degree = (monomial) => factors(monomial).reduce((sum, [, power = 1]) => sum + Number(power), 0);
  const sorted = (data) => Object.entries(data).sort(([a], [b]) => degree(b) - degree(a) || (a < b ? -1 : 1));
  const signed = (coefficient) => [coefficient.startsWith("-") ? "−" : "+", coefficient.replace("-", "")];

  function spelled(name) {
    return (names[name] ?? [[name, "r"]]).map(([text, kind]) => make(TAGS[kind], {}, text));
  }

  function monomial_nodes(monomial) {
    return factors(monomial).flatMap(([name, power], n) => {
      const spelling = spelled(name), space = n ? ["\u2009"] : [];
      if (power === undefined) return [...space, ...spelling];
      const bracketed = spelling.length > 1 && (names[name] ?? []).some(([, kind]) => kind === "r");
      return [...space, ...(bracketed ? ["(", ...spelling, ")"] : spelling), make("sup", {}, power)];
    });
  }

  // A term with its sign; the first one's plus is left out.
  function term(monomial, coefficient, first) {
    const [sign, size] = signed(coefficient), number = size === "1" && monomial ? "" : size;
    const front = first ? (sign === "−" ? "−" : "") : `${sign} `;
    return make("span", { class: "check-term" }, front + number + (number && monomial ? "\u2009" : ""), ...monomial_nodes(monomial));
  }

  // The polynomial as mathematics; of a very long one the beginning.
  function typeset(data) {
    const terms = sorted(data), shown = terms.slice(0, MOST), rest = terms.length - shown.length;
    const parts = shown.flatMap(([monomial, coefficient], n) => [n ? " " : "", term(monomial, coefficient, n === 0)]);
    const more = rest ? [` and ${rest} more term${rest > 1 ? "s" : ""}`] : [];
    return make("span", { class: "check-polynomial" }, ...(parts.length ? parts : ["0"]), ...more);
  }

  const related = (data, relation) => make("span", {}, typeset(data), ` ${RELATIONS[relation]} 0`);

  // The polynomial as it can be typed.
  function text(data) {
    const parts = sorted(data).map(([monomial, coefficient], n) => {
      const [sign, size] = signed(coefficient), number = size === "1" && monomial ? "" : size;
      const front = n ? `${sign === "−" ? "-" : "+"} ` : sign === "−" ? "-" : "";
      return front + [number, monomial].filter(Boolean).join(" ");
    });
    return parts.join(" ") || "0";
  }

  // Fractions as text, added exactly, in lowest terms.
  function sum(a, b) {
    const [[p, q], [r, s]] = [a, b].map((x) => x.split("/").map(BigInt)).map(([top, bottom = 1n]) => [top, bottom]);
    const divisor = (m, n) => (n ? divisor(n, m % n) : m < 0n ? -m : m), common = divisor(p * s + r * q, q * s);
    const [top, bottom] = [(p * s + r * q) / common, (q * s) / common];
    return bottom === 1n ? `${top}` : `${top}/${bottom}`;
  }

  // What was typed, as data. Throws an Error in the reader's terms; `known`: the names that may be used.
  function parse(typed, known) {
    const token = /\s*(?:([-+−])|(\d+)(?:\s*\/\s*(\d+))?(?![\w(])|([A-Za-z]\w*(?:\([^()]*\))?)(?:\s*\^\s*(\d+))?)(?:\s*[*·])?/y;
    const data = {};
    let sign = "", size = null, powers = new Map(), begun = false;
    function finish() {
      if (!begun) throw new Error("a term is missing");
      const monomial = [...powers].sort().map(([name, power]) => (power > 1 ? `${name}^${power}` : name)).join(" ");
      data[monomial] = sum(data[monomial] ?? "0", sign + (size ?? "1"));
      if (/^-?0(\/|$)/.test(data[monomial])) delete data[monomial];
      [sign, size, powers, begun] = ["", null, new Map(), false];
    }
    const end = typed.trimEnd().length;
    for (let at = 0; at < end; at = token.lastIndex) {
      token.lastIndex = at;
      const [whole, operator, top, bottom, name, power = "1"] = token.exec(typed) ?? [];
      if (whole === undefined) throw new Error(`“${typed.slice(at).trim().split(/\s/)[0]}” cannot be read`);
      if (operator) {
        if (at > 0) finish();
        sign = operator === "+" ? "" : "-";
      } else if (top) {
        if (size !== null || powers.size) throw new Error(`${top} stands where a name or a sign should`);
        if (bottom && !Number(bottom)) throw new Error("a division by zero");
        [size, begun] = [bottom ? `${top}/${bottom}` : top, true];
      } else {
        if (!known.has(name)) throw new Error(`nothing is called ${name} here`);
        if (!(Number(power) >= 1 && Number(power) <= 20)) throw new Error("an exponent is a whole number from 1 to 20");
        powers.set(name, (powers.get(name) ?? 0) + Number(power));
        begun = true;
      }
    }
    finish();
    return data;
  }

  return { typeset, related, term, sorted, spelled, text, parse };
};

// Polynomials as the reader sees and types them. `names` has the MathML of a name.
"use strict";

/** @param {Record<string, string>} names */
function polynomial_texts(names) {
  const MOST = 40; // terms that are typeset
  /** @type {Record<string, string>} */
  const RELATIONS = { "!=": "≠", ">=": "≥" };

  /** @param {string} relation */
  const zero = (relation) => ` ${RELATIONS[relation] ?? relation} 0`;
  const { powers, reduced, plus, printed } = certificate_kernel();
  /** @param {string} monomial */
  const degree = (monomial) => total(powers(monomial), ([, power]) => Number(power));
  /** @param {PolynomialData} data */
  const sorted = (data) => Object.entries(data).sort(([a], [b]) => degree(b) - degree(a) || (a < b ? -1 : 1));

  /** @param {string} name */
  function spelled(name) {
    const place = make_element("span", {}, name);
    if (names[name]) place.innerHTML = names[name];
    return place;
  }

  /** @param {string} monomial */
  function monomial_nodes(monomial) {
    return powers(monomial).flatMap(([name, power], n) => {
      const space = n ? ["\u2009"] : [];
      if (power === "1") return [...space, spelled(name)];
      const spelling = /^(cos|sin)/.test(name) ? ["(", spelled(name), ")"] : [spelled(name)];
      return [...space, ...spelling, make_element("sup", {}, power)];
    });
  }

  /**
   * A term's sign, of which the first one's plus is left out, and its number, of which a 1 before names is.
   * @param {string} monomial
   * @param {string} coefficient
   * @param {boolean} first
   * @param {string} minus
   */
  function sign_and_number(monomial, coefficient, first, minus) {
    const sign = coefficient.startsWith("-") ? minus : first ? "" : "+";
    const size = coefficient.replace("-", "");
    return { front: sign && !first ? `${sign} ` : sign, number: size === "1" && monomial ? "" : size };
  }

  /** @param {string} monomial @param {string} coefficient @param {boolean} first */
  function term(monomial, coefficient, first) {
    const { front, number } = sign_and_number(monomial, coefficient, first, "−");
    const space = number && monomial ? "\u2009" : "";
    return make_element("span", { class: "check-term" }, front + number + space, ...monomial_nodes(monomial));
  }

  /** The polynomial as mathematics; of a very long one the beginning. @param {PolynomialData} data */
  function typeset(data) {
    const terms = sorted(data);
    const rest = terms.length - MOST;
    const parts = terms
      .slice(0, MOST)
      .flatMap(([monomial, coefficient], n) => [n ? " " : "", term(monomial, coefficient, !n)]);
    const more = rest > 0 ? [` and ${rest} more term${rest > 1 ? "s" : ""}`] : [];
    return make_element("span", { class: "check-polynomial" }, ...(parts.length ? parts : ["0"]), ...more);
  }

  /** The polynomial as it can be typed. @param {PolynomialData} data */
  function text(data) {
    const parts = sorted(data).map(([monomial, coefficient], n) => {
      const { front, number } = sign_and_number(monomial, coefficient, !n, "-");
      return front + [number, monomial].filter(Boolean).join(" ");
    });
    return parts.join(" ") || "0";
  }

  /** @param {string} text */
  function fraction(text) {
    const [top, bottom = 1n] = text.split("/").map(BigInt);
    return reduced(top, bottom);
  }

  /**
   * What was typed, as data. Throws an Error in the reader's terms; `known`: the names that may be used.
   * @param {string} typed
   * @param {Set<string>} known
   */
  function parse(typed, known) {
    const token =
      /\s*(?:([-+−])|(\d+)(?:\s*\/\s*(\d+))?(?![\w(])|([A-Za-z]\w*(?:\([^()]*\))?)(?:\s*\^\s*(\d+))?)(?:\s*[*·])?/y;
    /** @type {PolynomialData} */
    const data = {};
    /** @type {Map<string, number>} */
    let powers = new Map();
    let sign = "";
    let size = "";
    function finish() {
      if (!size && !powers.size) throw new Error("a term is missing");
      const names = [...powers].sort().map(([name, power]) => (power > 1 ? `${name}^${power}` : name));
      const monomial = names.join(" ");
      data[monomial] = printed(plus(fraction(data[monomial] ?? "0"), fraction(sign + (size || "1"))));
      if (data[monomial] === "0") delete data[monomial];
      [sign, size, powers] = ["", "", new Map()];
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
        if (size || powers.size) throw new Error(`${top} stands where a name or a sign should`);
        if (bottom && !Number(bottom)) throw new Error("a division by zero");
        size = bottom ? `${top}/${bottom}` : top;
      } else {
        if (!known.has(name)) throw new Error(`nothing is called ${name} here`);
        if (!(Number(power) >= 1 && Number(power) <= 20)) throw new Error("an exponent is a whole number from 1 to 20");
        powers.set(name, (powers.get(name) ?? 0) + Number(power));
      }
    }
    finish();
    return data;
  }

  return { typeset, zero, term, sorted, spelled, text, parse };
}

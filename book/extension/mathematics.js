// Typesets a list of formulas, [[TeX, whether displayed], …] on the standard input, as a list of MathML, with the packaged
// MathJax, whose folder is the argument. It runs when the book is built, and on no page.
"use strict";
const folder = process.argv[2];
const settings = { loader: { paths: { mathjax: folder }, load: ["input/tex", "adaptors/liteDOM"] } };
settings.tex = { packages: ["base", "ams"], formatError: (_, error) => { throw error; } };
console.error = console.log = () => {}; // of versions, which are those of the package
require(`${folder}/node-main.js`).init(settings).then((MathJax) => {
  const formulas = JSON.parse(require("node:fs").readFileSync(0, "utf8"));
  const typeset = formulas.map(([tex, display]) => MathJax.tex2mml(tex, { display }));
  process.stdout.write(JSON.stringify(typeset));
});

// Puts the buttons where the page has places for them. The data stands in the page: nothing is asked for.
"use strict";
var Checker = Checker || {};

// Every certificate of the book, one after the other, with a bar and a summary.
Checker.all = function (place, theorems, clerk) {
  const make = Checker.make, button = make("button", { type: "button" }, "Check all");
  const total = theorems.reduce((sum, { claims }) => sum + claims.reduce((n, { statements }) => n + statements.length, 0), 0);
  const bar = make("progress", { max: total, value: 0, "aria-label": "Certificates checked" }), verdict = make("div", { class: "check-verdict", role: "status" });

  function mark(theorem, accepted) {
    const line = document.querySelector(`[data-claim="${theorem}"]`);
    line?.querySelector(".check-mark")?.remove();
    line?.append(make("span", { class: `check-mark check-${accepted ? "accepted" : "rejected"}` }, accepted ? " ✓ accepted here" : " ✗ rejected here"));
  }

  async function check() {
    button.disabled = true;
    bar.value = 0;
    verdict.replaceChildren();
    const rejected = [], begin = performance.now();
    let busy = 0;
    try {
      const answered = (answer) => {
        busy += answer.time;
        bar.value += 1;
        return answer.accepted;
      };
      const check = ({ statement, certificate }) => clerk.check(statement, certificate).then(answered);
      const asked = theorems.map(async ({ theorem, claims }) => {
        const accepted = await Promise.all(claims.flatMap(({ statements }) => statements.map(check)));
        if (accepted.includes(false)) rejected.push(theorem);
        mark(theorem, !accepted.includes(false));
      });
      await Promise.all(asked);
      const seconds = (time) => `${(time / 1000).toFixed(1)} s`, spent = `${seconds(performance.now() - begin)}, ${seconds(busy)} of it in the kernel`;
      const good = `${theorems.length - rejected.length} of ${theorems.length} theorems`;
      const names = rejected.length ? ` Rejected: ${rejected.join(", ")}.` : "";
      const word = rejected.length ? "Rejected" : "Accepted";
      verdict.replaceChildren(make("p", { class: `check-${word.toLowerCase()}` }, make("strong", {}, word), `: the certificates of ${good}, ${total} in all, in ${spent}, by this browser.${names}`));
    } catch (why) {
      verdict.replaceChildren(make("p", { class: "check-rejected" }, make("strong", {}, "No verdict"), `: ${why.message}.`));
    }
    button.disabled = false;
  }

  button.addEventListener("click", check);
  place.querySelector(".check-body")?.remove(); // of a page that was saved with its buttons
  place.append(make("div", { class: "check-body" }, make("p", { class: "check-buttons" }, button, bar), verdict));
};

Checker.start = function () {
  const clerk = Checker.clerk(), data = (element) => Checker.parsed(element.querySelector("script[type='application/json']").textContent.replaceAll("\\u003c", "<"));
  const cards = [...document.querySelectorAll(".checker[data-theorem]")].map((place) => [place, data(place)]);
  for (const [place, own] of cards) Checker.card(place, own, clerk);
  for (const place of document.querySelectorAll(".checker[data-all]")) {
    const listed = data(place); // nothing where all cards stand in this document: the file that is mailed
    Checker.all(place, listed.length ? listed : cards.map(([, own]) => own), clerk);
  }
};

if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", Checker.start);
else Checker.start();

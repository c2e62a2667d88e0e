// Puts the buttons where the page has places for them. The data stands in the page: nothing is asked for.
"use strict";

/** @param {Element} place @param {Element[]} buttons @param {...Element} parts */
function put_checker(place, buttons, ...parts) {
  place.querySelector(".check-body")?.remove(); // of a page that was saved with its buttons
  const row = make_element("p", { class: "check-buttons" }, ...buttons);
  place.append(make_element("div", { class: "check-body" }, row, ...parts));
}

/** A verdict: its word, and what is said of it. @param {"Accepted" | "Rejected" | "No verdict"} word @param {string} text */
function verdict_line(word, text) {
  const look = word === "Accepted" ? "check-accepted" : "check-rejected"; // whole: else no page has the name
  return make_element("p", { class: look }, make_element("strong", {}, word), text);
}

const verdict_box = () => make_element("div", { class: "check-verdict", role: "status" });

/** @param {unknown} why */
const no_verdict = (why) => [verdict_line("No verdict", `: ${error_text(why)}.`)];

/**
 * Show what comes of a check, its button out of use meanwhile.
 * @param {HTMLButtonElement} button
 * @param {Element} verdict
 * @param {() => Promise<Element[]>} check
 */
async function show_verdict(button, verdict, check) {
  button.disabled = true;
  verdict.replaceChildren(...(await check().catch(no_verdict)));
  button.disabled = false;
}

/**
 * Every certificate of the book, one after the other, with a bar and a summary.
 * @param {Element} place
 * @param {() => Promise<TheoremData[]>} read
 * @param {Clerk} clerk
 */
function check_all(place, read, clerk) {
  const bar = make_element("progress", { value: 0, "aria-label": "Certificates checked" });
  const verdict = verdict_box();
  const button = make_button("Check all", () => show_verdict(button, verdict, check));

  async function check() {
    const begin = performance.now();
    /** @type {string[]} */
    const rejected = [];
    verdict.replaceChildren();
    const theorems = await read();
    let certificates = 0;
    const asked = theorems.map(async ({ theorem, claims }) => {
      const cases = claims.flatMap(({ statements }) => statements);
      certificates += cases.length;
      const answers = cases.map(async ({ statement, certificate }) => {
        const { accepted } = await clerk.check(statement, certificate);
        bar.value++;
        return accepted;
      });
      const accepted = (await Promise.all(answers)).every(Boolean);
      if (!accepted) rejected.push(theorem);
      const said = accepted ? "accepted" : "rejected";
      const refuted = cases[0]?.statement.kind === "refutation" ? "refutation " : "";
      const line = document.querySelector(`[data-claim="${theorem}"]`);
      line?.querySelector(".check-mark")?.remove();
      const words = ` ${accepted ? "✓" : "✗"} ${refuted}${said} here`;
      line?.append(make_element("span", { class: `check-mark check-${said}` }, words));
    });
    set_attributes(bar, { max: certificates, value: 0 });
    await Promise.all(asked);
    const good = `${theorems.length - rejected.length} of ${theorems.length} theorems, ${certificates} in all`;
    const spent = ((performance.now() - begin) / 1000).toFixed(1);
    const names = rejected.length ? ` Rejected: ${rejected.join(", ")}.` : "";
    const words = `: the certificates of ${good}, in ${spent} s, by this browser.${names}`;
    return [verdict_line(rejected.length ? "Rejected" : "Accepted", words)];
  }

  put_checker(place, [button, bar], verdict);
}

/** @param {string} base64 */
const data_in = async (base64) => parsed_canonical(await unpacked(base64).text());

/** @param {Element} place */
const data_of = (place) => data_in(find_element(place, "script[type='application/gzip']").textContent);

function start_checker() {
  const clerk = checking_clerk();
  /** @param {ParentNode} part */
  const places = (part, which = "") => find_all(part, `.checker[data-theorem]${which}`);
  /** @param {HTMLElement} place */
  const put_card = async (place) => checker_card(place, await data_of(place), clerk);
  when_near(places(document), put_card);
  document.addEventListener(
    "toggle",
    ({ target }) => when_near(places(/** @type {Element} */ (target), ":not(:has(.check-body))"), put_card),
    true
  );
  for (const place of document.querySelectorAll(".checker[data-all]")) {
    // None of its own where all cards stand in this document: the file that is mailed.
    const read = async () => {
      if (place.querySelector("script")) return data_of(place);
      const folded = find_all(document, "details > noscript").flatMap(
        ({ textContent }) => /gzip">([^<]+)/.exec(textContent)?.[1] ?? []
      );
      return Promise.all([...places(document).map(data_of), ...folded.map(data_in)]);
    };
    check_all(place, read, clerk);
  }
}

when_ready(start_checker);

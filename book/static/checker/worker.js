// The kernel in a worker, so that the page never waits for it; and the page's end of the line.
"use strict";

/** What the worker does with a question. @param {(answer: Answer) => void} post @returns {(question: Question) => void} */
function checking_worker(post) {
  const { check } = certificate_kernel();
  return ({ id, statement, certificate }) => {
    const begin = performance.now();
    const answer = check(statement, certificate);
    post({ id, ...answer, time: performance.now() - begin });
  };
}

// One worker for the page, made when first asked.
function checking_clerk() {
  const PATIENCE = 20000; // milliseconds from one answer to the next; the slowest takes a fraction of a second
  /** @type {Worker | null} */
  let worker = null;
  let timer = 0;
  let count = 0;
  /** @type {Map<number, { resolve(answer: Answer): void, reject(why: Error): void }>} */
  const waiting = new Map();

  function start() {
    const made = worker_of(certificate_kernel, checking_worker);
    made.onmessage = ({ data }) => {
      waiting.get(data.id)?.resolve(data);
      waiting.delete(data.id);
      watch();
    };
    made.onerror = (event) => {
      event.preventDefault();
      stop(`the worker failed${event.message ? ` (${event.message})` : ""}`);
    };
    return made;
  }

  function watch() {
    clearTimeout(timer);
    if (waiting.size) timer = setTimeout(() => stop(`there was no answer within ${PATIENCE / 1000} seconds`), PATIENCE);
  }

  /** Give up on everything that was asked; the next question starts a new worker. @param {string} why */
  function stop(why) {
    worker?.terminate();
    worker = null;
    for (const { reject } of waiting.values()) reject(new Error(why));
    waiting.clear();
    watch();
  }

  /**
   * A promise of the kernel's answer; it fails, and says why, where the worker gives none.
   * @param {Statement} statement
   * @param {Certificate} certificate
   * @returns {Promise<Answer>}
   */
  function check(statement, certificate) {
    return new Promise((resolve, reject) => {
      worker ??= start(); // what this throws becomes the promise's failure
      waiting.set(++count, { resolve, reject });
      worker.postMessage({ id: count, statement, certificate });
      if (waiting.size === 1) watch();
    });
  }

  return { check };
}

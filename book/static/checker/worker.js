// The kernel in a worker, so that the page never waits for it; and the page's end of the line.
"use strict";

/** What the worker does with a question. @param {(answer: Answer) => void} post @returns {(question: Case) => void} */
function checking_worker(post) {
  const { check } = certificate_kernel();
  return ({ statement, certificate }) => {
    const begin = performance.now();
    const answer = check(statement, certificate);
    post({ ...answer, time: performance.now() - begin });
  };
}

// One worker for the page, made when first asked.
function checking_clerk() {
  const PATIENCE = 20000; // milliseconds from a question to its answer; the slowest takes a fraction of a second
  /** @type {Worker | null} */
  let worker = null;
  /** @type {Promise<unknown>} */
  let last = Promise.resolve();

  /** @param {Case} question @returns {Promise<Answer>} */
  function ask(question) {
    return new Promise((resolve, reject) => {
      worker ??= worker_of(certificate_kernel, checking_worker); // what this throws becomes the promise's failure
      const timer = setTimeout(stop, PATIENCE, `there was no answer within ${PATIENCE / 1000} seconds`);

      /** The next question starts a new worker. @param {string} why */
      function stop(why) {
        clearTimeout(timer);
        worker?.terminate();
        worker = null;
        reject(new Error(why));
      }
      /** @param {Answer} answer */
      function take(answer) {
        clearTimeout(timer);
        resolve(answer);
      }
      listen(worker, take, (why) => stop(`the worker failed: ${why}`));
      worker.postMessage(question);
    });
  }

  /**
   * A promise of the kernel's answer; it fails, and says why, where the worker gives none, and with it all that wait
   * for their turn.
   * @param {Statement} statement
   * @param {Certificate} certificate
   */
  function check(statement, certificate) {
    const answer = last.then(() => ask({ statement, certificate }));
    last = answer;
    answer.catch(() => {
      last = Promise.resolve();
    });
    return answer;
  }

  return { check };
}

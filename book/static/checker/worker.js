// The kernel in a worker, so that the page never waits for it; and the page's end of the line.
"use strict";
var Checker = Checker || {};

// What the worker does: {id, statement, certificate} → the kernel's answer, with the milliseconds that it took.
Checker.worker = function (port) {
  const { check } = Checker.kernel();
  port.onmessage = ({ data: { id, statement, certificate } }) => {
    const begin = performance.now(), answer = check(statement, certificate);
    port.postMessage({ id, ...answer, time: performance.now() - begin });
  };
};

// One worker for the page, made when first asked, from a Blob: a file opened from a disk may not load it by address.
Checker.clerk = function () {
  const PATIENCE = 20000; // milliseconds from one answer to the next; the slowest takes a fraction of a second
  let worker = null, timer = 0, count = 0;
  const waiting = new Map();

  function start() {
    const parts = ["kernel", "worker"].map((name) => `Checker.${name} = ${Checker[name]};`);
    const source = ['"use strict"; const Checker = {};', ...parts, "Checker.worker(self);"].join("\n");
    const address = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    worker = new Worker(address);
    URL.revokeObjectURL(address);
    worker.onmessage = ({ data }) => {
      waiting.get(data.id)?.resolve(data);
      waiting.delete(data.id);
      watch();
    };
    worker.onerror = (event) => {
      event.preventDefault();
      stop(`the worker failed${event.message ? ` (${event.message})` : ""}`);
    };
  }

  function watch() {
    clearTimeout(timer);
    if (waiting.size) timer = setTimeout(() => stop(`there was no answer within ${PATIENCE / 1000} seconds`), PATIENCE);
  }

  // Give up on everything that was asked; the next question starts a new worker.
  function stop(why) {
    worker?.terminate();
    worker = null;
    for (const { reject } of waiting.values()) reject(new Error(why));
    waiting.clear();
    watch();
  }

  // A promise of the kernel's answer; it fails, and says why, where the worker gives none.
  function check(statement, certificate) {
    return new Promise((resolve, reject) => {
      if (!worker) start(); // what this throws becomes the promise's failure
      waiting.set(++count, { resolve, reject });
      worker.postMessage({ id: count, statement, certificate });
      if (waiting.size === 1) watch();
    });
  }

  return { check };
};

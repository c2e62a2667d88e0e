// The workers, and who draws what: each has a band of rows. One picture is asked for at a time; of the states that
// come meanwhile only the last is drawn. When nothing moves, the workers are given the idle work.
"use strict";
var Simulator = Simulator || {};

Simulator.engine = function (data, compiled, states, module, heard) {
  const IDLE_AFTER = 150;
  const parts = ["module", "worker"].map((name) => `Simulator.${name} = ${Simulator[name]};`);
  const source = ['"use strict"; const Simulator = {};', ...parts, "Simulator.worker(self);"].join("\n");
  const address = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
  let workers = [], bands = [], waiting = null, next = null, last = null, timer = 0, id = 0;

  // As many as there are cores; each has its own memory, since pages from a disk cannot share any.
  function start() {
    if (workers.length) return;
    workers = Array.from({ length: navigator.hardwareConcurrency || 1 }, (_, number) => {
      const worker = new Worker(address), own = { worker, buffers: {} };
      worker.onmessage = ({ data }) => receive(data, number);
      worker.postMessage({ kind: "begin", data, compiled });
      worker.onerror = (event) => heard.failed(event.message || "the worker did not start");
      return own;
    });
    waiting = null;
    bands = [];
    if (last) ask(last);
  }

  function stop() {
    clearTimeout(timer);
    for (const { worker } of workers) worker.terminate();
    workers = [];
  }

  // Cut the rows into bands of about equal work: a row costs what it has of A, and a little.
  function cut(state) {
    const raster = states.crop(state), reach = module.radius_of_a, y = Array.from(module.image_points(raster)[1]);
    const cost = y.map((at) => Math.sqrt(Math.max(0, reach * reach - at * at)) + 0.02 * reach), whole = cost.reduce((a, b) => a + b);
    let sum = 0;
    const band_of = cost.map((part) => Math.floor((workers.length * ((sum += part) - part / 2)) / whole));
    return workers.map((_, n) => ({ first: band_of.indexOf(n), last: band_of.lastIndexOf(n) })).filter(({ first }) => first >= 0)
      .map(({ first, last }) => ({ ...raster, top: raster.top + first, high: last + 1 - first }));
  }

  // Draw this state as soon as the workers are free.
  function ask(state) {
    clearTimeout(timer);
    last = state;
    next = { state, asked: performance.now() };
    if (!waiting && workers.length) send();
  }

  const same_raster = (a, b) => ["size", "zoom", "left", "top"].every((name) => a[name] === b[name]);

  function send() {
    const { state, asked } = next;
    next = null;
    if (!bands.length || !same_raster(bands.of, state)) bands = Object.assign(cut(state), { of: state });
    waiting = { id: ++id, state, asked, replies: [], missing: bands.length };
    bands.forEach((band, n) => {
      const { worker, buffers } = workers[n];
      workers[n].buffers = {};
      worker.postMessage({ kind: "draw", id, state, band, buffers }, Object.values(buffers));
    });
  }

  function receive(data, number) {
    if (data.kind !== "drawn") {
      if (data.id === id && !waiting) heard[data.kind](data, bands.length);
      return;
    }
    waiting.replies[number] = data;
    if (--waiting.missing) return;
    const { state, asked, replies } = waiting;
    waiting = null;
    heard.drawn(state, replies, asked);
    replies.forEach(({ images }, n) => {
      workers[n].buffers = Object.fromEntries(Object.entries(images).map(([name, { bytes }]) => [name, bytes.buffer]));
    });
    if (next) send();
    else timer = setTimeout(() => rest(state), IDLE_AFTER);
  }

  function rest(state) {
    if (document.hidden || waiting) return;
    const steps = heard.resting(state);
    bands.forEach((band, n) => workers[n].worker.postMessage({ kind: "idle", id, state, band, steps }));
  }

  return { start, stop, ask };
};

// The workers, and who draws what: each has a band of rows. One picture is asked for at a time; of the states that
// come meanwhile only the last is drawn. When nothing moves, the workers are given the idle work. A small picture is
// drawn by the page itself: that takes less time than to hand it over, and it is there in the slider's own frame.
"use strict";

Simulator.engine = function (data, compiled, states, module, handlers) {
  const IDLE_AFTER = 150, SMALL = 256, AT_ONCE = 12; // milliseconds; pixels; milliseconds
  const parts = ["module", "worker"].map((name) => `Simulator.${name} = ${Simulator[name]};`);
  const source = ['"use strict"; const Simulator = {};', ...parts, "Simulator.worker(self);"].join("\n");
  const address = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
  let workers = [], bands = [], waiting = null, next = null, last = null, timer = 0, id = 0, resting = 0, pieces = {}, usual = 0;
  const page = [{ worker: drawer_here(), buffers: {} }];

  // What a worker does, done here and now.
  function drawer_here() {
    const port = { postMessage: (reply) => receive(reply, 0) };
    Simulator.worker(port);
    port.onmessage({ data: { kind: "begin", data, compiled } });
    return { postMessage: (message) => port.onmessage({ data: message }) };
  }

  // As many as there are cores; each has its own memory, since pages from a disk cannot share any.
  function start() {
    if (workers.length) return;
    workers = Array.from({ length: navigator.hardwareConcurrency || 1 }, (_, number) => {
      const worker = new Worker(address), own = { worker, buffers: {} };
      worker.onmessage = ({ data }) => receive(data, number);
      worker.postMessage({ kind: "begin", data, compiled });
      worker.onerror = (event) => handlers.failed(event.message || "the worker did not start");
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
  function cut(state, count) {
    const raster = states.crop(state), reach = module.radius_of_a, y = Array.from(module.image_points(raster)[1]);
    const cost = y.map((at) => Math.sqrt(Math.max(0, reach * reach - at * at)) + 0.02 * reach), whole = cost.reduce((a, b) => a + b);
    let sum = 0;
    const band_of = cost.map((part) => Math.floor((count * ((sum += part) - part / 2)) / whole));
    return Array.from({ length: count }, (_, n) => ({ first: band_of.indexOf(n), last: band_of.lastIndexOf(n) })).filter(({ first }) => first >= 0)
      .map(({ first, last }) => ({ ...raster, top: raster.top + first, high: last + 1 - first }));
  }

  // Draw this state as soon as the workers are free.
  function ask(state) {
    clearTimeout(timer);
    last = state;
    next = { state, asked: performance.now() };
    if (!waiting && workers.length) send();
  }

  // Who draws a state, and each one's band of rows. A drawer keeps what it has as long as its band is the same.
  function send() {
    const { state, asked } = next, drawers = state.size <= SMALL && usual < AT_ONCE ? page : workers;
    const anew = bands.drawers !== drawers || ["size", "zoom", "left", "top"].some((name) => bands.of[name] !== state[name]);
    next = null;
    if (anew) bands = Object.assign(cut(state, drawers.length), { of: state, drawers });
    if (resting && drawers === page) for (const { worker } of workers) worker.postMessage({ kind: "stop" });
    resting = 0;
    waiting = { id: ++id, state, asked, drawers, anew, sent: performance.now(), replies: [], missing: bands.length };
    bands.forEach((band, n) => {
      const { worker, buffers } = drawers[n];
      drawers[n].buffers = {};
      worker.postMessage({ kind: "draw", id, state, band, buffers, anew }, Object.values(buffers));
    });
  }

  function receive(data, number) {
    if (data.kind !== "drawn") return found(data);
    if (data.id !== waiting?.id) return;
    waiting.replies[number] = data;
    if (--waiting.missing) return;
    const { state, asked, drawers, anew, sent, replies } = waiting;
    waiting = null;
    if (drawers === page && !anew) usual += 0.2 * (performance.now() - sent - usual);
    handlers.drawn(state, replies, asked);
    replies.forEach(({ images }, n) => {
      drawers[n].buffers = Object.fromEntries(Object.entries(images).map(([name, { bytes }]) => [name, bytes.buffer]));
    });
    if (next) send();
    else timer = setTimeout(() => rest(state), IDLE_AFTER);
  }

  // Idle work is reported when all have done that piece of it.
  function found(reply) {
    if (reply.id !== id || !resting) return;
    const all = (pieces[`${reply.kind} ${reply.index}`] ??= []);
    if (all.push(reply) === resting) handlers[reply.kind](all);
  }

  function rest(state) {
    if (document.hidden || waiting) return;
    usual /= 2; // lest a busy moment keep the page from drawing
    const steps = handlers.resting(state), parts = bands.drawers === workers ? bands : cut(state, workers.length);
    resting = parts.length;
    pieces = {};
    parts.forEach((band, n) => workers[n].worker.postMessage({ kind: "idle", id, state, band, steps }));
  }

  return { start, stop, ask };
};

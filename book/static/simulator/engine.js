// The workers, and who draws what: each has a band of rows. One picture is asked for at a time; of the states that
// come meanwhile only the last is drawn. When nothing moves, the workers are given the idle work. A small picture is
// drawn by the page itself: that takes less time than to hand it over, and it is there in the slider's own frame.
"use strict";

/**
 * @param {SimulatorData} data
 * @param {WebAssembly.Module} compiled
 * @param {States} states
 * @param {SimulatorModule} module
 * @param {Handlers} handlers
 */
function simulator_engine(data, compiled, states, module, handlers) {
  const IDLE_AFTER = 150; // milliseconds
  const SMALL = 256; // pixels
  const AT_ONCE = 12; // milliseconds
  /** @type {Drawer[]} */
  let workers = [];
  /** @type {{ bands: Raster[], drawers: Drawer[], of: State | null }} */
  let cut = { bands: [], drawers: [], of: null };
  /** @type {{ id: number, state: State, asked: number, anew: boolean, sent: number, replies: Drawn[], missing: number } | null} */
  let waiting = null;
  /** @type {{ state: State, asked: number } | null} */
  let next = null;
  /** @type {State | null} */
  let last = null;
  /** @type {Record<string, any[]>} */
  let pieces = {};
  let timer = 0;
  let id = 0;
  let resting = 0;
  let usual = 0; // milliseconds that the page takes for a picture
  const page = [{ post: simulator_worker((reply) => receive(reply, 0)), buffers: {}, stop() {} }];
  page[0].post({ kind: "begin", data, compiled });

  // As many as there are cores; each has its own memory, since pages from a disk cannot share any.
  function start() {
    if (workers.length) return;
    workers = Array.from({ length: navigator.hardwareConcurrency || 1 }, (_, number) => {
      const worker = worker_of(float64s, simulator_module, simulator_worker);
      worker.onmessage = ({ data }) => receive(data, number);
      worker.postMessage({ kind: "begin", data, compiled });
      worker.onerror = (event) => handlers.failed(event.message || "the worker did not start");
      return {
        post: (task, transfer = []) => worker.postMessage(task, transfer),
        stop: () => worker.terminate(),
        buffers: {}
      };
    });
    waiting = null;
    cut = { bands: [], drawers: [], of: null };
    if (last) ask(last);
  }

  function stop() {
    clearTimeout(timer);
    for (const worker of workers) worker.stop();
    workers = [];
  }

  /** Cut the rows into bands of about equal work: a row costs what it has of A, and a little. @param {State} state */
  function bands_of(state, count = workers.length) {
    const raster = states.crop(state);
    const reach = module.radius_of_a;
    const [, y] = module.image_points(raster);
    const cost = y.map((at) => Math.sqrt(Math.max(0, reach * reach - at * at)) + 0.02 * reach);
    const whole = cost.reduce((a, b) => a + b);
    let sum = 0;
    const band_of = cost.map((part) => {
      sum += part;
      return Math.floor((count * (sum - part / 2)) / whole);
    });
    const numbers = [...new Set(band_of)];
    return numbers.map((number) => {
      const first = band_of.indexOf(number);
      return { ...raster, top: raster.top + first, high: band_of.lastIndexOf(number) + 1 - first };
    });
  }

  /** Draw this state as soon as the workers are free. @param {State} state */
  function ask(state) {
    clearTimeout(timer);
    last = state;
    next = { state, asked: performance.now() };
    if (!waiting && workers.length) send(next);
  }

  /**
   * Who draws a state, and each one's band of rows. A drawer keeps what it has as long as its band is the same.
   * @param {{ state: State, asked: number }} what
   */
  function send({ state, asked }) {
    const drawers = state.size <= SMALL && usual < AT_ONCE ? page : workers;
    const { of } = cut;
    const anew =
      !of || cut.drawers !== drawers || ["size", "zoom", "left", "top"].some((name) => of[name] !== state[name]);
    next = null;
    if (anew) cut = { bands: bands_of(state, drawers.length), of: state, drawers };
    if (resting && drawers === page) for (const { post } of workers) post({ kind: "stop" });
    resting = 0;
    waiting = { id: ++id, state, asked, anew, sent: performance.now(), replies: [], missing: cut.bands.length };
    for (const [n, band] of cut.bands.entries()) {
      const { post, buffers } = drawers[n];
      drawers[n].buffers = {};
      post({ kind: "draw", id, state, band, buffers, anew }, Object.values(buffers));
    }
  }

  /** @param {Reply} reply @param {number} number */
  function receive(reply, number) {
    if (reply.kind !== "drawn") return found(reply);
    if (!waiting || reply.id !== waiting.id) return;
    waiting.replies[number] = reply;
    waiting.missing--;
    if (waiting.missing) return;
    const { state, asked, anew, sent, replies } = waiting;
    waiting = null;
    if (cut.drawers === page && !anew) usual += 0.2 * (performance.now() - sent - usual);
    handlers.drawn(state, replies, asked);
    for (const [n, { images }] of replies.entries()) {
      const buffers = Object.entries(images).map(([name, { bytes }]) => [name, bytes.buffer]);
      cut.drawers[n].buffers = Object.fromEntries(buffers);
    }
    if (next) send(next);
    else timer = setTimeout(() => rest(state), IDLE_AFTER);
  }

  /** Idle work is reported when all have done that piece of it. @param {Counted | Followed | Timed} reply */
  function found(reply) {
    if (reply.id !== id || !resting) return;
    const piece = `${reply.kind} ${reply.index}`;
    pieces[piece] ??= [];
    if (pieces[piece].push(reply) === resting) handlers[reply.kind](pieces[piece]);
  }

  /** @param {State} state */
  function rest(state) {
    if (document.hidden || waiting) return;
    usual /= 2; // lest a busy moment keep the page from drawing
    const steps = handlers.resting(state);
    const bands = cut.drawers === workers ? cut.bands : bands_of(state);
    resting = bands.length;
    pieces = {};
    for (const [n, band] of bands.entries()) workers[n].post({ kind: "idle", id, state, band, steps });
  }

  return { start, stop, ask };
}

// Who draws what. The page itself draws at most 256 × 256 pixels, in the slider's own frame: to hand that over would take
// longer. When nothing moves any more, the workers draw all pixels of a larger picture, each a band of rows, and then do
// the idle work. The next move cancels either.
"use strict";

/**
 * @param {SimulatorData} data
 * @param {WebAssembly.Module} compiled
 * @param {States} states
 * @param {SimulatorModule} module
 * @param {Handlers} handlers
 */
function simulator_engine(data, compiled, states, module, handlers) {
  const REFINED_AFTER = 80; // milliseconds
  const IDLE_AFTER = 150;
  const SMALL = 256; // pixels
  /** @type {Worker[]} */
  let workers = [];
  /** @type {{ id: number, state: State, asked: number, replies: Drawn[] }} */
  let waiting = { id: 0, state: states.start(), asked: 0, replies: [] };
  /** @type {State | null} */
  let next = null; // asked for since the last frame
  let last = states.start();
  /** @type {Record<string, any[]>} */
  let pieces = {};
  let frame = 0;
  let timer = 0;
  let id = 0;
  let resting = 0;
  let refined = ""; // the raster that the workers were last asked for
  /** @type {Drawer} */
  const page = { postMessage: simulator_worker((reply) => receive(reply, page)) };
  page.postMessage({ kind: "begin", data, compiled });

  // As many as there are cores; each has its own memory, since pages from a disk cannot share any.
  function start() {
    if (workers.length) return;
    workers = Array.from({ length: navigator.hardwareConcurrency || 1 }, () => {
      const worker = worker_of(float64s, simulator_module, simulator_worker);
      worker.onmessage = ({ data }) => receive(data, worker);
      worker.postMessage({ kind: "begin", data, compiled });
      worker.onerror = (event) => handlers.failed(event.message || "the worker did not start");
      return worker;
    });
    refine(last); // also the first picture, while the page is laid out
  }

  function stop() {
    clearTimeout(timer);
    for (const worker of workers) worker.terminate();
    workers = [];
  }

  /** Cut the rows into bands of about equal work: a row costs what it has of A, and a little. @param {State} state */
  function bands_of(state) {
    const raster = states.crop(state);
    const reach = module.radius_of_a;
    const [, y] = module.image_points(raster);
    const cost = y.map((at) => Math.sqrt(Math.max(0, reach * reach - at * at)) + 0.02 * reach);
    const whole = total(Array.from(cost), Number);
    let sum = 0;
    const band_of = cost.map((part) => {
      sum += part;
      return Math.floor((workers.length * (sum - part / 2)) / whole);
    });
    const numbers = [...new Set(band_of)];
    return numbers.map((number) => {
      const first = band_of.indexOf(number);
      return { ...raster, top: raster.top + first, high: band_of.lastIndexOf(number) + 1 - first };
    });
  }

  /** Draw this state: at once, but only the last of those that a frame of the screen asks for. @param {State} state */
  function ask(state) {
    last = state;
    next = state;
    clearTimeout(timer);
    if (frame || !workers.length) return;
    frame = requestAnimationFrame(() => {
      frame = 0;
      if (next) ask(next);
    });
    next = null;
    if (resting) for (const worker of workers) worker.postMessage({ kind: "stop" });
    resting = 0;
    send(state, [page], [states.crop(state, Math.max(1, state.size / SMALL))]);
  }

  /** @param {State} state @param {Drawer[]} drawers @param {Raster[]} bands */
  function send(state, drawers, bands) {
    waiting = { id: ++id, state, asked: performance.now(), replies: [] };
    for (const [n, band] of bands.entries()) {
      const part = { raster: refined, bands: bands.length, begin: band.top - bands[0].top };
      drawers[n].postMessage({ kind: "draw", id, state, band, part });
    }
  }

  /** @param {Reply} reply @param {Drawer} drawer */
  function receive(reply, drawer) {
    if (reply.kind !== "drawn") return found(reply);
    // Also if it comes late, but of the same raster: a drawer sends what has changed, and that once.
    if (drawer === page || reply.part.raster === refined) handlers.painted(reply, drawer === page);
    const { state, asked, replies } = waiting;
    if (reply.id !== waiting.id || replies.push(reply) < reply.part.bands) return;
    const is_whole = drawer !== page || state.size <= SMALL;
    handlers.drawn(state, replies, asked, drawer === page, is_whole);
    timer = is_whole ? setTimeout(rest, IDLE_AFTER, state) : setTimeout(refine, REFINED_AFTER, state);
  }

  /** @param {State} state */
  function refine(state) {
    if (!workers.length) return;
    refined = Object.values(states.crop(state)).join();
    send(state, workers, bands_of(state));
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
    if (document.hidden || !workers.length) return;
    const steps = handlers.resting(state);
    const bands = bands_of(state);
    resting = bands.length;
    pieces = {};
    for (const [n, band] of bands.entries()) workers[n].postMessage({ kind: "idle", id, state, band, steps });
  }

  return { start, stop, ask };
}

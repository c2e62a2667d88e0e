// Who draws what. The page itself draws at most 256 × 256 pixels, in the slider's own frame: to hand that over would take
// longer; so it draws the first picture, too. When nothing moves any more, the workers start if they have not, draw all
// pixels of a larger picture, each a band of rows, and then do the idle work. The next move stops either. Where no worker
// starts or answers, the page does their part, too.
"use strict";

/**
 * @param {SimulatorData} data
 * @param {WebAssembly.Module} compiled
 * @param {States} states
 * @param {SimulatorModule} module
 * @param {Handlers} handlers
 */
function simulator_engine(data, compiled, states, module, handlers) {
  const AFTER = 100; // milliseconds, in which nothing moves
  const PATIENCE = 20000; // for the workers' answer
  const SMALL = 256; // pixels
  const MOST = 8; // workers: each has its own tables and memory
  /** @type {Drawer[]} */
  let workers = [];
  /** @type {{ id: number, state: State, asked: number, replies: Drawn[] }} */
  let waiting; // for the replies to what was sent last
  let last = states.start();
  /** @type {Record<string, any[]>} */
  let pieces = {};
  let frame = 0;
  let timer = 0;
  let id = 0;
  let resting = 0; // workers that have something to do
  let refined = ""; // the raster that the workers were last asked for
  let is_on = false;
  let end = 0; // of the scale of slopes, as the page has drawn them: of all bands
  /** @type {Drawer} */
  const page = { postMessage: simulator_worker((reply) => receive(reply, page)), terminate() {} };
  page.postMessage({ kind: "begin", data, compiled });

  function start() {
    if (is_on) return;
    is_on = true;
    ask(last);
  }

  // As many as there are cores; each has its own memory, since pages from a disk cannot share any.
  function hire() {
    if (workers.length) return;
    const cores = Math.min(navigator.hardwareConcurrency || 1, MOST);
    workers = Array.from({ length: cores }, () => {
      const worker = worker_of(float64s, formula_of, own_field, simulator_module, simulator_worker);
      listen(worker, (reply) => receive(reply, worker), go_alone);
      worker.postMessage({ kind: "begin", data, compiled });
      return worker;
    });
  }

  /** Have all pixels of a picture drawn, or what is left to do done. @param {State} state @param {boolean} is_whole */
  function go_on(state, is_whole) {
    if (!is_on) return;
    try {
      hire();
    } catch (error) {
      return go_alone(error_text(error));
    }
    timer = setTimeout(go_alone, PATIENCE, `no answer within ${PATIENCE / 1000} seconds`);
    (is_whole ? rest : refine)(state);
  }

  /** Have the page do what the workers would. @param {string} why */
  function go_alone(why) {
    stop();
    is_on = true;
    workers = [page];
    handlers.failed(why);
    refine(last);
  }

  function stop() {
    clearTimeout(timer);
    cancelAnimationFrame(frame);
    frame = 0;
    is_on = false;
    for (const worker of workers) worker.terminate();
    workers = [];
  }

  /** Cut the rows into bands of about equal work: a row costs what it has of A, and a little. @param {State} state */
  function bands_of(state) {
    const raster = states.crop(state);
    const [, y] = module.image_points(raster);
    const cost = y.map((at) => Math.sqrt(Math.max(0, 1 - (at / module.radius_of_a) ** 2)) + 0.02);
    const whole = total([...cost], Number);
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
    clearTimeout(timer);
    if (frame || !is_on) return;
    frame = requestAnimationFrame(() => {
      frame = 0;
      if (last !== state) ask(last);
    });
    if (resting) for (const worker of workers) worker.postMessage({ kind: "stop" });
    resting = 0;
    send(state, [page], [states.crop(state, Math.max(1, state.size / SMALL))]);
  }

  /** @param {State} state @param {Drawer[]} drawers @param {Raster[]} bands */
  function send(state, drawers, bands) {
    waiting = { id: ++id, state, asked: performance.now(), replies: [] };
    for (const [n, band] of bands.entries()) {
      const part = { raster: refined, bands: bands.length, begin: band.top - bands[0].top };
      drawers[n].postMessage({ kind: "draw", id, state, band, part, end: drawers[n] === page ? 0 : end });
    }
  }

  /** @param {Reply} reply @param {Drawer} drawer */
  function receive(reply, drawer) {
    if (reply.kind !== "drawn") return found(reply);
    // Also if it comes late, but of the same raster: a drawer sends what has changed, and that once.
    if (drawer === page || reply.part.raster === refined) handlers.painted(reply, drawer === page);
    const { state, asked, replies } = waiting;
    if (reply.id !== waiting.id || replies.push(reply) < reply.part.bands) return;
    clearTimeout(timer);
    end = reply.end;
    const is_whole = reply.band.wide === state.size;
    handlers.drawn(state, replies, asked, drawer === page, is_whole);
    timer = setTimeout(go_on, AFTER, state, is_whole);
  }

  /** @param {State} state */
  function refine(state) {
    refined = Object.values(states.crop(state)).join();
    resting = workers.length;
    send(state, workers, bands_of(state));
  }

  /** Idle work is reported when all have done that piece of it. @param {Counted | Followed} reply */
  function found(reply) {
    if (reply.id !== id) return;
    const piece = `${reply.kind} ${reply.index}`;
    pieces[piece] ??= [];
    if (pieces[piece].push(reply) < resting) return;
    clearTimeout(timer);
    handlers[reply.kind](pieces[piece]);
  }

  /** @param {State} state */
  function rest(state) {
    const steps = handlers.resting(state);
    const bands = bands_of(state);
    resting = bands.length;
    pieces = {};
    for (const [n, band] of bands.entries()) workers[n].postMessage({ kind: "idle", id, state, band, steps });
  }

  return { start, stop, ask };
}

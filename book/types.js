// What the pages' scripts hand each other, by the files that make it: for the checker of types, no page loads this.

// What other scripts of the pages declare: those that the build prints, the mailed file's, and Sphinx's.
var /** @type {SimulatorParts} */ Simulator,
  /** @type {IdeasParts} */ Ideas,
  /** @type {ChapterPages} */ Chapter,
  /** @type {Record<string, [string, string][]>} */ SearchText,
  /** @type {Record<string, string>} */ Statements, // by the link's hash
  /** @type {SearchScorer} */ Scorer,
  /** @type {SphinxSearch} */ Search,
  /** @type {SphinxStemmer} */ Stemmer,
  /** @type {(query: string) => string[]} */ splitQuery,
  /** @type {(text: string) => string} */ _escapeRegExp;

// simulator/module.js
/**
 * @typedef {[number, number, number]} Vector
 * @typedef {{ width: number, height: number, left: number, top: number, wide: number, high: number }} Raster
 *   a part of a picture of width × height pixels
 * @typedef {{ name: string, eps?: number, way?: number, bump?: string }} Method how the gradient is taken: exactly, or by a difference of step eps
 * @typedef {{ field: string, h?: string, ku: number, kv: number, beta: number, model: string, ball: number,
 *   lights: boolean[], lamp?: Vector }} SceneState h: the reader's own formula, worn where the field is "own"; lamp: where
 *   the first light is
 * @typedef {(arguments_at: number) => void} Compiled
 * @typedef {{ head: number[], codes: Record<string, number[]>, functions: number }} Emitted what code is made of that a page emits: the bytes it begins with, those of each operation, and how many functions it imports
 * @typedef {(run: Compiled, columns: [taken: number, made: number], ...inputs: (number | Float64Array)[]) => Float64Array[]} OverPoints
 * @typedef {{ position: Vector, color: Vector }} LightData
 * @typedef {Omit<SceneState, "lights"> & { lights: LightData[], eye: number, radius: number, ball_center: Vector,
 *   ball_radius: number, ambient: Vector, albedo_a: Vector, kd: number }} SceneData
 * @typedef {{ srgb: { cells: number, thresholds: number[] }, sizes: { bits: number, thresholds: number[] },
 *   inferno: number[], grey: number[], slopes: number[], terms: number[], levels: number[] }} Tables
 * @typedef {{ scene: SceneData, scenes: Record<string, { scene: number[], lights: number[][] }>,
 *   offsets: Record<string, number>, light_size: number, shadows: number, max_algebraic: number, counts: number, lanes: number,
 *   fields: Record<string, { ways: Record<string, number>, sloped: number, creases: number }>, by: Record<string, string>, sloped: string[],
 *   models: Record<string, { index: number, power: number }>, arguments: string[],
 *   kernels: Record<string, [number, number]>, painting: string[], numbers: string[], tables: Tables, emitted: Emitted,
 *   terms: string[], term_colours: string[], scene_bounds?: number[],
 *   record: { gradient: object, scene: object } }} SimulatorData
 * @typedef {{ raster: Raster, pitch: number, addresses: Record<string, number> }} Ground planes in memory
 * @typedef {Ground & { codes: Uint8Array, count: number, at: Int32Array, rows: [number, number],
 *   targets: Record<string, number>, points?: Float64Array[] }} Stage points: u and v on A's pixels, once they are asked for
 * @typedef {{ whole?: boolean, of?: string, other?: string, table?: string, palette?: string, gain?: number }} Painting
 * @typedef {{ column: number, row: number, surface: string, rgb: number[], point?: number[],
 *   normal?: number[], gradient?: number[], slope?: number[], theta?: number, phi?: number, u?: number, v?: number, h?: number,
 *   kink?: boolean, straddling?: boolean }} PixelRecord
 * @typedef {Awaited<ReturnType<typeof simulator_module>>} SimulatorModule
 * @typedef {{ data: SimulatorData, program: string, running?: ReturnType<typeof simulator_start>,
 *   closer: Pick<CloserData, "kernels" | "pairs" | "scene_bounds"> & { program: string } }} SimulatorParts
 */

// simulator/state.js
/**
 * @typedef {Required<SceneState> & { eps: number, method: string, view: string, scale: string, size: number, zoom: number,
 *   left: number, top: number, column: number, row: number, [name: string]: any }} State
 * @typedef {{ start: any, read(text: string): any, write(value: any): string, holds(value: any): boolean,
 *   allowed: string }} Parameter
 * @typedef {ReturnType<typeof simulator_states>} States
 */

// simulator/formula.js
/**
 * @typedef {{ id: number, op: string, args: FormulaNode[], value: number, operations: number, part?: FormulaPart }}
 *   FormulaNode an operation, its parts, and its number if it has one; operations: how many, about; part: of the text
 * @typedef {{ word: string, at: number, digits?: string, name?: string, sign?: string, whole?: FormulaPart }} FormulaPart
 * @typedef {ReturnType<typeof own_field>} OwnField
 */

// simulator/worker.js
/**
 * @typedef {{ kind: "begin", data: SimulatorData, compiled: WebAssembly.Module } | { kind: "stop" } | DrawTask | IdleTask}
 *   Task
 * @typedef {{ kind: "draw", id: number, state: State, band: Raster, part: Part, end: number }}
 *   DrawTask
 * @typedef {{ raster: string, bands: number, begin: number }} Part how many bands a raster has, and the rows above this one
 * @typedef {{ kind: "idle", id: number, state: State, band: Raster, steps: number[] | null }} IdleTask
 * @typedef {{ kind: "drawn", id: number, band: Raster, part: Part, images: Record<string, { top: number, bytes: ImageDataArray }>,
 *   count: number, codes: Uint8Array | null, largest: number, squares: number, end: number }} Drawn
 * @typedef {{ kind: "counted", id: number, index: number, flips: number, attached: number[], count: number }} Counted
 * @typedef {{ kind: "followed", id: number, index: number, largest: number, squares: number, count: number,
 *   still: Uint8Array }} Followed
 * @typedef {Drawn | Counted | Followed} Reply
 * @typedef {(string | number | boolean)[]} Key
 */

// simulator/engine.js
/**
 * @typedef {{ postMessage(task: Task): void, terminate(): void }} Drawer a worker, or the page itself
 * @typedef {{ painted(reply: Drawn, by_page: boolean): void, drawn(state: State, replies: Drawn[], asked: number,
 *   by_page: boolean, is_whole: boolean): void, resting(state: State): number[] | null,
 *   counted(all: Counted[]): void, followed(all: Followed[]): void,
 *   failed(why: string): void }} Handlers
 */

// simulator/start.js
/**
 * @typedef {{ state(): State, set(changes: Partial<State>): void, change(changes: Partial<State>): void,
 *   replace(next: State): void, put(place: Partial<State>): void, move(by: number[]): void,
 *   zoom(steps: number, at?: number[]): void, to_pole(zoom: number): Partial<State> }} Act
 */

// simulator/presets.js
/**
 * @typedef {{ says: string, begin: Partial<State>, moves: string, seconds: number, from: number, to: number,
 *   still: number }} Experiment
 *   still: where the quantity is put at once, if the reader wants no motion
 */

// simulator/curve.js
/**
 * @typedef {{ eps: number, size: number }} LinePoint
 * @typedef {LinePoint & { max: number, still: Uint8Array }} PicturePoint the root mean square of a picture's difference, and the largest
 * @typedef {Record<string, LinePoint[]>} Lines
 * @typedef {ReturnType<typeof simulator_scale>["still"]} Still
 */

// simulator/loupe.js
/**
 * @typedef {{ name: string, step: number, at: number, h: number }} Sample of the height: how many ε away, and the places
 *   of the argument and of the height among what the kernel returns
 * @typedef {SimulatorData & { pairs: Record<string, Record<string, [Sample, Sample][]>> }} CloserData
 * @typedef {[look: string, end: number, of?: bigint]} Run of bits down to a place, of the row's number or of another
 * @typedef {[CloserData, ...WebAssembly.Module[]]} CloserParts what a module of both programs is made of
 */

// simulator/certified.js
/**
 * @typedef {{ key: string, parts: CloserParts, state: State, raster: Raster }} CertifiedTask
 * @typedef {{ key: string, maps: Uint8Array[], rms: number[], largest: number[], extremes: number[][],
 *   open: number }} CertifiedFound ends of the RMS and of the largest difference; each picture's largest and median bound
 */

// ideas/ideas.js
/**
 * @typedef {{ kernels: Record<string, [number, number]>, given: Record<string, number>,
 *   lines: Record<string, { inputs: string[], lines: string[] }>, balls: { beta: number,
 *   turn: number, tip: number, lamp: Point, away: number, ka: number } }} IdeasData
 * @typedef {SimulatorModule & { own: SimulatorModule }} IdeasModule with the interactives' own kernels
 * @typedef {{ data: IdeasData, program: string, module?: Promise<IdeasModule> }} IdeasParts
 * @typedef {SimulatorData & IdeasData} AllData
 * @typedef {(stage: ReturnType<typeof idea_stage>, module: IdeasModule, data: AllData) => (() => void) | null} Idea
 *   sets a stage; returns what draws on it, or null where the browser cannot
 * @typedef {{ label: string, range: { min: number, max: number, step: number, value: number },
 *   name(value: number): string, changes(value: number): Partial<SceneState>, eps(value: number): number,
 *   zoom(value: number): number, at: number, words(value: number, slopes: Float64Array): string }} Pitfall
 *   of one number: what it changes; where the middle is, in radii of A to the right of its own; slopes: h_v of what is seen
 * @typedef {{ clientX: number, clientY: number }} Place of a pointer, or between two
 * @typedef {(x: number, y: number, begins: boolean) => void} Moved is told of a place on a panel
 * @typedef {(right: number, up: number) => void} Stepped is told of arrow keys, ten times as far with shift
 */

// checker/kernel.js
/**
 * @typedef {Record<string, string>} PolynomialData {"x^2 y": "-3/2", "": "1"}: coefficients by their monomials
 * @typedef {[bigint, bigint]} Fraction numerator and denominator, in lowest terms, the denominator positive
 * @typedef {Map<string, Fraction>} Polynomial from words to coefficients other than 0: the word of x²y is "x x y", its
 *   names in a fixed order
 * @typedef {{ p: Polynomial, is: string }} Fact or goal: the polynomial p is = 0, ≠ 0, > 0 or ≥ 0
 * @typedef {Map<string, Polynomial>} Scope what each name stands for
 * @typedef {{ step?: string, is?: string, new?: string, of: PolynomialData }} Step
 * @typedef {{ kind: "derivation" | "refutation" | "induction" | "separation", variables?: string[], steps?: Step[],
 *   state?: string[], assume?: Step[], show?: PolynomialData[], lines?: [string, string[]][], outputs?: string[],
 *   avoid?: string[], [key: string]: any }} Statement
 * @typedef {{ point?: Record<string, string>, [key: string]: any }} Certificate
 * @typedef {{ identities: number, products: number, step: number }} Work
 * @typedef {{ accepted: boolean, reason?: string, residual?: PolynomialData, work: Work }} Verdict
 */

// checker/worker.js
/**
 * @typedef {Verdict & { time: number }} Answer with the milliseconds that it took
 * @typedef {ReturnType<typeof checking_clerk>} Clerk
 */

// checker/card.js
/**
 * @typedef {{ statement: Statement, certificate: Certificate }} Case
 * @typedef {{ theorem: string, claims: { claim: string, statements: Case[] }[] }} TheoremData
 * @typedef {Case & { name: string }} NamedCase
 */

// shared.js
/** @typedef {[number, number]} Point */

/**
 * The one file's pages.
 * @typedef {{ pages: HTMLElement[], shown(): Element, show(page: Element): void }} ChapterPages
 */

/**
 * Sphinx's search, and what it asks how much a page counts that it has found: name, title, anchor, description, score.
 * @typedef {{ title: Element | null, performSearch(query: string): void }} SphinxSearch
 * @typedef {new () => { stemWord(word: string): string }} SphinxStemmer
 * @typedef {{ score?(found: [string, string, string, string | null, number]): number }} SearchScorer
 */

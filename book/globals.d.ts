// What other scripts of the pages declare: those that the build prints, the mailed file's, and Sphinx's.
declare const Simulator: {
  data: SimulatorData;
  program: string;
  closer: Pick<CloserData, "kernels" | "pairs" | "scene_bounds"> & { program: string };
  running?: ReturnType<typeof simulator_start>;
};
declare const Ideas: { data: IdeasData; program: string; module?: Promise<IdeasModule> };
declare var Chapter: { pages: HTMLElement[]; shown(): Element; show(page: Element): void };
declare const SearchText: Record<string, [string, string][]>;
declare const SearchFormulas: Record<string, string>;
declare const Scorer: SearchScorer;
declare const Search: SphinxSearch;
declare class Stemmer {
  stemWord(word: string): string;
}
declare function splitQuery(query: string): string[];
declare function _escapeRegExp(text: string): string;

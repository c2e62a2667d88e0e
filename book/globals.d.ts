// What other scripts of the pages declare: those that the build prints, the mailed file's, and Sphinx's.
declare const Simulator: SimulatorParts;
declare const Ideas: IdeasParts;
declare var Chapter: ChapterPages;
declare const SearchText: Record<string, [string, string][]>;
declare const Scorer: SearchScorer;
declare const Search: SphinxSearch;
declare const Stemmer: SphinxStemmer;
declare function splitQuery(query: string): string[];
declare function _escapeRegExp(text: string): string;

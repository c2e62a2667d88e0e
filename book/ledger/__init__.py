"""The ledger: every claim of the chapter and of the seed, with its verdict and the evidence that a run has to bear out.

A claim is one `[[claim]]` table in any file of `book/ledger/claims/`:

    [[claim]]
    id = "flips_are_zero"                      # a-z, 0-9 and _; no other claim has it
    words = "Flips are zero by construction."  # the claim, in MyST: $mathematics$ and roles work
    where = "seed:s1.3"                        # a place of the seed (places.toml), or a page of the book: "s3"
    findings = ["F17"]                         # codes of findings.toml; may be left out
    verdict = "holds"                          # one of VERDICTS
    evidence = [
      { theorem = "bump_moves_no_boundary" },    # the last run must have given it the grade that it expects
      { number = "eps_table.flips", is = "== 0" },    # a figure's number, or "bench:NAME.key"
      { test = "verify/test_chambers.py::test_random_scenes" },     # must exist
      { source = "Blinn1978" },    # a key of references.bib
    ]
    so = "No pixel changed chamber in {number}`eps_table.frames` frames."     # one sentence: what is so, in MyST
    merit = "{number}`eps_table.flips` flips"  # the figure of merit; needed if a number is evidence

`holds with a condition` needs a `condition`, in MyST; `outside this chapter: not checked` needs a `reason` in place of
`so` and has no evidence. Relations are `== 0`, `!= 0`, `< 1e-12`, `<= 1`, `> 0`, `>= 2`, `in [0.45, 0.65]`.

A run refutes a claim by itself where it can: a number of the evidence may have `claimed`, the relation that the claim's
own words give it; where that does not hold, the number refutes the claim. A theorem refutes
if its grade is `refuted` (`refutes = false`: it is the claim's opposite that was refuted) or if the entry says
`refutes = true`; a test and a source if the entry says so. A claim that is `false` or `corrected` needs evidence that
refutes it, one that `holds` may have none.

Every theorem needs a claim that rests on it. Every clause of the seed, of four words or more, needs a claim at its
place that quotes four words of it in a row, or an entry in unclaimed.toml; tests/test_seed.py asks for it. `python -m
book.ledger` checks all else of this against the last run (the site's build does so too), prints what is wrong by entry
and field, and counts verdicts.

    from book.ledger.entries import load
    load().claims                 # (LedgerClaim, …), in the order of the files
"""

"""The one function that pytest-benchmark runs: a visit to a case. `python -m verify.benchmark` says which."""


def bench_case(benchmark, case):
    """Time the case's calls of this visit; one more before them warms the caches, unless a call is long."""
    benchmark.extra_info["case"] = case.name
    benchmark.pedantic(case.work, rounds=case.repeats, warmup_rounds=int(case.repeats > 1))

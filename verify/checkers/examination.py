"""What a run found about one theorem, and the grade on that evidence alone."""

from dataclasses import dataclass, field


@dataclass
class Examination:
    """What a run found about one theorem. `problems` name what is missing; `record` is what the report keeps."""

    id: str
    expected: str
    uses: tuple
    record: dict = field(default_factory=dict)
    problems: list = field(default_factory=list)
    mutants_killed: int = 0
    mutants: int = 0
    claims: int = 0
    by_definition: list = field(default_factory=list)  # claims that read 0 = 0
    argued: list = field(default_factory=list)  # clauses that no claim says
    reached: str = ""  # by measurement or citation; else the checkers' verdict stands

    @property
    def grade(self):
        """The grade on this theorem's own evidence; `final_grades` adds what it rests on."""
        if self.problems:
            return "failed"
        if self.argued:
            return "argued"
        if self.by_definition and len(self.by_definition) == self.claims:
            return "by definition"
        return self.reached or ("refuted" if self.expected == "refuted" else "proved")

"""The exercises' answers run alone, with NumPy and SymPy, and print what stands below them."""

import re

import pytest

from book.assembly import stamps

FOLDER = stamps.ROOT / "book" / "chapter" / "exercises"
SECTIONS = sorted(path.stem for path in FOLDER.glob("*.md"))
ANSWER = re.compile(r"^```python\n(?P<code>.*?)^```\n\n```text\n(?P<printed>.*?)^```$", re.MULTILINE | re.DOTALL)


def answers(section):
    """Return [(code, what the page says that it prints)] of a section's exercises."""
    text = (FOLDER / f"{section}.md").read_text("utf-8")
    return [(match["code"], match["printed"]) for match in ANSWER.finditer(text)]


@pytest.mark.parametrize("section", SECTIONS)
def test_answers_print_what_stands_below_them(section, capsys):
    for code, expected in answers(section):
        assert set(re.findall(r"^(?:from|import) (\w+)", code, re.MULTILINE)) <= {"math", "numpy", "sympy"}
        exec(code, {})
        assert capsys.readouterr().out == expected

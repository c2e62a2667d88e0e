"""Write what is printed from the formulas:  python -m renderer.generate"""

from pathlib import Path

from renderer.generate.kernels import kernels_source

KERNELS = Path(__file__).resolve().parents[1] / "kernels.py"

if __name__ == "__main__":
    source = kernels_source()
    KERNELS.write_text(source, encoding="utf-8")
    print(f"wrote {KERNELS.name}: {source.count(chr(10))} lines")

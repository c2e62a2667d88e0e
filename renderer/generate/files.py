"""The generated files, and what writes each."""

from pathlib import Path

from renderer.generate.javascript import javascript_source
from renderer.generate.lights import lights_source
from renderer.generate.shaders import shaders_source
from renderer.generate.source import array_kernels_source, kernels_source

RENDERER = Path(__file__).resolve().parents[1]

SIMULATOR = RENDERER.parent / "book" / "static" / "simulator"

GENERATED = {
    RENDERER / "kernels.py": kernels_source,
    RENDERER / "array_kernels.py": array_kernels_source,
    RENDERER / "lights.py": lights_source,
    RENDERER / "shaders.py": shaders_source,
    SIMULATOR / "kernels.js": javascript_source,
}
"""{path: the function that returns its text}"""

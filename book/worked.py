"""Small interactives: figures that a hand can move, and one with every line of a pixel, from its place to its colour.

:::{idea} slope_is_texture
:alt: what the still picture shows
:width: page

The caption. Everything is as for {chapter-figure}: the still picture is the figure of that name, and it stays where no
script runs and on paper. `static/ideas/slope_is_texture.js` draws in its place where one does.
:::

`{worked-pixel}` is an {idea} with the lines of a pixel. Their formulas are the program's own
(`book.programs.idea_kernels`), the values those of one pixel; the page's script puts in their place those of the pixel
that the reader picks.
"""

import math

from docutils import nodes
from sphinx.util.docutils import SphinxDirective
from sympy import Piecewise, Symbol, latex

from book.extension import printed_claims
from book.extension.elements import Nodes, Page, directive, filled, on_page
from book.extension.figures import OPTIONS, chapter_figure
from book.programs.idea_kernels import PIXEL, lines_at
from proofs.engine.half_turns import ordinary
from renderer import Scene, kernels

SHARED = ("simulator/compiled.js", "simulator/module.js", "ideas/compiled.js", "ideas/ideas.js")
SIZE, COLUMN, ROW = 256, 104, 92  # the picture, and the pixel whose values stand on paper
A, ON_A = "_on_a", ("cos_theta", "sin_phi", "u_closed", "v", "h_u", "h_v")  # names of what A alone has
LINES = (
    ("1. Where: the point, and the surface there", "", None),
    ("the point of the picture", "x y", None),
    ("the distance from the axis", "rho_raw", ()),
    ("negative if A is missed", "discriminant_a", ()),
    ("where the ray meets A", "t_a", ()),
    ("where it meets B", "t_b", ()),
    ("what is seen: 1 A, 2 B, 3 floor", "surface", None),
    ("the angles of the point", "cos_theta", ("rho_inverse",)),
    ("", "sin_phi", ("hit_scale",)),
    ("the chart, in half-turns", "u_closed", ()),
    ("", "v", ()),
    ("2. The bump: two slopes tilt the normal", "", None),
    ("the slopes", "h_u", ()),
    ("", "h_v", ()),
    ("tangent vector: x, y, z", "g_x_on_a g_y_on_a g_z_on_a", ()),
    ("the normal, tilted", "m_x_on_a m_y_on_a m_z_on_a", ()),
    ("its length", "m_length_on_a", ()),
    ("the perturbed normal", "bumped_x_on_a bumped_y_on_a bumped_z_on_a", ("m_scale_on_a",)),
    ("3. The light: what the tilted normal catches", "", None),
    ("towards the first light", "towards_x_0 towards_y_0 towards_z_0", ("to_light_x_0", "light_scale_0")),
    ("the cosine of the diffuse light", "mu_0", ()),
    ("the cosine of the highlight", "specular_base_0", ()),
    ("is the light hidden? 1: yes", "occluded_0", None),
    ("red, with the first light", "lit_red_0", ("diffuse_0", "shine_0", "specular_0")),
    ("the cosine of the second light", "mu_1", ()),
    ("is the light hidden? 1: yes", "occluded_1", None),
    ("red, green, blue, clipped", "rgb_red rgb_green rgb_blue", None),
)
"""Words about lines, their names, and the names written out in the formula of the first (None: it has none).

Without a name it is the head of a step.
"""
TEX = printed_claims.TEX | {
    "rho_raw": r"\rho", "discriminant_a": "d_A", "root_a": r"\sqrt{d_A}", "root_b": r"\sqrt{d_B}",
    "t_a": "t_A", "t_b": "t_B", "tangent_squared": r"(e^2 - R^2)", "toward_b": "b", "distance": "(e - C_z)",
    "u_closed": "u",
    "m_length": "|M|", "specular_base": "b", "halfway_length": r"|\omega + \hat v|",
    "light_distance": r"|L - P|", "red_before": r"\text{ambient}", "lit_red": r"\text{red}",
    "cos_u": "c_1", "sin_u": "s_1", "cos_v": "c_2", "sin_v": "s_2", "kd": "k_d", "ks": "k_s",
    "halfway_x": r"(\omega + \hat v)_x", "halfway_y": r"(\omega + \hat v)_y", "halfway_z": r"(\omega + \hat v)_z",
    "light_red": r"\text{colour}", "albedo_red": r"\text{albedo}",
    **{f"{name}_{axis}": f"{tex} {axis}}}" for axis in "xyz" for name, tex in
       (("g", "g_{"), ("m", "M_{"), ("e_phi", r"e_{\varphi"))},
}  # fmt: skip


def tex_of(symbol: Symbol) -> str:
    """Return a symbol of the program as TeX, without the surface or the light to which it belongs."""
    name = symbol.name.removesuffix(A).removesuffix("_0").removesuffix("_1").replace("light_0_", "light_")
    return TEX.get(name) or latex(Symbol(name))


def formula(name: str, written_out: tuple[str, ...]) -> str:
    """Return a line of the program as TeX: of cases, the first."""
    lines = {symbol.name: symbol for symbol, _ in PIXEL.definitions}
    expression = PIXEL.expand(lines[name], until={s for n, s in lines.items() if n not in (*written_out, name)})
    expression = ordinary(expression.replace(lambda part: isinstance(part, Piecewise), lambda part: part.args[0].expr))
    shown = latex(expression, symbol_names={symbol: tex_of(symbol) for symbol in expression.free_symbols})
    return f"{tex_of(lines[name])} = {shown}"


def number_text(number: float) -> str:
    """Return a number as the page's script says it."""
    if not math.isfinite(number):
        return "—"
    text = f"{number:.4f}" if number % 1 else f"{number:.0f}"
    return (text.removeprefix("-") if float(text) == 0 else text).replace("-", "−")


def values(scene: Scene) -> dict[str, float]:
    """Return every line of the pixel that stands on paper."""
    half = kernels.image_extent(scene.eye, scene.radius)
    place = {"x": kernels.image_x(COLUMN, SIZE, SIZE, half), "y": kernels.image_y(ROW, SIZE, half)}
    return place | lines_at(scene, **place)


def worked_lines() -> list[dict]:
    numbers, rows = values(Scene()), []
    for words, line, written_out in LINES:
        names = line.split()
        rows.append({
            "step": "" if names else words,
            "words": words,
            "formula": [] if written_out is None else [nodes.math("", formula(names[0], written_out))],
            "names": names,
            "on_a": any(name.endswith(A) or name in ON_A for name in names),
            "outputs": [(name, number_text(numbers[name])) for name in names],
        })  # fmt: skip
    return rows


@directive("worked-pixel", arguments=1, content=True, **OPTIONS)
def worked_pixel(here: SphinxDirective) -> Nodes:
    """Return an {idea} with the lines of a pixel under its picture."""
    (figure,) = idea(here)
    figure["classes"].append("idea-worked")
    figure.insert(1, filled("worked", lines=worked_lines()))
    return [figure]


@directive("idea", arguments=1, content=True, **OPTIONS)
def idea(here: SphinxDirective) -> Nodes:
    """Return a figure with a script that replaces its picture."""
    (figure,) = chapter_figure(here)
    figure["classes"].append("idea")
    figure["idea"] = here.arguments[0]
    return [figure]


@on_page
def load_scripts(page: Page) -> None:
    """Let a page with interactives load what they need, each file once."""
    figures = page.doctree.findall(nodes.figure) if page.doctree else ()
    if scripts := [f"ideas/{figure['idea']}.js" for figure in figures if "idea" in figure]:
        page.load(*SHARED, *scripts, style="ideas/ideas.css")

"""Pictures by Matplotlib, with the colours, dashes and names of the report."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from truearea import _native

if TYPE_CHECKING:
    from matplotlib.axes import Axes

HOLE_COLOUR = "0.85"
"""Grey of the holes of a spectrum."""


def axes_of(ax: Axes | None) -> Axes:
    """The axes to draw in, new ones where none are given."""
    try:
        import matplotlib.pyplot as plt
    except ModuleNotFoundError:
        raise ImportError("plot needs Matplotlib, which is not here: pip install truearea[plot]") from None
    return plt.subplots(layout="constrained")[1] if ax is None else ax


def style_of(model: str) -> dict[str, Any]:
    """Label, colour and dashes of a model, as keywords of Matplotlib."""
    short_name, colour, dash = _native.model_style(model)
    dashes = tuple(float(length) for length in dash.split())
    return {"label": short_name, "color": colour, "linestyle": (0, dashes or None)}

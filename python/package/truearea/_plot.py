"""Axes of Matplotlib, with the colours, dashes and names of the report."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from truearea import _native
from truearea._results import FloatArray, needed

if TYPE_CHECKING:
    from matplotlib.axes import Axes

HOLE_COLOUR = "0.85"
"""Grey of the holes of a spectrum."""


def axes_of(ax: Axes | None) -> Axes:
    """The axes to draw in, new ones where none are given."""
    plt = needed("matplotlib.pyplot", "plot", "plot")
    return plt.subplots(layout="constrained")[1] if ax is None else ax


def set_axes(ax: Axes, x: str, y: str, scale: str = "log") -> None:
    """Axes for two columns, long wavelengths on the left."""
    ax.set_xscale(scale)
    ax.set_yscale(scale)
    ax.set_xlabel(_native.axis_label(x))
    ax.set_ylabel(_native.axis_label(y))
    if x in ("wavelength_m", "scale_m") and not ax.xaxis_inverted():
        ax.invert_xaxis()


def draw_map(
    ax: Axes, values: FloatArray, size_m: tuple[float, ...] | None, label: str, colour_of_none: str
) -> Axes:
    """Draw values point by point, the first row at the top as instruments show it, with a scale beside them."""
    import matplotlib as mpl

    colours = mpl.colormaps["viridis"].with_extremes(bad=colour_of_none)
    extent = None if size_m is None else (0.0, size_m[0], size_m[-1], 0.0)
    picture = ax.imshow(values, cmap=colours, origin="upper", extent=extent, interpolation="nearest")
    ax.set_xlabel("x (points)" if size_m is None else "x (m)")
    ax.set_ylabel("y (points)" if size_m is None else "y (m)")
    ax.get_figure().colorbar(picture, ax=ax, label=label)  # type: ignore[union-attr]
    return ax


def draw_answer(ax: Axes, shortest_m: float, area: Mapping[str, Any]) -> None:
    """Draw an area with its range, that of boundary elements where they pressed the surface."""
    middle = float(area["area_fraction"])
    by_elements = "elements" in area["source"]
    label = "boundary elements" if by_elements else "answer"
    low, high = area.get("low"), area.get("high")
    if low is None or high is None:
        ax.plot([shortest_m], [middle], "o", color="black", label=label)
    else:
        ends = [[max(middle - low, 0.0)], [max(high - middle, 0.0)]]
        ax.errorbar([shortest_m], [middle], yerr=ends, fmt="o", color="black", capsize=3, label=label)


def style_of(model: str) -> dict[str, Any]:
    """Label, colour and dashes of a model, as keywords of Matplotlib."""
    return style_from(*_native.model_style(model))


def style_from(short_name: str, colour: str, dash: str) -> dict[str, Any]:
    """Keywords of Matplotlib for a name, a colour, and dashes as SVG has them."""
    dashes = tuple(float(length) for length in dash.split())
    return {"label": short_name, "color": colour, "linestyle": (0, dashes or None)}

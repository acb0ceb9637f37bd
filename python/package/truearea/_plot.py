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
    """Axes for two columns, with lengths and pressures in units of a few digits and areas in percent."""
    from matplotlib.ticker import EngFormatter, LogFormatterSciNotation

    class Minor(LogFormatterSciNotation):
        """Labels that ticks have in short decades, in the words of the others."""

        def __call__(self, value: float, pos: Any = None) -> str:
            return str(self.axis.get_major_formatter()(value)) if super().__call__(value, pos) else ""  # type: ignore[union-attr]

    ax.set_xscale(scale)
    ax.set_yscale(scale)
    for axis, column in ((ax.xaxis, x), (ax.yaxis, y)):
        label, _, unit = _native.axis_label(column).removesuffix(")").partition(" (")
        if unit in ("m", "Pa"):
            axis.set_major_formatter(EngFormatter(unit))
        elif column == "area_fraction":
            axis.set_major_formatter(lambda share, _: f"{100.0 * share:.3g} %")
        else:
            label = _native.axis_label(column)
        if scale == "log" and unit in ("m", "Pa", ""):
            axis.set_minor_formatter(Minor())
        axis.set_label_text(label)


def draw_map(
    ax: Axes, values: FloatArray, size_m: tuple[float, ...], label: str, unit: str, colour_of_none: str
) -> Axes:
    """Draw values point by point, the first row at the top as instruments show it, with a scale beside them."""
    import matplotlib as mpl
    from matplotlib.ticker import EngFormatter

    colours = mpl.colormaps["viridis"].with_extremes(bad=colour_of_none)
    extent = (0.0, size_m[0], size_m[-1], 0.0)
    picture = ax.imshow(values, cmap=colours, origin="upper", extent=extent, interpolation="nearest")
    for axis, name in ((ax.xaxis, "x"), (ax.yaxis, "y")):
        axis.set_major_formatter(EngFormatter("m"))
        axis.set_label_text(name)
    ax.get_figure().colorbar(picture, ax=ax, label=label, format=EngFormatter(unit))  # type: ignore[union-attr]
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
    return style_from(*_native.model_style(model)) if model in _native.models_table()["model"] else {"label": model}


def style_from(short_name: str, colour: str, dash: str) -> dict[str, Any]:
    """Keywords of Matplotlib for a name, a colour, and dashes as SVG has them."""
    dashes = tuple(float(length) for length in dash.split())
    return {"label": short_name, "color": colour, "linestyle": (0, dashes or None)}

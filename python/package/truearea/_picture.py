"""Pictures of results, described once: drawn by Matplotlib on request, and by the core in notebooks."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from truearea import _native
from truearea._results import AnyArray, FloatArray

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Trace(NamedTuple):
    """Points in order, with the model that sets their colour and the place of their load; a label of None is not drawn."""

    x: FloatArray
    y: FloatArray
    label: str | None = ""
    model: str = ""
    condition: int | None = None


class Band(NamedTuple):
    """The stretch between two lines."""

    x: FloatArray
    low: FloatArray
    high: FloatArray
    label: str = ""
    model: str = ""


class Picture(NamedTuple):
    """Lines over axes, which are columns: ``axis_label`` of the core has their labels."""

    title: str
    x: str
    y: str
    lines: tuple[Trace, ...]
    bands: tuple[Band, ...] = ()
    holes: tuple[tuple[float, float], ...] = ()
    marker: str = ""
    is_linear: bool = False
    """Linear axes; logarithmic ones draw what is above 0."""

    def svg(self) -> str:
        """The picture as the core draws it."""
        lines = [(_column(of.x), _column(of.y), of.label or "", of.model, of.condition) for of in self.lines]
        bands = [(_column(of.x), _column(of.low), _column(of.high), of.label) for of in self.bands]
        return _native.figure_svg(self.title, self.x, self.y, lines, bands, list(self.holes), self.is_linear)

    def draw(self, ax: Axes) -> Axes:
        """Draw into axes of Matplotlib."""
        from truearea._plot import HOLE_COLOUR, set_axes, style_of

        set_axes(ax, self.x, self.y, "linear" if self.is_linear else "log")
        for first, last in self.holes:
            ax.axvspan(first, last, color=HOLE_COLOUR, linewidth=0)
        loads = 1 + max((line.condition or 0 for line in self.lines), default=0)
        for line in self.lines:
            style = style_of(line.model) if line.model else {}
            parts = (style.get("label", ""), line.label)
            label = "_" if line.label is None else ", ".join(part for part in parts if part)
            # The lower the load, the paler the line.
            shade = 1.0 - 0.6 * (loads - 1 - (line.condition or 0)) / loads
            ax.plot(line.x, line.y, **{**style, "label": label, "alpha": shade, "marker": self.marker or None})
        for band in self.bands:
            style = style_of(band.model) if band.model else {}
            label = ", ".join(part for part in (style.get("label", ""), band.label) if part)
            ax.fill_between(band.x, band.low, band.high, color=style.get("color"), alpha=0.3, label=label)
        is_several = len(self.lines) + len(self.bands) > 1 or any(line.label for line in self.lines)
        if is_several and ax.get_legend_handles_labels()[0]:
            ax.legend(loc="best", fontsize="small")
        return ax


def _column(values: AnyArray) -> FloatArray:
    return np.asarray(values, dtype=np.float64).reshape(-1)


class Drawn:
    """A result with a picture: drawn by ``plot``, and above the table that a notebook shows."""

    __slots__ = ()

    def _picture(self) -> Picture:
        raise NotImplementedError

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draw it over logarithmic axes, in the colours and with the names of reports.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            The axes to draw in; new ones where left out.

        Returns
        -------
        matplotlib.axes.Axes

        Raises
        ------
        ImportError
            Without Matplotlib; ``pip install truearea[plot]`` adds it.
        """
        from truearea._plot import axes_of

        return self._picture().draw(axes_of(ax))

    def _drawing(self) -> str:
        return self._picture().svg()


def load_label(pressure_pa: float) -> str:
    """A nominal pressure in words."""
    return "a separation" if np.isnan(pressure_pa) else _native.pressure_in_words(pressure_pa)


def lines_by_load(x: AnyArray, ys: AnyArray, pressures_pa: AnyArray, model: str = "") -> tuple[Trace, ...]:
    """A line for each load, along an abscissa that they share."""
    return tuple(
        Trace(x, ys[at], load_label(float(pressure_pa)), model, at) for at, pressure_pa in enumerate(pressures_pa)
    )

"""Pictures of results, described once: drawn by Matplotlib on request, and by the core in notebooks."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from truearea import _native
from truearea._results import AnyArray, FloatArray

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Trace(NamedTuple):
    """Points in order, with the model that sets their colour and the place of their load."""

    x: FloatArray
    y: FloatArray
    label: str = ""
    model: str = ""
    condition: int | None = None


class Band(NamedTuple):
    """The stretch between two lines."""

    x: FloatArray
    low: FloatArray
    high: FloatArray
    model: str = ""
    condition: int | None = None


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
        lines = [(_column(of.x), _column(of.y), of.label, of.model, of.condition) for of in self.lines]
        bands = [(_column(of.x), _column(of.low), _column(of.high), _INTERVAL, of.model) for of in self.bands]
        return _native.figure_svg(self.title, self.x, self.y, lines, bands, list(self.holes), self.is_linear)

    def draw(self, ax: Axes) -> Axes:
        """Draw into axes of Matplotlib."""
        from truearea._plot import HOLE_COLOUR, set_axes, style_of

        set_axes(ax, self.x, self.y, "linear" if self.is_linear else "log")
        for first, last in self.holes:
            ax.axvspan(first, last, color=HOLE_COLOUR, linewidth=0)
        loads = 1 + max((line.condition or 0 for line in self.lines), default=0)
        # The lower the load, the paler are line and band.
        shades = [1.0 - 0.6 * (loads - 1 - at) / loads for at in range(loads)]
        for line in self.lines:
            style = style_of(line.model) if line.model else {}
            label = ", ".join(part for part in (style.get("label", ""), line.label) if part)
            x, y = np.asarray(line.x), np.asarray(line.y)
            for shortest, longest in self.holes:
                ends = 1 + np.flatnonzero((x[:-1] >= longest) & (x[1:] <= shortest))
                x, y = np.insert(x, ends, np.nan), np.insert(y, ends, np.nan)
            look = {"label": label, "alpha": shades[line.condition or 0], "marker": self.marker or None}
            ax.plot(x, y, **{**style, **look})
        for band in self.bands:
            colour = style_of(band.model)["color"] if band.model else None
            ax.fill_between(band.x, band.low, band.high, color=colour, alpha=0.3 * shades[band.condition or 0], linewidth=0)
        drawn = ax.get_legend_handles_labels()[0]
        if len(drawn) > 1 or any(line.label for line in self.lines):
            ax.legend(loc="best", fontsize="small")
        return ax


def _column(values: AnyArray) -> FloatArray:
    return np.asarray(values, dtype=np.float64).reshape(-1)


class Drawn:
    """A result with a picture: drawn by ``plot``, and above the table that a notebook shows."""

    __slots__ = ()

    def _picture(self) -> Picture:
        raise NotImplementedError

    def _draw(self, ax: Axes) -> Axes:
        return self._picture().draw(ax)

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draw it in the colours and with the names of reports: a map of heights or of the last pressures point by point.

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

        return self._draw(axes_of(ax))

    def _drawing(self) -> str:
        return self._picture().svg()


_INTERVAL = "interval"


def load_label(pressure_pa: float, separation_m: float = np.nan) -> str:
    """A nominal pressure in words, or the separation that is held in its place."""
    return f"separation {1e9 * separation_m:.3g} nm" if np.isnan(pressure_pa) else _native.pressure_in_words(pressure_pa)

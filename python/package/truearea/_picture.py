"""Pictures of results, described once: drawn by Matplotlib where one asks, and by the core in notebooks."""

from __future__ import annotations

import base64
import struct
import zlib
from html import escape
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from truearea import _native
from truearea._results import AnyArray, FloatArray

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Trace(NamedTuple):
    """Points in order, the model that their colour is of, and the place of their load among others; None is no label."""

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
    """Lines over logarithmic axes, which are columns: ``axis_label`` of the core has their labels."""

    title: str
    x: str
    y: str
    lines: tuple[Trace, ...]
    bands: tuple[Band, ...] = ()
    holes: tuple[tuple[float, float], ...] = ()
    marker: str = ""
    is_linear: bool = False
    """Linear axes in Matplotlib; the core draws what is above 0 over logarithmic ones."""

    def svg(self) -> str:
        """The picture as the core draws it."""
        lines = []
        for line in self.lines:
            x, y = _positive(line.x, line.y)
            lines.append((x, y, line.label or "", line.model, line.condition))
        bands = []
        for band in self.bands:
            x, low, high = _positive(band.x, band.low, band.high)
            bands.append((x, low, high, band.label))
        if not any(len(x) for x in [line[0] for line in lines] + [band[0] for band in bands]):
            return f"<p>{escape(self.title)}: nothing of it is above 0</p>"
        return _native.figure_svg(self.title, self.x, self.y, lines, bands, list(self.holes))

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


def _positive(x: FloatArray, *ys: FloatArray) -> tuple[FloatArray, ...]:
    """The points that have a place on logarithmic axes."""
    columns = [np.asarray(column, dtype=np.float64).reshape(-1) for column in (x, *ys)]
    has_place = np.logical_and.reduce([np.isfinite(column) & (column > 0.0) for column in columns])
    return tuple(np.ascontiguousarray(column[has_place]) for column in columns)


class Drawn:
    """What has a picture: drawn by ``plot``, and above the table that a notebook shows."""

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


def within_frame(svg: str, place: tuple[float, float, float, float], columns: int, colours: bytes) -> str:
    """An SVG document with points as an image in it: red, green and blue of each, row by row from the top."""
    left, top, width, height = place
    image = (
        f'<image x="{left}" y="{top}" width="{width}" height="{height}" preserveAspectRatio="none" '
        f'style="image-rendering:pixelated" href="data:image/png;base64,{base64.b64encode(_png(columns, colours)).decode()}"/>'
        "\n</svg>"
    )
    return svg.replace("</svg>", image)


def _png(columns: int, colours: bytes) -> bytes:
    row = 3 * columns
    # Each row begins with the filter that it is stored with: none.
    rows = b"".join(b"\0" + colours[at : at + row] for at in range(0, len(colours), row))
    header = struct.pack(">IIBBBBB", columns, len(colours) // row, 8, 2, 0, 0, 0)
    chunks = (_chunk(b"IHDR", header), _chunk(b"IDAT", zlib.compress(rows)), _chunk(b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunks)


def _chunk(kind: bytes, content: bytes) -> bytes:
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

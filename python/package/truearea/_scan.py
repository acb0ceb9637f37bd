"""Heights as instruments measure them."""

from __future__ import annotations

import os
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Union

import numpy as np

from truearea import _native
from truearea._choices import Direction, Gaps
from truearea._material import Quantity
from truearea._options import documented
from truearea._picture import Drawn
from truearea._results import AnyArray, Fact, FloatArray, Table, notes_html, rows_html

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Options = dict[str, "tuple[str, Any]"]
"""Metadata of a scan besides its file: values by kind, each with the name of its argument."""

AnyPath = Union[str, "os.PathLike[str]"]


class ScanChannels(Table):
    """Channels of files of instruments, a row for each."""

    _title = "channels"
    __slots__ = ()
    file: AnyArray
    format: AnyArray
    channel: AnyArray
    points_x: FloatArray
    points_y: FloatArray
    size_x_m: FloatArray
    size_y_m: FloatArray
    rms_height_m: FloatArray
    peak_to_valley_m: FloatArray
    gaps: FloatArray
    rms_slope_x: FloatArray
    rms_slope_y: FloatArray
    note: AnyArray


class File(NamedTuple):
    """A file that was read, with the metadata files beside it."""

    name: str
    files: dict[str, bytes]


class Scan(Drawn):
    """Heights along a line or of a map, with the metadata of their file. ``read_scan`` makes one."""

    __slots__ = ("_facts", "_heights", "_native", "_recipe")

    def __init__(self) -> None:
        raise TypeError("a Scan is made by read_scan")

    @classmethod
    def _of(cls, file: File, options: Options) -> Scan:
        scan = cls.__new__(cls)
        scan._set(_native.Scan.of_file(file.name, file.files, options), (file, options))
        return scan

    def _set(self, native: _native.Scan, recipe: tuple[File, Options]) -> None:
        self._native, self._facts = native, native.facts
        # A scan is pickled as the bytes that it was read from.
        self._recipe = recipe
        self._heights: FloatArray | None = None

    @property
    def heights_m(self) -> FloatArray:
        """Heights [m], shape (rows, columns) or (points,), masked where there are gaps; not to be written to."""
        if self._heights is None:
            heights_m, gaps = self._native.heights()
            heights_m.flags.writeable = False
            self._heights = heights_m if gaps is None else np.ma.masked_array(heights_m, mask=gaps)
        return self._heights

    size_m = Fact[tuple[float, ...]]("Size [m]: (lx, ly) of a map, (lx,) of a line; so many spacings as there are points.")
    spacing_m = Fact[tuple[float, ...]]("Distances [m] of neighbouring points along x and y; the mean where they are uneven.")
    positions_m = Fact["FloatArray | None"]("Positions [m] of the points of an unevenly spaced line; None of any other scan.")
    name = Fact[str]("The name of the measurement, from its file or the metadata beside it.")
    format = Fact[str]("The format of its file.")
    channel = Fact["str | None"]("The channel that was read, where the file names it.")
    channels = Fact[tuple[str, ...]]("The channels with heights that the file offers.")
    is_periodic = Fact[bool]("True if the file says that the heights are periodic.")
    tip_radius_m = Fact["float | None"]("The radius [m] of the tip, where the file says it.")
    sha256 = Fact[str]("The SHA-256 of the file, in hexadecimal digits.")
    notes = Fact[tuple[str, ...]]("Assumptions of reading.")

    def _draw(self, ax: Axes) -> Axes:
        from matplotlib.ticker import EngFormatter

        from truearea._plot import draw_map

        heights_m = np.asarray(self) - np.nanmin(self)
        label = "height above the lowest point"
        if heights_m.ndim == 2:
            return draw_map(ax, heights_m, self.size_m, label, "m", "0.6")
        along_m = np.arange(heights_m.size) * self.spacing_m[0] if self.positions_m is None else self.positions_m
        ax.plot(along_m, heights_m, linewidth=0.8, label=self.name)
        for axis, name in ((ax.xaxis, "position"), (ax.yaxis, label)):
            axis.set_major_formatter(EngFormatter("m"))
            axis.set_label_text(name)
        return ax

    def summary(self) -> ScanChannels:
        """Points, size, rms height, peak to valley, gaps and rms slopes, in one row, as ``truearea scan`` prints it."""
        return ScanChannels._of(self._native.summary(), self.notes)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> FloatArray:
        """The heights [m], NaN where there are gaps."""
        heights_m = self.heights_m
        filled = heights_m.filled(np.nan) if isinstance(heights_m, np.ma.MaskedArray) else heights_m
        return np.array(filled, dtype=dtype, copy=True) if copy else np.asarray(filled, dtype=dtype)

    def __reduce__(self) -> tuple[Any, ...]:
        return (Scan._of, self._recipe)

    def __eq__(self, other: object) -> bool:
        return self._recipe == other._recipe if isinstance(other, Scan) else NotImplemented

    def __hash__(self) -> int:
        return hash(self.sha256)

    def __repr__(self) -> str:
        points = " x ".join(str(count) for count in self.heights_m.shape)
        size = " x ".join(f"{length:.4g} m" for length in self.size_m)
        return f"Scan({self.name!r}, {self.format}, {points} points, {size})"

    def _repr_html_(self) -> str:
        picture = self._native.picture()
        if picture is None:
            return f"<p>{escape(self.name)}: no point has a height</p>"
        rows = {
            "format": self.format,
            "points": " × ".join(str(count) for count in self.heights_m.shape),
            "size": " × ".join(f"{length:.4g} m" for length in self.size_m),
            "rms height": f"{self.summary().rms_height_m[0]:.4g} m",
        }
        return f"<div>{picture}{rows_html(rows)}{notes_html(self.notes)}</div>"


def read_scan(
    path: AnyPath,
    *,
    unit: str | None = None,
    height_unit: str | None = None,
    channel: str | None = None,
    measurement: str | None = None,
    size: Quantity | None = None,
    tip_radius: Quantity | None = None,
    shortest: Quantity | None = None,
    gaps: Gaps | None = None,
    direction: Direction | None = None,
) -> Scan:
    """Read the heights in a file, of some thirty-five kinds of instruments and programs.

    Parameters
    ----------
    path : str or path-like
        The file. A ``meta.yml`` or ``index.json`` beside it that names it is read as well.
    unit : str, optional
        Unit of lengths and heights, such as ``"nm"``, if neither the file nor the metadata beside it state one.
    height_unit : str, optional
        Unit of heights where it is another, such as ``"um"`` beside ``unit="mm"``.
    channel : str, optional
        The channel; the first one of heights where left out.
    measurement : str, optional
        Which measurement of a container that has several.
    size : float or str, optional
        Length along the scan lines, in m or as text, where the file gives none.
    tip_radius, shortest : float or str, optional
        Radius of the tip (or ``"auto"``), and the shortest wavelength that is trusted, for spectra that are made of it.
    gaps : {"harmonic", "lines", "refuse"}, optional
        What becomes of points without a height in spectra.
    direction : {"x", "y", "both"}, optional
        Along which axis of a map its spectrum is taken.

    Returns
    -------
    Scan

    Raises
    ------
    FileNotFoundError
        If the file does not exist.
    InputError
        With file, place, value and bound for what cannot be read, and the argument that mends it.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> import numpy as np
    >>> import truearea as ta
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "scan.npy"
    >>> np.save(path, np.arange(12.0).reshape(3, 4))
    >>> scan = ta.read_scan(path, unit="nm", size="4 um")
    >>> scan.heights_m.shape, scan.size_m
    ((3, 4), (4e-06, 3e-06))
    """
    options = {
        "unit": unit,
        "height_unit": height_unit,
        "channel": channel,
        "measurement": measurement,
        "size": size,
        "tip_radius": tip_radius,
        "shortest": shortest,
        "gaps": gaps,
        "direction": direction,
    }
    return Scan._of(file_of(path), given(options))


@documented
def scan_channels(
    path: AnyPath,
    *,
    unit: str | None = None,
    height_unit: str | None = None,
    channel: str | None = None,
    size: Quantity | None = None,
    all_channels: bool = False,
) -> ScanChannels:
    """Lists the contents of a file of an instrument: a row for each channel of heights, as ``truearea scan`` does.

    Parameters
    ----------
    path : str or path-like
        The file.
    unit, height_unit, channel, size : optional
        As for ``read_scan``.
    all_channels : bool, default False
        Every channel, whatever it measures.

    Raises
    ------
    FileNotFoundError
        If the file does not exist.
    InputError
        Where no channel can be read.
    """
    file = file_of(path)
    options = given({"unit": unit, "height_unit": height_unit, "channel": channel, "size": size})
    return ScanChannels._of(_native.channels_of(file.name, file.files, options, _native.truth("all_channels", all_channels)))


def file_of(path: AnyPath) -> File:
    """Reads a file, and those beside it that may describe it."""
    file = Path(path)
    files = {str(file): file.read_bytes()}
    beside = (file.with_name(name) for name in _native.METADATA_FILES if name != file.name)
    files.update((str(other), other.read_bytes()) for other in beside if other.is_file())
    return File(str(file), files)


def given(options: dict[str, Any]) -> Options:
    """Returns the options that are given, by the names of their arguments."""
    return {name: (name, value) for name, value in options.items() if value is not None}

"""From heights to one spectrum: files, scans that were read, arrays and topographies, alone or together."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any, NamedTuple, Union

import numpy as np
import numpy.typing as npt

from truearea import _native
from truearea._arrays import each, lengths_of, metres
from truearea._choices import Average, Detrend, Direction, Gaps, Window
from truearea._material import Quantity
from truearea._native import InputError
from truearea._results import FloatArray
from truearea._scan import File, Options, Scan, file_of
from truearea._spectrum import Spectrum
from truearea._topography import heights_and_size, is_topography

Each = Union[Quantity, Sequence[Union[Quantity, None]], None]
"""One value for all scans, or a list with one, or None, for each."""

# What a file may leave open; it says nothing of heights that are there.
_OF_FILES = ("unit", "height_unit", "channel", "measurement", "size")


class Heights(NamedTuple):
    """Heights of an array."""

    argument: str
    name: str
    heights_m: FloatArray
    gaps: npt.NDArray[np.bool_] | None
    size: tuple[str, list[Any]]
    is_periodic: bool

    def kept(self) -> Heights:
        """Arrays of its own, for pickling: what their owner writes into his later does not count."""
        return self._replace(heights_m=self.heights_m.copy(), gaps=None if self.gaps is None else self.gaps.copy())


Part = Union[File, Scan, Heights]


def composite(
    scans: Sequence[Any],
    *,
    tip_radius: Each = None,
    shortest: Each = None,
    instrument: str | Sequence[str | None] | None = None,
    z_calibration: Each = None,
    slope_uncertainty: Each = None,
    gaps: Gaps | Sequence[Gaps | None] | None = None,
    direction: Direction | Sequence[Direction | None] | None = None,
    unit: str | Sequence[str | None] | None = None,
    height_unit: str | Sequence[str | None] | None = None,
    channel: str | Sequence[str | None] | None = None,
    size: Each = None,
    detrend: Detrend | None = None,
    window: Window | None = None,
    average: Average | None = None,
    bins_per_decade: int | None = None,
    name: str | None = None,
) -> Spectrum:
    """Make one spectrum of scans, each used at the wavelengths at which it can be trusted.

    What is said of scans may be one value for all, or a list with one for each, None where there is nothing to say.

    Parameters
    ----------
    scans : sequence
        Each a path, a ``Scan``, a pair ``(heights, size)`` of an array in m and its size as in ``Spectrum.from_heights``, or an
        object of SurfaceTopography.
    tip_radius : float or str, optional
        Radius of the tip, in m or as text, ``"auto"`` for what a file speaks of, or ``"none"`` for heights that no tip touched.
        One value counts for scans whose files tell no other; those of a list count before the files.
    shortest : float or str, optional
        The shortest wavelength that is trusted.
    instrument : str, optional
        Scans of one name are of one instrument; guessed from format and maker where left out.
    z_calibration : float or str, optional
        One standard uncertainty of the height scale of the instrument, as a share: ``0.03`` or ``"3 %"``.
    slope_uncertainty : float, optional
        One standard uncertainty of the exponent of its spectrum.
    gaps : {"harmonic", "lines", "refuse"}, optional
        What becomes of points without a height: filled by the harmonic surface through the points around them (by default, up to
        20 %), left out with their lines, or refused.
    direction : {"x", "y", "both"}, optional
        Along which axis of maps spectra are taken: rows where left out.
    unit, height_unit, channel, size : optional
        What files do not say themselves, as for ``read_scan``.
    detrend : {"plane", "line", "mean", "none"}, optional
        What is subtracted; the mean of periodic heights, else a plane, where left out.
    window : {"hann", "none"}, optional
        None for periodic heights, else Hann, where left out.
    average : {"log-unbiased", "log", "arithmetic"}, optional
        How scans are averaged that share a bin.
    bins_per_decade : int, optional
        Logarithmic bins per decade of wavevectors; 10 where left out.
    name : str, optional
        What the spectrum is called; the names of the scans where left out.

    Returns
    -------
    Spectrum
        With the checks of every scan in ``notes``, a row for each in ``scans``, and the files with their SHA-256 in ``remarks``.
        It keeps what ``uncertainty`` needs.

    Raises
    ------
    FileNotFoundError
        Where a file is not there.
    InputError
        With the scan, and place, value and bound where they are to blame.

    Examples
    --------
    >>> import numpy as np
    >>> import truearea as ta
    >>> rng = np.random.default_rng(1)
    >>> maps = [(1e-9 * rng.standard_normal((64, 64)).cumsum(1), "1 um") for _ in range(3)]
    >>> spectrum = ta.composite(maps, instrument="AFM", z_calibration="3 %")
    >>> spectrum.scans.verdict.shape
    (3,)
    """
    parts = [_part(f"scans[{at}]", one) for at, one in enumerate(_listed(scans))]
    of_all: dict[str, Any] = {
        "detrend": detrend,
        "window": window,
        "average": average,
        "bins_per_decade": bins_per_decade,
    }
    options: list[Options] = [{} for _ in parts]
    if _is_common(tip_radius):
        of_all["tip_radius"] = tip_radius
        tip_radius = None
    said = {
        "tip_radius": tip_radius,
        "shortest": shortest,
        "instrument": instrument,
        "z_calibration": z_calibration,
        "slope_uncertainty": slope_uncertainty,
        "gaps": gaps,
        "direction": direction,
        "unit": unit,
        "height_unit": height_unit,
        "channel": channel,
        "size": size,
    }
    for argument, value in said.items():
        _say(options, parts, argument, value)
    return _of_parts(parts, options, of_all, _name(parts) if name is None else name, "scans")


def spectrum_of_heights(
    heights: Any, size: Any, periodic: bool | None, options: dict[str, Any], of_all: dict[str, Any], name: str
) -> Spectrum:
    """The spectrum of one array or topography."""
    part: Part
    if isinstance(heights, Scan):
        if size is not None or periodic is not None:
            raise InputError("h is a Scan, which has its size and whether it is periodic; leave out size and periodic")
        part = heights
    else:
        part = heights_of("h", "size", name, heights, size, periodic).kept()
    said: Options = {key: (key, value) for key, value in options.items() if value is not None}
    return _of_parts([part], [said], of_all, name, "")


def _of_parts(
    parts: list[Part], options: list[Options], of_all: dict[str, Any], name: str, argument: str
) -> Spectrum:
    native = _native.composite(name, list(zip(parts, options)), of_all, argument)
    return Spectrum._of(native, _of_parts, parts, options, of_all, name, argument)


def _listed(scans: Any) -> list[Any]:
    if isinstance(scans, (str, os.PathLike, Scan)) or is_topography(scans):
        return [scans]
    if isinstance(scans, np.ndarray) or not isinstance(scans, Sequence):
        raise InputError(
            "scans: a list is needed of paths, scans, pairs (heights, size) or topographies, and this is of type "
            f"{type(scans).__name__}"
        )
    if not scans:
        raise InputError("scans: it is empty; give at least one")
    return list(scans)


def _part(argument: str, given: Any) -> Part:
    if isinstance(given, (str, os.PathLike)):
        return file_of(given)
    if isinstance(given, Scan):
        return given
    if is_topography(given):
        return heights_of(argument, argument, argument, given, None, None).kept()
    if isinstance(given, tuple) and len(given) == 2:
        heights, size = given
        return heights_of(argument, f"{argument}[1]", argument, heights, size, None).kept()
    raise InputError(
        f"{argument}: a path, a Scan, a pair (heights, size) or a topography is needed, and this is of type "
        f"{type(given).__name__}"
    )


def heights_of(argument: str, of_size: str, name: str, given: Any, size: Any, periodic: bool | None) -> Heights:
    if is_topography(given):
        if size is not None:
            raise InputError(f"{of_size}: {argument} has a size of its own; leave it out")
        given, size, its_own = heights_and_size(given, argument)
        periodic = its_own if periodic is None else periodic
    elif size is None:
        raise InputError(f"{of_size} is needed: (lx, ly), or one length of a line or a square map")
    gaps = np.ma.getmaskarray(given) if np.ma.is_masked(given) else None
    heights_m = metres(argument, np.ma.getdata(given) if np.ma.isMaskedArray(given) else given)
    lengths = lengths_of(argument, of_size, size, heights_m.shape)
    is_periodic = periodic is not None and _native.truth("periodic", periodic)
    return Heights(argument, name, heights_m, gaps, (of_size, lengths), is_periodic)


def _name(parts: list[Part]) -> str:
    """As the command line names a composite: by its files."""
    return " + ".join(part._recipe[0].name if isinstance(part, Scan) else part.name for part in parts)


def _is_common(value: Any) -> bool:
    """Returns True for a value that holds for all scans; text is one value."""
    return value is not None and each(value) is None


def _say(options: list[Options], parts: list[Part], argument: str, value: Any) -> None:
    """Adds an argument to what is said of the scans."""
    if value is None:
        return
    is_of_files = argument in _OF_FILES
    if _is_common(value):
        meant = [at for at, part in enumerate(parts) if isinstance(part, File) or not is_of_files]
        if not meant:
            raise InputError(f"{argument} is for files, and scans has none; leave it out")
        for at in meant:
            options[at][argument] = (argument, value)
        return
    if len(value) != len(parts):
        raise InputError(
            f"{argument} has {len(value)} entries for {len(parts)} scans; give one value for all, or one for each"
        )
    for at, one in enumerate(value):
        if one is None:
            continue
        if is_of_files and not isinstance(parts[at], File):
            raise InputError(f"{argument}[{at}] is for files, and scans[{at}] is none; give None in its place")
        options[at][argument] = (f"{argument}[{at}]", one)

"""Power spectra of rough surfaces."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from truearea import _native
from truearea._arrays import doubles
from truearea._choices import (
    Abscissa,
    AmplitudeDefinition,
    Convention,
    Detrend,
    Direction,
    Gaps,
    Normalisation,
    Window,
)
from truearea._material import Quantity
from truearea._native import InputError
from truearea._notes import Note, noted, notes_of
from truearea._options import Sampling, Unpack, with_options
from truearea._picture import Drawn, Trace, Picture
from truearea._results import AnyArray, Fact, FloatArray, Table, notes_html, rows_html

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr


class Moments(Drawn, Table):
    """Spectral moments and McCool's asperities, from the longest wavelength down to each cutoff.

    The first row has no interval yet, and no numbers.
    """

    _title = "spectral moments"
    __slots__ = ()
    wavelength_m: FloatArray
    m0_m2: FloatArray
    m2: FloatArray
    m4_per_m2: FloatArray
    radius_m: FloatArray
    density_per_m2: FloatArray
    sigma_s_m: FloatArray
    offset_m: FloatArray
    nayak_alpha: FloatArray

    def _picture(self) -> Picture:
        columns = {"m0": self.m0_m2, "m2": self.m2, "m4": self.m4_per_m2}
        lines = tuple(
            Trace(self.wavelength_m, column / column[-1], name, condition=at) for at, (name, column) in enumerate(columns.items())
        )
        return Picture(self._title, "wavelength_m", "moments", lines)


class Amplitudes(Drawn, Table):
    """Amplitude and aspect ratio of every scale."""

    _title = "amplitudes"
    __slots__ = ()
    wavelength_m: FloatArray
    amplitude_m: FloatArray
    aspect_ratio: FloatArray

    def _picture(self) -> Picture:
        return Picture(self._title, "scale_m", "amplitude_m", (Trace(self.wavelength_m, self.amplitude_m),))


class Fit(Table):
    """A self-affine fit, in one row."""

    _title = "self-affine fit"
    __slots__ = ()
    hurst_exponent: FloatArray
    hurst_exponent_se: FloatArray
    rolloff_wavelength_m: FloatArray
    rolloff_wavelength_se_m: FloatArray
    plateau_m3: FloatArray
    plateau_se_m3: FloatArray
    rms_log10_residual: FloatArray
    points: FloatArray


class Scans(Table):
    """The scans that a spectrum is made of: the wavelengths at which each is used, and what became of the checks."""

    _title = "scans"
    __slots__ = ()
    scan: AnyArray
    used_from_m: FloatArray
    used_to_m: FloatArray
    limit: AnyArray
    slope_along: FloatArray
    slope_across: FloatArray
    verdict: AnyArray


class Samples(Table):
    """The samples of a spectrum. Standard errors are NaN where they are not known."""

    _title = "power spectrum"
    __slots__ = ()
    wavelength_m: FloatArray
    wavevector_rad_per_m: FloatArray
    c1d_m3: FloatArray
    c1d_se_m3: FloatArray


class Spectrum(Drawn):
    """The power spectrum of a rough surface along a line, a power law between its samples.

    Parameters
    ----------
    wavevectors : array_like of float, shape (samples,)
        q in rad/m, in any order, each above 0.
    c1d : array_like of float, shape (samples,)
        C1D in m³, above 0, with rms height² = (1/pi) Int C1D dq.
    c1d_se : array_like of float, shape (samples,), optional
        Standard errors of C1D in m³, NaN where one is not known.
    convention : str, default "c1d"
        What the values are: ``"c1d"``, ``"w1"``, ``"frequency"`` (m³), ``"ciso"`` or ``"persson"`` (m⁴).
    name : str, default "spectrum"
        What it is called in messages and figures.

    Raises
    ------
    InputError
        For columns of different lengths, or a number that is not finite and above 0.

    Examples
    --------
    >>> import numpy as np
    >>> import truearea as ta
    >>> q = np.geomspace(1e5, 1e9, 40)
    >>> spectrum = ta.Spectrum(wavevectors=q, c1d=1e-22 * (q / 1e5) ** -2.6)
    >>> spectrum.moments().m2[-1]
    np.float64(3.08...e-06)
    """

    __slots__ = ("_facts", "_native", "_recipe")

    def __init__(
        self,
        wavevectors: npt.ArrayLike,
        c1d: npt.ArrayLike,
        c1d_se: npt.ArrayLike | None = None,
        *,
        convention: Convention = "c1d",
        name: str = "spectrum",
    ) -> None:
        q = _column("wavevectors", wavevectors, "1/m")
        if bad := [value for value in q if not (np.isfinite(value) and value > 0.0)]:
            raise InputError(f"wavevectors: {bad[0]} is given; they must be finite and greater than 0")
        unit = "m**4" if convention in ("ciso", "persson") else "m**3"
        c = _column("c1d", c1d, unit)
        errors = None if c1d_se is None else _column("c1d_se", c1d_se, unit)
        if errors is not None and q.shape == c.shape == errors.shape:
            # The core takes standard errors from long wavelengths on.
            order = np.argsort(q)
            q, c, errors = q[order], c[order], errors[order]
        native = _native.Surface.of_samples(name, 2.0 * np.pi / q, c, errors, convention)
        self._set(native, (Spectrum, (q, c, errors), {"convention": convention, "name": name}))

    def _set(self, native: _native.Surface, recipe: tuple[Any, tuple[Any, ...], dict[str, Any]]) -> None:
        self._native, facts = native, native.facts
        for array in facts.values():
            if isinstance(array, np.ndarray):
                array.flags.writeable = False
        self._facts = facts | {"notes": notes_of(facts["notes"])}
        # A spectrum is pickled as what it was made from, so that it comes back bit for bit.
        self._recipe = recipe

    @classmethod
    def _of(cls, native: _native.Surface, maker: Any, *given: Any, **options: Any) -> Spectrum:
        spectrum = cls.__new__(cls)
        spectrum._set(native, (maker, given, options))
        return spectrum

    @classmethod
    def from_heights(
        cls,
        h: Any,
        size: Any = None,
        *,
        periodic: bool | None = None,
        detrend: Detrend | None = None,
        window: Window | None = None,
        gaps: Gaps | None = None,
        direction: Direction | None = None,
        bins_per_decade: int | None = None,
        tip_radius: Quantity | None = None,
        shortest: Quantity | None = None,
        name: str = "heights",
    ) -> Spectrum:
        """The spectrum of a map or a line of heights, at the wavelengths at which it can be trusted.

        Parameters
        ----------
        h : array_like of float, shape (rows, columns) or (points,)
            Heights in m, x along the rows; a masked array where there are gaps. Or an object of SurfaceTopography, or a ``Scan``.
        size : pair of float or str, or one of them
            (lx, ly) in m or as text such as ``"5 um"``, so many spacings as there are points; one length of a line or a square
            map. Left out for objects that have a size.
        periodic : bool, optional
            Whether the heights repeat themselves beyond the array; False for arrays, and what the object says for others.
        detrend, window, gaps, direction, bins_per_decade, tip_radius, shortest : optional
            As for ``composite``.
        name : str, default "heights"
            What it is called in messages and figures.

        Returns
        -------
        Spectrum
            With the checks of the transform in ``notes``.

        Raises
        ------
        InputError
            For shapes and sizes that do not fit, heights that are not finite and not masked, and heights that are flat.

        Examples
        --------
        >>> import numpy as np
        >>> import truearea as ta
        >>> h = 1e-9 * np.random.default_rng(1).standard_normal((128, 256)).cumsum(axis=1)
        >>> spectrum = ta.Spectrum.from_heights(h, size=("10 um", "5 um"), tip_radius="8 nm")
        >>> spectrum
        Spectrum('heights', ... samples from ... m to ... m)
        """
        from truearea._composite import spectrum_of_heights

        said = {"gaps": gaps, "direction": direction, "tip_radius": tip_radius, "shortest": shortest}
        of_all = {"detrend": detrend, "window": window, "bins_per_decade": bins_per_decade}
        return spectrum_of_heights(h, size, periodic, said, of_all, name)

    name = Fact[str]("The name of the spectrum.")
    wavelengths_m = Fact[FloatArray]("Wavelengths [m], from long to short.")
    c1d_m3 = Fact[FloatArray]("C1D [m³], one value for each wavelength.")
    c1d_se_m3 = Fact["FloatArray | None"]("Standard errors of C1D [m³], NaN where one is not known; None where none is.")
    holes_m = Fact[tuple[tuple[float, float], ...]]("Bands without samples: their wavelengths [m] at the long and the short end.")
    notes = Fact[tuple[Note, ...]]("Assumptions of reading, and doubts.")
    remarks = Fact[tuple[str, ...]]("The comments of its file: origin, licence; or the scans that it is made of.")

    @property
    def wavevectors_rad_per_m(self) -> FloatArray:
        """Wavevectors q = 2 pi/wavelength [rad/m], from small to large."""
        return 2.0 * np.pi / self.wavelengths_m

    @property
    def scans(self) -> Scans | None:
        """The scans that it is made of, a row for each: wavelengths, slopes and verdicts; None where it is made of none."""
        columns = _native.scans_of(self._native)
        return None if columns is None else Scans._of(columns)

    @with_options(Sampling)
    def moments(self, *, normalisation: Normalisation = "parseval", **options: Unpack[Sampling]) -> Moments:
        """Spectral moments and McCool's asperity parameters for every cutoff (Jackson & Jacobs, Eqs. 1, 3, 4).

        Examples
        --------
        >>> import truearea as ta
        >>> moments = ta.read_psd("builtin:uncd-measured").moments()
        >>> float(moments.m2[-1]) ** 0.5
        0.389...
        """
        answer = self._native.quantity("moments", {"normalisation": normalisation, **options})
        return Moments._of(answer.columns, noted(answer.notes))

    @with_options(Sampling)
    def amplitudes(self, *, amplitude: AmplitudeDefinition = "eq5", **options: Unpack[Sampling]) -> Amplitudes:
        """Amplitude [m] and aspect ratio of every scale (Jackson & Jacobs, Eq. 5)."""
        answer = self._native.quantity("amplitudes", {"amplitude": amplitude, **options})
        return Amplitudes._of(answer.columns, noted(answer.notes))

    def fit(self, *, longest: Quantity | None = None, shortest: Quantity | None = None) -> Fit:
        """Hurst exponent and roll-off of the spectrum between two wavelengths, by least squares in logarithms."""
        answer = self._native.quantity("fit", {"longest": longest, "shortest": shortest})
        return Fit._of(answer.columns, noted(answer.notes))

    def against(self, other: Spectrum) -> Spectrum:
        """The sum of two surfaces that know nothing of each other."""
        return Spectrum._of(self._native.against(other._native), Spectrum.against, self, other)

    def table(self) -> Samples:
        """The samples as a table, a row for each wavelength, from long to short.

        Examples
        --------
        >>> import truearea as ta
        >>> list(ta.read_psd("builtin:uncd-measured").table())
        ['wavelength_m', 'wavevector_rad_per_m', 'c1d_m3', 'c1d_se_m3']
        """
        errors_m3 = self.c1d_se_m3
        columns = {
            "wavelength_m": self.wavelengths_m,
            "wavevector_rad_per_m": self.wavevectors_rad_per_m,
            "c1d_m3": self.c1d_m3,
            "c1d_se_m3": np.full(len(self), np.nan) if errors_m3 is None else errors_m3,
        }
        return Samples._of(columns, self.notes, axis="wavelength")

    def to_pandas(self) -> pd.DataFrame:
        """The samples as a data frame, with the notes in ``attrs["notes"]`` and the name in ``attrs["name"]``."""
        frame = self.table().to_pandas()
        frame.attrs["name"] = self.name
        return frame

    def to_xarray(self) -> xr.Dataset:
        """The samples along ``wavelength_m``, with long names and units: ``sel(wavelength_m=slice(1e-5, 1e-7))`` cuts out a band."""
        data = self.table().to_xarray().swap_dims(wavelength="wavelength_m").set_coords("wavevector_rad_per_m")
        return data.assign_attrs(name=self.name)

    def write(self, path: str | os.PathLike[str]) -> None:
        """Write the samples with their standard errors as CSV, which :func:`read_psd` and the command line read.

        Parameters
        ----------
        path : str or path-like
            The file; an existing one is replaced.

        Raises
        ------
        OSError
            With the path that cannot be written.
        """
        file = Path(path)
        _native.write_files(os.fspath(file.parent), {file.name: self._native.csv()})

    def between(self, longest: Quantity | None = None, shortest: Quantity | None = None) -> Spectrum:
        """The part of the spectrum between two wavelengths, both included.

        Parameters
        ----------
        longest, shortest : float or str, optional
            The ends, in m or as text such as ``"10 um"``; those of the spectrum where left out.

        Raises
        ------
        InputError
            Where fewer than two samples are left.

        Examples
        --------
        >>> import truearea as ta
        >>> len(ta.read_psd("builtin:uncd-measured").between("10 um", "100 nm"))
        20
        """
        native = self._native.between({"longest": longest, "shortest": shortest})
        return Spectrum._of(native, Spectrum.between, self, longest, shortest)

    def _picture(self) -> Picture:
        line = Trace(self.wavelengths_m, self.c1d_m3, self.name)
        holes = tuple((shortest_m, longest_m) for longest_m, shortest_m in self.holes_m)
        return Picture("power spectrum", "scale_m", "c1d_m3", (line,), holes=holes)

    def __add__(self, other: Spectrum) -> Spectrum:
        return self.against(other) if isinstance(other, Spectrum) else NotImplemented

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Spectrum):
            return NotImplemented
        return self.table() == other.table()

    def __hash__(self) -> int:
        return hash(self.c1d_m3.tobytes())

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> AnyArray:
        """The samples as a structured array, see :meth:`table`."""
        return self.table().__array__(dtype, copy)

    def __reduce__(self) -> tuple[Any, ...]:
        return (_made_again, self._recipe)

    def __len__(self) -> int:
        return len(self.wavelengths_m)

    def __repr__(self) -> str:
        wavelengths = self.wavelengths_m
        return (
            f"Spectrum({self.name!r}, {len(wavelengths)} samples from {wavelengths[0]:.4g} m "
            f"to {wavelengths[-1]:.4g} m)"
        )

    def _repr_html_(self) -> str:
        moments = self._native.quantity("moments", {}).columns
        rows = {
            "samples": str(len(self)),
            "wavelengths": f"{self.wavelengths_m[0]:.4g} m to {self.wavelengths_m[-1]:.4g} m",
            "rms height": f"{moments['m0_m2'][-1] ** 0.5:.4g} m",
            "rms slope": f"{moments['m2'][-1] ** 0.5:.4g}",
            "holes": str(len(self.holes_m)),
        }
        return f"<div>{self._drawing()}{rows_html(rows)}{notes_html(self.notes)}</div>"


def _made_again(maker: Any, given: tuple[Any, ...], options: dict[str, Any]) -> Spectrum:
    spectrum: Spectrum = maker(*given, **options)
    return spectrum


def read_psd(
    path: str | os.PathLike[str],
    *,
    column: str | None = None,
    convention: Convention | None = None,
    x: Abscissa | None = None,
    series: str | None = None,
    subject: str | None = None,
    x_unit: str | None = None,
    psd_unit: str | None = None,
) -> Spectrum:
    """Read the power spectrum in a file: text, JSON or a workbook, of contact.engineering, Gwyddion, and others.

    Parameters
    ----------
    path : str or path-like
        The file, or one of the built-in spectra, ``"builtin:uncd-measured"``,
        ``"builtin:uncd-reconstructed"`` and ``"builtin:contact-challenge"``.
    column, convention, x, series, subject, x_unit, psd_unit : str, optional
        What the file does not say itself: the column of the values, their convention (``"c1d"``, ``"w1"``, ``"frequency"``, ``"ciso"``, ``"persson"``), what the first
        column is (``"wavelength"``, ``"wavevector"``, ``"frequency"``), which of several series, and units.

    Returns
    -------
    Spectrum

    Raises
    ------
    FileNotFoundError
        If the file does not exist.
    InputError
        With file, line, column and value for what cannot be read, and the argument that mends it.

    Examples
    --------
    >>> import truearea as ta
    >>> ta.read_psd("builtin:uncd-measured")
    Spectrum('builtin:uncd-measured', ... samples from ... m to ... m)
    """
    name = os.fspath(path)
    options = {
        "column": column,
        "convention": convention,
        "x": x,
        "series": series,
        "subject": subject,
        "x_unit": x_unit,
        "psd_unit": psd_unit,
    }
    content = None if name.startswith("builtin:") else Path(name).read_bytes()
    return _spectrum_of_file(name, content, options)


def _spectrum_of_file(name: str, content: bytes | None, options: dict[str, str | None]) -> Spectrum:
    native = _native.Surface.of_file(name, content, options)
    return Spectrum._of(native, _spectrum_of_file, name, content, options)


def _column(argument: str, given: Any, unit: str) -> FloatArray:
    array = np.array(doubles(argument, given, unit), order="C")
    if array.ndim != 1:
        raise InputError(f"{argument}: an array of one axis is needed, and this has {array.ndim}")
    return array

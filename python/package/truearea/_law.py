"""Pressure against overclosure, as finite element codes read it."""

from __future__ import annotations

import errno
import os
from pathlib import Path
from typing import Any

from truearea import _native
from truearea._choices import (
    Band,
    Dialect,
    EnergyFactor,
    HardnessFormula,
    InterferenceLaw,
    LawForm,
    LawModel,
    Normalisation,
    UnitSystem,
)
from truearea._curves import Pressures
from truearea._grammar import AnyMaterial, AnySurface, formerly, material_of, spectrum_of
from truearea._material import Quantity
from truearea._native import InputError
from truearea._notes import noted
from truearea._picture import Drawn, Trace, Picture
from truearea._results import FloatArray, Table
from truearea._spectrum import Spectrum


class ContactLaw(Drawn, Table):
    """Pressure against overclosure, straight between its points; pressure 0 at overclosure 0."""

    _title = "contact law"
    __slots__ = ("_native", "_recipe")
    pressure_pa: FloatArray
    overclosure_m: FloatArray
    mean_gap_m: FloatArray
    area_fraction: FloatArray

    _native: _native.ContactLaw
    _recipe: tuple[Spectrum, AnyMaterial, dict[str, Any]]

    def _picture(self) -> Picture:
        line = Trace(self.overclosure_m, self.pressure_pa)
        return Picture(self._title, "overclosure_m", "pressure_pa", (line,), marker=".")

    @property
    def cut_pressure_pa(self) -> float:
        """The nominal pressure [Pa] at the gap of the first point, where the law is cut off and its pressure set to 0."""
        return self._native.cut_pressure_pa

    @property
    def interpolation_error(self) -> float:
        """The largest relative error of the pressure that was met halfway between two points."""
        return self._native.interpolation_error

    def to_text(
        self, dialect: Dialect, *, units: UnitSystem = "SI", name: str = "ROUGH", form: LawForm = "table"
    ) -> str:
        """The law in the words of a code, with a comment in front that says where it comes from.

        Parameters
        ----------
        dialect : {"abaqus", "calculix", "csv"}
            Who is to read it.
        units : {"SI", "N-mm", "uN-um", "lbf-in"}
            The units of the finite element model.
        name : str, default "ROUGH"
            The name of the surface interaction.
        form : {"table", "exponential"}
            For CalculiX: the table, or the exponential law of light loads that Persson's theory has.

        Returns
        -------
        str

        Raises
        ------
        InputError
            For what the code cannot read: more rows than it has room for, rows nearer than it tells apart.

        Examples
        --------
        >>> import truearea as ta
        >>> uncd = ta.read_psd("builtin:uncd-reconstructed")
        >>> law = ta.law(uncd, ta.Material("463 GPa", 0.2), pressure=("10 kPa", "10 MPa"))
        >>> lines = law.to_text("abaqus", units="N-mm").splitlines()
        >>> [line for line in lines if line.startswith("*") and not line.startswith("**")]
        ['*SURFACE INTERACTION, NAME=ROUGH', '*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR']
        """
        return self._native.to_text(dialect, units, name, form)

    def write(
        self,
        path: str | os.PathLike[str],
        dialect: Dialect,
        *,
        units: UnitSystem = "SI",
        name: str = "ROUGH",
        form: LawForm = "table",
    ) -> None:
        """Write :meth:`to_text` into a file: aside, and then renamed, so that the file is never there in part."""
        _write(Path(path), self.to_text(dialect, units=units, name=name, form=form))

    def __reduce__(self) -> tuple[Any, ...]:
        return (_made_again, self._recipe)


@formerly(spectrum="surface", hardness="hardness_formula")
def law(
    surface: AnySurface,
    material: AnyMaterial,
    *,
    pressure: Pressures | None = None,
    from_pressure: Quantity | None = None,
    to_pressure: Quantity | None = None,
    model: LawModel = "persson",
    tolerance: float = 0.01,
    gamma: EnergyFactor | None = None,
    band: Band | None = None,
    strain_gradient: bool = False,
    hardness_formula: HardnessFormula | None = None,
    interference_law: InterferenceLaw | None = None,
    normalisation: Normalisation | None = None,
    cutoff: Quantity | None = None,
    scales_per_decade: int | None = None,
) -> ContactLaw:
    """Nominal pressure against overclosure between two pressures, for finite elements.

    The overclosure is u_ref - u with the mean gap u of :func:`gap`; u_ref is the gap at 1/e of the smaller pressure, where the
    pressure is set to 0. It is the compliance of the roughness in excess of smooth bodies: those of the model deform beside it.

    Parameters
    ----------
    surface : Spectrum, Scan, sequence of scans, or path of a spectrum
        The roughness.
    material : Material or str
        The bodies in contact, or the name of a material of the table.
    pressure : two of float or str
        The least and the largest nominal pressure of interest, in Pa or as text.
    from_pressure, to_pressure : float or str
        The same, one by one.
    model : {"persson", "persson-plastic", "hertz", "ep-sphere", "elastic-sine", "ep-sine", "bgt"}
        What makes the gap.
    tolerance : float, default 0.01
        The largest relative error of the pressure on the straight lines between the points, from 1e-5 to 0.5.
    gamma, band, strain_gradient, hardness_formula, interference_law, normalisation, cutoff, scales_per_decade : optional
        As :func:`gap` has them.

    Returns
    -------
    ContactLaw
        A row a point: ``pressure_pa``, ``overclosure_m``, ``mean_gap_m``, ``area_fraction``.

    Raises
    ------
    InputError
        With argument, value and bound; for pressures at which there is no gap, or between which it does not close.

    Examples
    --------
    >>> import truearea as ta
    >>> uncd = ta.read_psd("builtin:uncd-reconstructed")
    >>> law = ta.law(uncd, ta.Material("463 GPa", 0.2), pressure=("10 kPa", "10 MPa"))
    >>> float(law.pressure_pa[0]), float(law.overclosure_m[0]), float(law.pressure_pa[-1])
    (0.0, 0.0, 10000000.0)
    """
    arguments = locals()
    arguments["pressure"] = _range(pressure, from_pressure, to_pressure)
    del arguments["surface"], arguments["material"]
    return _made_again(spectrum_of(surface), material, arguments)


def _range(pressure: Any, from_pressure: Quantity | None, to_pressure: Quantity | None) -> Any:
    """The pressures from which and to which a law goes."""
    ends = (from_pressure, to_pressure)
    if pressure is not None and ends != (None, None):
        raise InputError("pressure and from_pressure or to_pressure are both given; give one or the other")
    if pressure is None and None in ends:
        raise InputError("pressure is needed: two of them, from which and to which the law goes")
    return ends if pressure is None else pressure


def _made_again(spectrum: Spectrum, material: AnyMaterial, arguments: dict[str, Any]) -> ContactLaw:
    native = _native.ContactLaw(spectrum._native, material_of(material), arguments)
    answer = native.answer()
    found = ContactLaw._of(answer.columns, noted(answer.notes), axis="point")
    found._native = native
    # A law is pickled as what it was made from, since its text takes more than its numbers.
    found._recipe = (spectrum, material, arguments)
    return found


def _write(path: Path, text: str) -> None:
    """Writes a file aside and puts it into its place; the folder has to be there."""
    if not path.parent.is_dir():
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), os.fspath(path.parent))
    _native.write_files(os.fspath(path.parent), {path.name: text.encode()})

"""Pressure against overclosure, and conductance against pressure, as finite element codes read them."""

from __future__ import annotations

import errno
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, TypedDict, overload

from truearea import _native
from truearea._choices import (
    Band,
    ConductanceModel,
    Dialect,
    EnergyFactor,
    Gas,
    HardnessFormula,
    InterferenceLaw,
    LawForm,
    LawModel,
    LawQuantity,
    Normalisation,
    UnitSystem,
)
from truearea._curves import Pressures
from truearea._grammar import AnyMaterial, AnySurface, material_of, spectrum_of
from truearea._material import Quantity
from truearea._native import InputError
from truearea._notes import noted
from truearea._picture import Drawn, Trace, Picture
from truearea._results import FloatArray, Table
from truearea._spectrum import Spectrum

if TYPE_CHECKING:
    from typing_extensions import Unpack


class ContactLaw(Drawn, Table):
    """Pressure against overclosure, straight between its points; pressure 0 at overclosure 0."""

    _title = "contact law"
    __slots__ = ("_native", "_recipe")
    pressure_pa: FloatArray
    overclosure_m: FloatArray
    mean_gap_m: FloatArray
    area_fraction: FloatArray

    _native: _native.FoundLaw
    _recipe: tuple[Spectrum, AnyMaterial, dict[str, Any]]

    def _picture(self) -> Picture:
        line = Trace(self.overclosure_m, self.pressure_pa)
        return Picture(self._title, "overclosure_m", "pressure_pa", (line,), marker=".")

    @property
    def cut_pressure_pa(self) -> float:
        """The nominal pressure [Pa] at the gap of the first point, where the law is cut off and its pressure set to 0."""
        cut_pressure_pa = self._native.cut_pressure_pa
        assert cut_pressure_pa is not None
        return cut_pressure_pa

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
            For tables that the code cannot read: too many rows, or rows too close together.

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


class _Conductance(Drawn, Table):
    """Conductance per nominal area against nominal pressure, straight between its points."""

    __slots__ = ("_native", "_recipe")
    pressure_pa: FloatArray

    _native: _native.FoundLaw
    _recipe: tuple[Spectrum, AnyMaterial, dict[str, Any]]

    @property
    def interpolation_error(self) -> float:
        """The largest relative error of the conductance that was met halfway between two points."""
        return self._native.interpolation_error

    def to_text(self, dialect: Dialect, *, units: UnitSystem = "SI") -> str:
        """The table in the words of a code: a card that follows the mechanical law of the same surface interaction.

        Parameters
        ----------
        dialect : {"abaqus", "calculix", "csv"}
            Who is to read it.
        units : {"SI", "N-mm", "uN-um", "lbf-in"}
            The units of the finite element model.

        Returns
        -------
        str

        Raises
        ------
        InputError
            For more rows than the code has room for.
        """
        return self._native.to_text(dialect, units, "", "")

    def write(self, path: str | os.PathLike[str], dialect: Dialect, *, units: UnitSystem = "SI") -> None:
        """Write :meth:`to_text` into a file: aside, and then renamed, so that the file is never there in part."""
        _write(Path(path), self.to_text(dialect, units=units))

    def __reduce__(self) -> tuple[Any, ...]:
        return (_made_again, self._recipe)


class HeatConductance(_Conductance):
    """Thermal conductance of spots and gas against nominal pressure; at no pressure that of the gas alone."""

    _title = "thermal conductance"
    __slots__ = ()
    conductance_w_per_m2_k: FloatArray
    contact_w_per_m2_k: FloatArray
    gas_w_per_m2_k: FloatArray

    def _picture(self) -> Picture:
        line = Trace(self.pressure_pa, self.conductance_w_per_m2_k)
        return Picture(self._title, "pressure_pa", "conductance_w_per_m2_k", (line,), marker=".")


class CurrentConductance(_Conductance):
    """Electrical conductance against nominal pressure; 0 at no pressure."""

    _title = "electrical conductance"
    __slots__ = ()
    conductance_s_per_m2: FloatArray

    def _picture(self) -> Picture:
        line = Trace(self.pressure_pa, self.conductance_s_per_m2)
        return Picture(self._title, "pressure_pa", "conductance_s_per_m2", (line,), marker=".")


if TYPE_CHECKING:

    class _Shared(TypedDict, total=False):
        """Arguments by name that every table takes."""

        pressure: Pressures | None
        from_pressure: Quantity | None
        to_pressure: Quantity | None
        tolerance: float
        gamma: EnergyFactor | None
        band: Band | None
        strain_gradient: bool
        hardness_formula: HardnessFormula | None
        interference_law: InterferenceLaw | None
        normalisation: Normalisation | None
        cutoff: Quantity | None
        scales_per_decade: int | None

    class _OfHeat(_Shared, total=False):
        """Arguments by name of thermal conductances."""

        thermal_conductivity: Quantity | None
        counterface_thermal_conductivity: Quantity | None
        gas: Gas | None
        gas_temperature: float | None
        gas_pressure: Quantity | None
        gas_conductivity: Quantity | None
        gas_parameter: Quantity | None

    class _OfCurrent(_Shared, total=False):
        """Arguments by name of electrical conductances."""

        resistivity: Quantity | None
        counterface_resistivity: Quantity | None


@overload
def law(
    surface: AnySurface,
    material: AnyMaterial,
    *,
    quantity: Literal["pressure"] = "pressure",
    model: LawModel = "persson",
    **options: Unpack[_Shared],
) -> ContactLaw: ...
@overload
def law(
    surface: AnySurface,
    material: AnyMaterial,
    *,
    quantity: Literal["heat"],
    model: ConductanceModel = "persson",
    **options: Unpack[_OfHeat],
) -> HeatConductance: ...
@overload
def law(
    surface: AnySurface,
    material: AnyMaterial,
    *,
    quantity: Literal["current"],
    model: ConductanceModel = "persson",
    **options: Unpack[_OfCurrent],
) -> CurrentConductance: ...
def law(
    surface: AnySurface,
    material: AnyMaterial,
    *,
    pressure: Pressures | None = None,
    from_pressure: Quantity | None = None,
    to_pressure: Quantity | None = None,
    quantity: LawQuantity = "pressure",
    model: ConductanceModel = "persson",
    tolerance: float = 0.01,
    gamma: EnergyFactor | None = None,
    band: Band | None = None,
    strain_gradient: bool = False,
    hardness_formula: HardnessFormula | None = None,
    interference_law: InterferenceLaw | None = None,
    normalisation: Normalisation | None = None,
    cutoff: Quantity | None = None,
    scales_per_decade: int | None = None,
    thermal_conductivity: Quantity | None = None,
    counterface_thermal_conductivity: Quantity | None = None,
    resistivity: Quantity | None = None,
    counterface_resistivity: Quantity | None = None,
    gas: Gas | None = None,
    gas_temperature: float | None = None,
    gas_pressure: Quantity | None = None,
    gas_conductivity: Quantity | None = None,
    gas_parameter: Quantity | None = None,
) -> ContactLaw | HeatConductance | CurrentConductance:
    """Nominal pressure against overclosure between two pressures, or conductance against pressure, for finite elements.

    The overclosure is u_ref - u with the mean gap u of :func:`gap`; u_ref is the gap at 1/e of the smaller pressure, where the
    pressure is set to 0. It is the compliance of the roughness in excess of smooth bodies: those of the model deform beside it.

    Conductances of heat and current follow from the stiffness of :func:`gap` by Barber's analogy, h = k_s K/E*, or from a
    correlation for flowed peaks at the cutoff. Gas in the gaps adds its own, k_g <1/(g + M)> over Gaussian gaps.

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
    quantity : {"pressure", "heat", "current"}
        Pressure over overclosure, or the conductance of heat or current over pressure.
    model : {"persson", "persson-plastic", "hertz", "ep-sphere", "elastic-sine", "ep-sine", "bgt"}
        What makes the gap; for conductances also "yovanovich" and "cooper-mikic-yovanovich", which need a hardness.
    tolerance : float, default 0.01
        The largest relative error of the pressure, or of the conductance, on the straight lines between the points, from
        1e-5 to 0.5.
    gamma, band, strain_gradient, hardness_formula, interference_law, normalisation, cutoff, scales_per_decade : optional
        As :func:`gap` has them.
    thermal_conductivity, counterface_thermal_conductivity : float or str, optional
        Those of the bodies, for heat, in W/(m K) or as text; of named materials those of the table where left out.
    resistivity, counterface_resistivity : float or str, optional
        Those of the bodies, for current, in ohm m or as text; of named materials those of the table where left out.
    gas : {"air", "nitrogen", "helium", "argon", "hydrogen"}, optional
        Gas in the gaps, for heat; vacuum where no gas is given.
    gas_temperature : float, optional
        That of the named gas, in K; 288.15 where left out.
    gas_pressure : float or str, optional
        That of the named gas, in Pa or as text; 1 atm where left out.
    gas_conductivity, gas_parameter : float or str, optional
        Of any other gas: its conductivity, and M in m, by which temperature jumps lengthen every gap; both or neither.

    Returns
    -------
    ContactLaw, HeatConductance or CurrentConductance
        A row a point: ``pressure_pa``, and ``overclosure_m``, ``mean_gap_m``, ``area_fraction``, or
        ``conductance_w_per_m2_k``, ``contact_w_per_m2_k``, ``gas_w_per_m2_k``, or ``conductance_s_per_m2``.

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
    >>> copper = ta.Material("hard copper", counterface=ta.Material("annealed copper"))
    >>> heat = ta.law(uncd, copper, pressure=("10 kPa", "10 MPa"), quantity="heat")
    >>> heat.to_text("abaqus").count("*GAP CONDUCTANCE, PRESSURE")
    1
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


_TABLES: dict[str, type[ContactLaw | HeatConductance | CurrentConductance]] = {
    "heat": HeatConductance,
    "current": CurrentConductance,
}


def _made_again(
    spectrum: Spectrum, material: AnyMaterial, arguments: dict[str, Any]
) -> ContactLaw | HeatConductance | CurrentConductance:
    native = _native.FoundLaw(spectrum._native, material_of(material), arguments)
    answer = native.answer()
    table = _TABLES.get(arguments["quantity"], ContactLaw)
    found = table._of(answer.columns, noted(answer.notes), axis="point")
    found._native = native
    # A law is pickled as what it was made from, since its text takes more than its numbers.
    found._recipe = (spectrum, material, arguments)
    return found


def _write(path: Path, text: str) -> None:
    """Writes a file aside and puts it into its place; the folder has to be there."""
    if not path.parent.is_dir():
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), os.fspath(path.parent))
    _native.write_files(os.fspath(path.parent), {path.name: text.encode()})

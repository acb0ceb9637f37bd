"""Pressure against overclosure, and conductance against pressure, as finite element codes read them."""

from __future__ import annotations

import errno
import os
from copy import deepcopy
from pathlib import Path
from typing import Any, ClassVar, Literal, overload

from truearea import _native
from truearea._choices import ConductanceModel, Dialect, Gas, LawForm, LawModel, LawQuantity, UnitSystem
from truearea._curves import Pressures
from truearea._grammar import AnyMaterial, AnySurface, faces_of, material_of
from truearea._material import Quantity
from truearea._notes import noted
from truearea._options import GapOptions, Unpack, with_options
from truearea._picture import Drawn, Trace, Picture
from truearea._results import FloatArray, Table
from truearea._spectrum import Spectrum

class _FiniteElementTable(Drawn, Table):
    """Rows for finite elements, straight lines between them."""

    _drawn: ClassVar[tuple[str, str]]
    __slots__ = ("_native", "_recipe")
    pressure_pa: FloatArray

    _native: _native.FoundLaw
    _recipe: tuple[Spectrum, AnyMaterial, dict[str, Any]]

    def _picture(self) -> Picture:
        x, y = self._drawn
        return Picture(self._title, x, y, (Trace(self[x], self[y], model=self._recipe[2]["model"]),), marker=".")

    @property
    def interpolation_error(self) -> float:
        """The largest relative error of the pressure, or of the conductance, that was met halfway between two points."""
        return self._native.interpolation_error

    def to_text(
        self, dialect: Dialect, *, units: UnitSystem = "SI", name: str | None = None, form: LawForm | None = None
    ) -> str:
        """The table in the words of a code, with a comment in front that says where it comes from.

        A conductance is a card that follows the mechanical law of the same surface interaction.

        Parameters
        ----------
        dialect : {"abaqus", "calculix", "csv"}
            Who is to read it.
        units : {"SI", "N-mm", "uN-um", "lbf-in"}
            The units of the finite element model.
        name : str, optional
            The name of the surface interaction of a mechanical law; ROUGH where left out.
        form : {"table", "exponential"}, optional
            Of a mechanical law for CalculiX: the table, as where left out, or the exponential law of light loads that Persson's
            theory has.

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
        name: str | None = None,
        form: LawForm | None = None,
    ) -> None:
        """Writes :meth:`to_text` into a file: aside, and then renamed, so that the file is never there in part."""
        folder = Path(path).parent
        if not folder.is_dir():
            raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), os.fspath(folder))
        text = self.to_text(dialect, units=units, name=name, form=form)
        _native.write_files(os.fspath(folder), {Path(path).name: text.encode()})

    def __reduce__(self) -> tuple[Any, ...]:
        # A law is pickled as what it was made from, since its text takes more than its numbers.
        return (_made_again, self._recipe)


class ContactLaw(_FiniteElementTable):
    """Pressure against overclosure, straight between its points; pressure 0 at overclosure 0."""

    _title = "contact law"
    _drawn = ("overclosure_m", "pressure_pa")
    __slots__ = ()
    overclosure_m: FloatArray
    mean_gap_m: FloatArray
    area_fraction: FloatArray

    @property
    def cut_pressure_pa(self) -> float:
        """The nominal pressure [Pa] at the gap of the first point, where the law is cut off and its pressure set to 0."""
        cut_pressure_pa = self._native.cut_pressure_pa
        assert cut_pressure_pa is not None
        return cut_pressure_pa


class HeatConductance(_FiniteElementTable):
    """Thermal conductance of spots and gas against nominal pressure, straight between its points; at no pressure that of the gas."""

    _title = "thermal conductance"
    _drawn = ("pressure_pa", "conductance_w_per_m2_k")
    __slots__ = ()
    conductance_w_per_m2_k: FloatArray
    contact_w_per_m2_k: FloatArray
    gas_w_per_m2_k: FloatArray


class CurrentConductance(_FiniteElementTable):
    """Electrical conductance against nominal pressure; 0 at no pressure."""

    _title = "electrical conductance"
    _drawn = ("pressure_pa", "conductance_s_per_m2")
    __slots__ = ()
    conductance_s_per_m2: FloatArray


class LawOptions(GapOptions, total=False):
    """Options of every law."""

    tolerance: float


class HeatOptions(LawOptions, total=False):
    """Options of thermal conductances."""

    thermal_conductivity: Quantity | None
    counterface_thermal_conductivity: Quantity | None
    gas: Gas | None
    gas_temperature: float | None
    gas_pressure: Quantity | None
    gas_conductivity: Quantity | None
    gas_parameter: Quantity | None


class CurrentOptions(LawOptions, total=False):
    """Options of electrical conductances."""

    resistivity: Quantity | None
    counterface_resistivity: Quantity | None


@overload
def law(
    surface: AnySurface,
    material: AnyMaterial,
    *,
    pressure: Pressures,
    quantity: Literal["pressure"] = "pressure",
    model: LawModel = "persson",
    **options: Unpack[LawOptions],
) -> ContactLaw: ...
@overload
def law(
    surface: AnySurface,
    material: AnyMaterial,
    *,
    pressure: Pressures,
    quantity: Literal["heat"],
    model: ConductanceModel = "persson",
    **options: Unpack[HeatOptions],
) -> HeatConductance: ...
@overload
def law(
    surface: AnySurface,
    material: AnyMaterial,
    *,
    pressure: Pressures,
    quantity: Literal["current"],
    model: ConductanceModel = "persson",
    **options: Unpack[CurrentOptions],
) -> CurrentConductance: ...
@with_options(HeatOptions, CurrentOptions)
def law(
    surface: AnySurface,
    material: AnyMaterial,
    *,
    pressure: Pressures,
    quantity: LawQuantity = "pressure",
    model: ConductanceModel = "persson",
    **options: Any,
) -> ContactLaw | HeatConductance | CurrentConductance:
    """Nominal pressure against overclosure between two pressures, or conductance against pressure, for finite elements.

    The overclosure is u_ref - u with the mean gap u of :func:`gap`; u_ref is the gap at 1/e of the smaller pressure, where the
    pressure is set to 0. It is the compliance of the roughness in excess of smooth bodies: those of the model deform beside it.

    Conductances of heat and current follow from the stiffness of :func:`gap` by Barber's analogy, h = k_s K/E*, or from a
    correlation for flowed peaks at the cutoff. Gas in the gaps adds its own, k_g <1/(g + M)> over Gaussian gaps.

    Parameters
    ----------
    pressure : two of float or str
        The least and the largest nominal pressure of interest, in Pa or as text.
    quantity : {"pressure", "heat", "current"}
        Pressure over overclosure, or the conductance of heat or current over pressure.
    model : {"persson", "persson-plastic", "hertz", "ep-sphere", "elastic-sine", "ep-sine", "bgt"}
        What makes the gap; for conductances also "yovanovich" and "cooper-mikic-yovanovich", which need a hardness.
    tolerance : float, default 0.01
        The largest relative error of the pressure, or of the conductance, on the straight lines between the points, from
        1e-5 to 0.5.
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
    arguments = {"tolerance": 0.01, "pressure": deepcopy(pressure), "quantity": quantity, "model": model, **options}
    return _made_again(faces_of(surface, arguments), material, arguments)


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
    found._recipe = (spectrum, material, arguments)
    return found

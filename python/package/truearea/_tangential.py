"""Surfaces sheared under a constant load."""

from __future__ import annotations

from truearea import _native
from truearea._choices import ShearedModel
from truearea._curves import Pressures
from truearea._grammar import AnyMaterial, AnySurface, material_of, surface_of
from truearea._notes import noted
from truearea._options import GapAndSurfaceOptions, Unpack, with_options
from truearea._picture import Drawn, Trace, Picture, load_label
from truearea._results import FloatArray, Table

class Sheared(Drawn, Table):
    """Displacement, stiffness, slip and loss, a row for each pressure and tangential stress; NaN where everything slides.

    The dissipation is that of a cycle between q and -q.
    """

    _title = "tangential loads"
    __slots__ = ("model",)
    model: str
    nominal_pressure_pa: FloatArray
    tangential_stress_pa: FloatArray
    share_of_sliding: FloatArray
    displacement_m: FloatArray
    initial_stiffness_pa_per_m: FloatArray
    tangent_stiffness_pa_per_m: FloatArray
    dissipation_j_per_m2: FloatArray
    damping_ratio: FloatArray
    area_fraction: FloatArray
    stuck_area_fraction: FloatArray

    def _picture(self) -> Picture:
        rows = {pressure_pa: self.nominal_pressure_pa == pressure_pa for pressure_pa in self.nominal_pressure_pa}
        lines = tuple(
            Trace(self.displacement_m[at], self.tangential_stress_pa[at], load_label(pressure_pa), self.model, place)
            for place, (pressure_pa, at) in enumerate(rows.items())
        )
        return Picture(self._title, "displacement_m", "tangential_stress_pa", lines, marker=".")


@with_options(GapAndSurfaceOptions)
def tangential(
    surface: AnySurface,
    material: AnyMaterial,
    *,
    friction: float,
    pressure: Pressures,
    tangential_stress: Pressures | None = None,
    model: ShearedModel = "persson",
    **options: Unpack[GapAndSurfaceOptions],
) -> Sheared:
    """Shears a surface under a constant normal load, with Coulomb friction at every point (Ciavarella 1998; Jaeger 1998).

    Parameters
    ----------
    material : Material or str
        The bodies in contact, elastic, or the name of a material of the table.
    friction : float
        Coefficient of friction, above 0.
    tangential_stress : float, str, or sequence of them, optional
        Tangential stresses on the nominal area; shares from 1 to 99 % of that at which everything slides where left out.
    model : {"persson", "hertz", "elastic-sine", "bgt", "bem"}
        What makes the normal law; ``"bem"`` is boundary elements on random surfaces.

    Examples
    --------
    >>> import truearea as ta
    >>> uncd = ta.read_psd("builtin:uncd-measured")
    >>> steel = ta.Material("210 GPa", 0.3)
    >>> sheared = ta.tangential(uncd, steel, friction=0.3, pressure="50 MPa", tangential_stress=["5 MPa", "10 MPa"])
    >>> bool(0.0 < sheared.displacement_m[0] < sheared.displacement_m[1])
    True
    """
    arguments = {
        "friction": friction,
        "pressure": pressure,
        "tangential_stress": tangential_stress,
        "model": model,
        **options,
    }
    answer = _native.tangential(surface_of(surface, arguments), material_of(material), arguments)
    return Sheared._of(answer.columns, noted(answer.notes), model=model)

"""Mean gap and stiffness of a surface under loads."""

from __future__ import annotations

from truearea import _native
from truearea._choices import GapModel
from truearea._curves import Pressures
from truearea._grammar import AnyMaterial, AnySurface, material_of, surface_of
from truearea._notes import noted
from truearea._options import GapAndSurfaceOptions, Unpack, with_options
from truearea._picture import Drawn, Trace, Picture
from truearea._results import FloatArray, Table

class Gaps(Drawn, Table):
    """Mean gap and stiffness of a surface with its whole spectrum, a row for each load; NaN where a model has none.

    The mean gap is that of the open gap, and the distance of the mean planes less by the mean depth that has flowed. The stiffness is K =
    -dp/du, never by differences, and that of unloading where peaks have flowed; u0 and p00 are those of u = u0 ln(p00/p), which Persson's theory follows at
    light loads.
    """

    _title = "mean gap and stiffness"
    __slots__ = ("model",)
    model: str
    nominal_pressure_pa: FloatArray
    area_fraction: FloatArray
    mean_gap_m: FloatArray
    mean_plane_distance_m: FloatArray
    stiffness_pa_per_m: FloatArray
    u0_m: FloatArray
    p00_pa: FloatArray

    def _picture(self) -> Picture:
        line = Trace(self.nominal_pressure_pa, self.mean_gap_m, model=self.model)
        return Picture(self._title, "nominal_pressure_pa", "mean_gap_m", (line,), marker="o")


@with_options(GapAndSurfaceOptions)
def gap(
    surface: AnySurface,
    material: AnyMaterial,
    *,
    pressure: Pressures,
    model: GapModel = "persson",
    tolerance: float | None = None,
    **options: Unpack[GapAndSurfaceOptions],
) -> Gaps:
    """Computes mean gap and stiffness of two rough surfaces under loads.

    The gap is measured from the mean plane of the rough surface to the flat: of the deformed surface in Persson's theory
    (Persson 2007; Yang & Persson 2008), of the undeformed one where asperities are pressed one by one (Greenwood & Williamson
    1966).

    Parameters
    ----------
    model : {"persson", "persson-plastic", "hertz", "ep-sphere", "elastic-sine", "ep-sine", "bgt", "bem"}
        What makes the gap; ``"bem"`` is boundary elements on random surfaces.

    Examples
    --------
    >>> import truearea as ta
    >>> uncd = ta.read_psd("builtin:uncd-reconstructed")
    >>> diamond = ta.Material("463 GPa", 0.2)
    >>> gaps = ta.gap(uncd, diamond, pressure=["10 kPa", "1 MPa"], band="2d")
    >>> bool(gaps.mean_gap_m[1] < gaps.mean_gap_m[0])
    True
    >>> bool(gaps.stiffness_pa_per_m[1] > gaps.stiffness_pa_per_m[0])
    True
    """
    arguments = {"pressure": pressure, "model": model, "tolerance": tolerance, **options}
    answer = _native.gaps(surface_of(surface, arguments), material_of(material), arguments)
    return Gaps._of(answer.columns, noted(answer.notes), axis="load", model=model)

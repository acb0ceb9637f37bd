"""Mean gap and stiffness of a surface under loads."""

from __future__ import annotations

from truearea import _native
from truearea._choices import Band, EnergyFactor, GapModel, HardnessFormula, InterferenceLaw, Normalisation, Phases
from truearea._curves import Pressures
from truearea._grammar import AnyMaterial, AnySurface, material_of, surface_of
from truearea._material import Quantity
from truearea._notes import noted
from truearea._picture import Drawn, Trace, Picture
from truearea._results import FloatArray, Table

class Gaps(Drawn, Table):
    """A surface under loads, with its whole spectrum."""

    _title = "mean gap and stiffness"
    __slots__ = ()
    nominal_pressure_pa: FloatArray
    area_fraction: FloatArray
    mean_gap_m: FloatArray
    stiffness_pa_per_m: FloatArray
    u0_m: FloatArray
    p00_pa: FloatArray

    def _picture(self) -> Picture:
        line = Trace(self.nominal_pressure_pa, self.mean_gap_m)
        return Picture(self._title, "nominal_pressure_pa", "mean_gap_m", (line,), marker="o")


def gap(
    surface: AnySurface,
    material: AnyMaterial,
    *,
    pressure: Pressures,
    model: GapModel = "persson",
    gamma: EnergyFactor | None = None,
    band: Band | None = None,
    strain_gradient: bool = False,
    hardness_formula: HardnessFormula | None = None,
    interference_law: InterferenceLaw | None = None,
    normalisation: Normalisation | None = None,
    tolerance: float | None = None,
    cutoff: Quantity | None = None,
    scales_per_decade: int | None = None,
    grid: int | None = None,
    realisations: int | None = None,
    seed: int | None = None,
    longest: Quantity | None = None,
    shortest: Quantity | None = None,
    side: Quantity | None = None,
    phases: Phases | None = None,
) -> Gaps:
    """Computes mean gap and stiffness of two rough surfaces under loads.

    The gap is measured from the mean plane of the rough surface to the flat: of the deformed surface in Persson's theory
    (Persson 2007; Yang & Persson 2008), of the undeformed one where asperities are pressed one by one (Greenwood & Williamson
    1966).

    Parameters
    ----------
    surface : Spectrum, Scan, sequence of scans, or path of a spectrum
        The roughness.
    material : Material or str
        The bodies in contact, or the name of a material of the table.
    pressure : float, str, or sequence of them
        Nominal pressures, in Pa or as text such as ``"5 MPa"`` or ``"1e-3 H"``.
    model : {"persson", "persson-plastic", "hertz", "ep-sphere", "elastic-sine", "ep-sine", "bgt", "bem"}
        What makes the gap; ``"bem"`` is boundary elements on random surfaces.
    gamma : float or "fitted", optional
        Elastic energy factor of Persson's theory, above 0 and at most 1, 0.45 where left out; or the form fitted to boundary
        elements.
    band : {"1d", "2d"}, optional
        Waves that a cutoff ends in Persson's theory: those of the surface, ``"2d"``, as where left out and nearer to boundary
        elements, or those of profiles.
    strain_gradient : bool, default False
        Let the strength grow at small depths, with the material's ``strain_gradient_length``.
    hardness_formula : {"2005", "cosine"}, optional
        The form of the hardness of spheres that yield.
    interference_law : str, optional
        What ties pressure to interference of elastic sinusoids.
    normalisation : {"parseval", "as-printed"}, optional
        The factor of the moments of statistical models.
    tolerance : float, optional
        Relative tolerance of statistical states, above 0 and at most 0.01; 1e-12 where left out.
    cutoff : float or str, optional
        The shortest wavelength that takes part.
    scales_per_decade : int, optional
        Resample to so many wavelengths a decade.
    grid, realisations, seed, longest, shortest, side, phases : optional
        Random surfaces of ``model="bem"``, as :func:`boundary_elements` has them.

    Returns
    -------
    Gaps
        A row a load: ``nominal_pressure_pa``, ``area_fraction``, ``mean_gap_m``, ``stiffness_pa_per_m`` (K = -dp/du, never by
        differences), and ``u0_m``, ``p00_pa`` of the law u = u0 ln(p00/p) that Persson's theory follows at light loads. NaN where
        the model has none.

    Raises
    ------
    InputError
        With argument, value and bound, and for arguments that the model has no use for.

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
    arguments = locals()
    answer = _native.gaps(surface_of(surface), material_of(material), arguments)
    return Gaps._of(answer.columns, noted(answer.notes), axis="load")

"""Persson's theory along the cutoff."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from truearea._arrays import doubles
from truearea._choices import AmplitudeDefinition, Correction, PerssonModel
from truearea._curves import Curve, Pressures
from truearea._grammar import AnyMaterial, AnySurface
from truearea._native import InputError
from truearea._options import PerssonOptions, Unpack, with_options
from truearea._results import AnyArray, FloatArray

if TYPE_CHECKING:
    import pandas as pd


class PerssonCurve(Curve):
    """Contact by Persson's theory along the cutoff, and the law u = u0 ln(p00/p), K = p/u0 of light loads.

    Gap and stiffness are NaN where more than 3 % of the contact is plastic, u0 and p00 where the cutoff leaves no roughness.
    """

    _title = "Persson's theory against cutoff"
    _shared = ("wavelength_m", "rms_gradient", "band")
    __slots__ = ()
    elastic_area_fraction: FloatArray
    plastic_area_fraction: FloatArray
    real_pressure_pa: FloatArray
    rms_gradient: FloatArray
    mean_gap_m: FloatArray
    stiffness_pa_per_m: FloatArray
    u0_m: FloatArray
    p00_pa: FloatArray
    band: AnyArray


@with_options(PerssonOptions)
def persson(
    surface: AnySurface,
    material: AnyMaterial,
    *,
    pressure: Pressures,
    model: PerssonModel = "persson",
    correction: Correction | None = None,
    hardness_law: str | Mapping[str, Any] | pd.DataFrame | None = None,
    strain_gradient: bool = False,
    amplitude: AmplitudeDefinition = "eq5",
    **options: Unpack[PerssonOptions],
) -> PerssonCurve:
    """Contact area, mean gap and stiffness against cutoff by Persson's theory (Persson 2001, 2007; Yang & Persson 2008).

    With the rms gradient h' of all waves down to the cutoff, the pressure that would press the surface flat has the standard
    deviation s = E* h'/2, and the elastic area is erf(p/(sqrt(2) s)). A hardness H is a second wall, where the contact flows.

    Parameters
    ----------
    model : {"persson", "persson-plastic"}
        Whether the contact flows, at the indentation hardness.
    correction : {"wang-muser", "yang-persson", "algebraic", "algebraic-nayak"}, optional
        A corrected form of the elastic theory, fitted to simulations.
    hardness_law : str, or mapping of arrays, optional
        How the hardness grows towards short wavelengths: ``"power:0.2"``, with the wavevector to that power; ``"nix-gao"``,
        with the amplitudes of scales and the material's ``strain_gradient_length``; or a table as measured, with the columns
        ``contact_size_m`` and ``hardness_pa``, as a dict or a data frame has them.
    strain_gradient : bool, default False
        The same as ``hardness_law="nix-gao"``.

    Raises
    ------
    InputError
        With argument, value and bound; for a hardness that falls towards short wavelengths.

    Examples
    --------
    >>> import truearea as ta
    >>> uncd = ta.read_psd("builtin:uncd-reconstructed")
    >>> diamond = ta.Material("463 GPa", 0.2)
    >>> curve = ta.persson(uncd, diamond, pressure="5.4 MPa")
    >>> bool(0.0 < curve.area_fraction[0, -1] < curve.area_fraction[0, 0] == 1.0)
    True
    >>> bool(1e-9 < curve.u0_m < 1e-6)
    True
    """
    arguments = {
        "pressure": pressure,
        "model": model,
        "correction": correction,
        "hardness_law": hardness_law if hardness_law is None or isinstance(hardness_law, str) else _table(hardness_law),
        "strain_gradient": strain_gradient,
        "amplitude": amplitude,
        **options,
    }
    return PerssonCurve._found("persson", surface, material, arguments)


def _table(given: Mapping[str, Any] | pd.DataFrame) -> tuple[FloatArray, FloatArray]:
    """Sizes of contacts and their hardnesses."""
    try:
        columns = {"contact_size_m": "m", "hardness_pa": "Pa"}
        found = [doubles(f"hardness_law[{name!r}]", given[name], unit) for name, unit in columns.items()]
    except (KeyError, TypeError, IndexError):
        raise InputError(
            "hardness_law: 'power:N' or 'nix-gao' is needed, or a mapping with the columns contact_size_m and hardness_pa"
        ) from None
    sizes_m, hardnesses_pa = found
    if sizes_m.ndim != 1 or sizes_m.shape != hardnesses_pa.shape:
        raise InputError(
            "hardness_law: contact_size_m and hardness_pa have to be columns of one length, and theirs are "
            f"{sizes_m.shape} and {hardnesses_pa.shape}"
        )
    return sizes_m, hardnesses_pa

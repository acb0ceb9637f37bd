"""Statistical contact of any populations of asperities."""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from truearea import _native
from truearea._arrays import doubles
from truearea._choices import StatisticalModel
from truearea._material import Material
from truearea._native import InputError
from truearea._notes import noted
from truearea._results import FloatArray, Result


_UNITS = {"radius": "m", "density": "1/m**2", "sigma_s": "m", "m0": "m**2", "m2": "", "m4": "1/m**2"}


class ContactStates(Result):
    """States of contact, each array of the shape to which the arguments broadcast."""

    _title = "states of contact"
    __slots__ = ()
    separation_m: FloatArray
    pressure_pa: FloatArray
    area_fraction: FloatArray
    ln_pressure: FloatArray
    ln_area_fraction: FloatArray
    stiffness_pa_per_m: FloatArray
    error_estimate: FloatArray
    out_of_range_load_share: FloatArray


def contact(
    *,
    model: StatisticalModel,
    material: Material | Sequence[Material] | npt.NDArray[np.object_],
    radius: npt.ArrayLike | None = None,
    density: npt.ArrayLike | None = None,
    sigma_s: npt.ArrayLike | None = None,
    m0: npt.ArrayLike | None = None,
    m2: npt.ArrayLike | None = None,
    m4: npt.ArrayLike | None = None,
    pressure: Any = None,
    separation: npt.ArrayLike | None = None,
    strain_gradient: bool = False,
    hardness_formula: str | None = None,
    hardness: str | None = None,
    interference_law: str | None = None,
    tolerance: float = 1e-12,
    errors: Literal["raise", "nan"] = "raise",
) -> ContactStates:
    """States of populations of asperities pressed by a flat, for arrays of anything.

    All arrays broadcast against each other as those of a ufunc do. Arrays of doubles are not copied. Rows behind one another of one
    population and material share what they can; no digit depends on that, nor on the number of threads.

    Parameters
    ----------
    model : str
        ``"hertz"`` (Greenwood & Williamson 1966), ``"ep-sphere"`` (Jackson & Green 2005), ``"elastic-sine"``, ``"ep-sine"``, or
        ``"bgt"`` (Bush, Gibson & Thomas 1975), which takes moments.
    material : Material, or sequence or array of them
        The bodies in contact. An array of materials broadcasts with the others.
    radius, density, sigma_s : array_like of float
        Radius [m], density [1/m²] and standard deviation of the heights [m] of the asperities.
    m0, m2, m4 : array_like of float
        Moments of profiles [m², 1, 1/m²], for ``model="bgt"`` in place of the three above.
    pressure : array_like of float, or str
        Nominal pressures [Pa]; text such as ``"5 MPa"`` or ``"1e-3 H"``, of the one material.
    separation : array_like of float
        Separations [m] from the mean of the asperity heights, in place of pressures.
    strain_gradient : bool, default False
        Let the strength grow at small depths, with the material's ``strain_gradient_length``.
    hardness_formula : {"2005", "cosine"}, optional
        The form of the hardness of spheres that yield; ``hardness`` is its former name.
    interference_law : str, optional
        What ties pressure to interference of elastic sinusoids.
    tolerance : float, default 1e-12
        Relative tolerance of pressure and area, above 0 and at most 0.01.
    errors : {"raise", "nan"}
        Of numbers that cannot be used, end with the first, or leave their rows NaN and count them in ``notes``.

    Returns
    -------
    ContactStates
        ``separation_m``, ``pressure_pa``, ``area_fraction``, ``ln_pressure`` (of Pa), ``ln_area_fraction``,
        ``stiffness_pa_per_m``, ``error_estimate`` (relative, of pressure and area, numerical only), ``out_of_range_load_share``.
        ``separation_m`` is NaN where the pressure is beyond complete contact.

    Raises
    ------
    InputError
        With the element and its bound for the first number that cannot be used, and for shapes that do not broadcast.

    Examples
    --------
    >>> import numpy as np
    >>> import truearea as ta
    >>> steel = ta.Material("210 GPa", 0.3, yield_strength="1 GPa")
    >>> states = ta.contact(model="ep-sphere", radius=1e-6, density=1e12, sigma_s=10e-9, material=steel,
    ...                     pressure=[1e6, 1e7, 1e8])
    >>> states.area_fraction.shape
    (3,)
    >>> bool(np.all(np.diff(states.area_fraction) > 0))
    True
    """
    arguments = locals()
    of_summits = model == "bgt"
    names = ("m0", "m2", "m4") if of_summits else ("radius", "density", "sigma_s")
    given = dict(radius=radius, density=density, sigma_s=sigma_s, m0=m0, m2=m2, m4=m4)
    if missing := [name for name in names if given[name] is None]:
        raise InputError(f"{missing[0]} is needed for model {model}")
    if idle := [name for name in given if name not in names and given[name] is not None]:
        raise InputError(f"{idle[0]} has no bearing on model {model}, which takes {', '.join(names)}; leave it out")
    if pressure is not None and separation is not None:
        raise InputError("pressure and separation are both given; give one of them")
    if pressure is None and separation is None:
        raise InputError("pressure or separation is needed; give one of them")
    materials = _materials(material)
    condition = "separation" if pressure is None else "pressure"
    at = doubles("separation", separation, "m") if pressure is None else _pressures(pressure, materials)
    arrays = {name: doubles(name, given[name], _UNITS[name]) for name in names} | {condition: at}
    shapes = {name: array.shape for name, array in arrays.items()}
    if materials.ndim:
        shapes["material"] = materials.shape
    try:
        shape = np.broadcast_shapes(*shapes.values())
    except ValueError:
        told = ", ".join(f"{name} {shape}" for name, shape in shapes.items() if shape)
        raise InputError(f"the shapes do not broadcast against each other: {told}") from None
    rows = {name: np.broadcast_to(array, shape) for name, array in arrays.items()}
    which = np.arange(materials.size).reshape(materials.shape)
    answer = _native.contact_states(
        [rows[name] for name in names],
        condition,
        rows[condition],
        [one._native for one in materials.reshape(-1)],
        np.broadcast_to(which, shape) if materials.ndim else None,
        arguments,
    )
    axes = _axes(len(shape))
    # Of one state the arrays are plain doubles, as ufuncs have it.
    columns = {name: column.reshape(shape)[()] for name, column in answer.columns.items()}
    return ContactStates(columns, {name: axes for name in columns}, noted(answer.notes))


def _axes(count: int) -> tuple[str, ...]:
    return ("state",) if count == 1 else tuple(f"axis_{axis}" for axis in range(count))


def _materials(given: Any) -> npt.NDArray[np.object_]:
    if isinstance(given, Material):
        materials = np.empty((), dtype=object)
        materials[()] = given
        return materials
    materials = np.asarray(given, dtype=object)
    if wrong := [one for one in materials.reshape(-1) if not isinstance(one, Material)]:
        raise InputError(f"material: a Material is needed, and this is of type {type(wrong[0]).__name__}")
    return materials


def _pressures(given: Any, materials: npt.NDArray[np.object_]) -> FloatArray:
    if isinstance(given, (Set, Mapping)):
        raise InputError(f"pressure: it has no order, being of type {type(given).__name__}; give a list or an array")
    is_text = isinstance(given, str) or (isinstance(given, (list, tuple)) and any(isinstance(one, str) for one in given))
    texts = np.asarray(given) if is_text or isinstance(given, np.ndarray) else np.empty(0)
    if texts.dtype.kind not in "UT":
        return doubles("pressure", given, "Pa")
    if texts.ndim == 0:
        # In units of the hardness it is another pressure for each material.
        of_each = [one._native.pressure_pa("pressure", str(texts)) for one in materials.reshape(-1)]
        return np.asarray(of_each).reshape(materials.shape)
    if materials.size != 1 and any(str(text).rstrip().endswith("H") for text in texts.reshape(-1)):
        raise InputError("pressure: several pressures in H and several materials; give one of the two, or numbers in Pa")
    one = materials.reshape(-1)[0]._native
    read = [one.pressure_pa(f"pressure[{at}]", str(text)) for at, text in enumerate(texts.reshape(-1))]
    return np.asarray(read).reshape(texts.shape)

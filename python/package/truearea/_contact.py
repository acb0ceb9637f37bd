"""Statistical contact of any populations of asperities."""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from typing import TYPE_CHECKING, Any, Literal, Union, cast

import numpy as np
import numpy.typing as npt

from truearea import _native
from truearea._arrays import doubles
from truearea._choices import Flattening, HardnessFormula, InterferenceLaw, StatisticalModel
from truearea._grammar import named_material
from truearea._material import Material
from truearea._native import InputError
from truearea._notes import Note, noted
from truearea._options import documented
from truearea._picture import Drawn, Picture, Trace
from truearea._results import FloatArray, Result

if TYPE_CHECKING:
    import pandas as pd

_COLUMNS = {"radius": "radius_m", "density": "density_per_m2", "sigma_s": "sigma_s_m", "m0": "m0_m2", "m2": "m2", "m4": "m4_per_m2"}
"""Their names in tables such as :class:`truearea.Moments`."""

_Given = tuple[tuple[str, ...], tuple[Any, ...], Any]
"""Names and numbers of populations, and the index of the rows."""

_Numbers = Union[npt.ArrayLike, str, Sequence[str]]


class ContactStates(Drawn, Result):
    """States of contact, each array of the shape to which the arguments broadcast. Frames have the populations and the index as well.

    ``ln_pressure`` is the logarithm of Pa; ``separation_m`` is NaN where the pressure is beyond complete contact,
    or beyond what all flattened spheres carry: the area is then theirs, and ``notes`` say so;
    ``error_estimate`` is relative, of pressure and area, and numerical only.
    """

    _title = "states of contact"
    __slots__ = ("_given",)
    separation_m: FloatArray
    pressure_pa: FloatArray
    area_fraction: FloatArray
    ln_pressure: FloatArray
    ln_area_fraction: FloatArray
    stiffness_pa_per_m: FloatArray
    error_estimate: FloatArray
    out_of_range_load_share: FloatArray

    @classmethod
    def _of_doubles(cls, arrays: dict[str, Any], notes: tuple[Note, ...], given: _Given) -> ContactStates:
        """One state, made without looking for arrays among its numbers."""
        state = cls.__new__(cls)
        dict.__init__(state, arrays)
        state._axes, state.notes = _NO_AXES, notes
        state._given = given  # type: ignore[attr-defined]
        return state

    def to_pandas(self) -> pd.DataFrame:
        frame = super().to_pandas()
        names, rows, index = self._given  # type: ignore[attr-defined]
        for place, (name, values) in enumerate(zip(names, rows)):
            frame.insert(place, _COLUMNS[name], np.reshape(values, -1))
        return frame if index is None or len(index) != len(frame) else frame.set_index(index)

    def _picture(self) -> Picture:
        line = Trace(np.reshape(self.pressure_pa, -1), np.reshape(self.area_fraction, -1))
        return Picture(self._title, "nominal_pressure_pa", "area_fraction", (line,), marker="o")

    def _drawing(self) -> str:
        return super()._drawing() if np.size(self.pressure_pa) > 1 else ""


_NO_AXES: dict[str, tuple[str, ...]] = dict.fromkeys(ContactStates.__annotations__, ())


@documented
def contact(
    population: Mapping[Any, Any] | pd.DataFrame | None = None,
    material: Material | str | Sequence[Material | str] | npt.NDArray[np.object_] | None = None,
    *,
    model: StatisticalModel,
    radius: _Numbers | None = None,
    density: _Numbers | None = None,
    sigma_s: _Numbers | None = None,
    m0: _Numbers | None = None,
    m2: npt.ArrayLike | None = None,
    m4: _Numbers | None = None,
    pressure: Any = None,
    separation: _Numbers | None = None,
    strain_gradient: bool = False,
    hardness_formula: HardnessFormula | None = None,
    flattening: Flattening | None = None,
    interference_law: InterferenceLaw | None = None,
    tolerance: float = 1e-12,
    errors: Literal["raise", "nan"] = "raise",
) -> ContactStates:
    """States of populations of asperities pressed by a flat, for arrays of anything.

    All arrays broadcast against each other as those of a ufunc do. Arrays of doubles are not copied. Rows behind one another of one
    population and material share what they can; no digit depends on that, nor on the number of threads.

    Parameters
    ----------
    population : mapping or data frame, optional
        The asperities: ``spectrum.moments()``, or ``radius``, ``density`` and ``sigma_s`` or the moments, with or without their
        units in the names. What is given by name counts before it.
    material : Material or str, or sequence or array of them
        The bodies in contact, or the name of a material of the table. An array of materials broadcasts with the others.
    model : str
        ``"hertz"`` (Greenwood & Williamson 1966), ``"ep-sphere"`` (Jackson & Green 2005), ``"elastic-sine"``, ``"ep-sine"``, or
        ``"bgt"`` (Bush, Gibson & Thomas 1975), which takes moments.
    radius, density, sigma_s : array_like of float, or str
        Radius [m], density [1/m²] and standard deviation of the heights [m] of the asperities, or text such as ``"1 um"`` and
        ``"1 1/um2"``.
    m0, m2, m4 : array_like of float, or str
        Moments of profiles [m², 1, 1/m²], for ``model="bgt"`` in place of the three above.
    pressure : array_like of float, or str
        Nominal pressures [Pa]; text such as ``"5 MPa"`` or ``"1e-3 H"``, of the one material.
    separation : array_like of float, or str
        Separations [m] from the mean of the asperity heights, in place of pressures.
    errors : {"raise", "nan"}
        Of numbers that cannot be used, end with the first, or leave their rows NaN and count them in ``notes``.

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
    names: tuple[str, ...]
    given: tuple[Any, ...]
    columns_given: tuple[Any, ...] = (population, radius, density, sigma_s, m0, m2, m4, pressure, separation)
    index = next((one.index for one in columns_given if hasattr(one, "iloc")), None)
    if model == "bgt":
        names, given, idle = _OF_SUMMITS, (m0, m2, m4), (radius, density, sigma_s)
    else:
        names, given, idle = _OF_SPHERES, (radius, density, sigma_s), (m0, m2, m4)
    if not (idle[0] is None and idle[1] is None and idle[2] is None):
        _refuse_idle(model, names, idle)
    if population is not None:
        if all(value is not None for value in given):
            raise InputError(f"population has no effect beside {', '.join(names)}; leave it out")
        given = _of_population(population, names, given)
    if given[0] is None or given[1] is None or given[2] is None:
        raise InputError(f"{next(name for name, value in zip(names, given) if value is None)} is needed for model {model}")
    if (pressure is None) == (separation is None):
        both = "pressure or separation is needed" if pressure is None else "pressure and separation are both given"
        raise InputError(f"{both}; give one of them")
    condition, at = ("separation", separation) if pressure is None else ("pressure", pressure)
    rows: Any = (*given, at)
    natives: list[_native.Material]
    which, shape = None, cast("tuple[int, ...]", ())
    # Numbers alone are the row of one state, and no array is made for them.
    if isinstance(material, Material) and {type(number) for number in rows} <= _FLOATS:
        natives = [material._native]
    else:
        rows, natives, which, shape = _rows(names, given, condition, at, material)
    options: dict[str, Any] = {"model": model, "tolerance": tolerance, "errors": errors}
    if strain_gradient is not False:
        options["strain_gradient"] = strain_gradient
    if hardness_formula is not None or flattening is not None or interference_law is not None:
        options |= {"hardness_formula": hardness_formula, "flattening": flattening, "interference_law": interference_law}
    answer = _native.contact_states(rows, condition, natives, which, options)
    if not shape:
        # Of one state the arrays are plain doubles, as ufuncs have it.
        state = dict(zip(_NO_AXES, answer.columns["state"]))
        return ContactStates._of_doubles(state, noted(answer.notes), (names, rows[:3], index))
    # What the owner of an array writes into it later does not count; one number for all rows is no array of his.
    own = tuple(row.copy() if any(row.strides) else row for row in rows[:3])
    axes = ("state",) if len(shape) == 1 else tuple(f"axis_{axis}" for axis in range(len(shape)))
    columns = {name: column.reshape(shape) for name, column in answer.columns.items()}
    return ContactStates(columns, dict.fromkeys(columns, axes), noted(answer.notes), _given=(names, own, index))


_FLOATS = {float, np.float64}
_OF_SPHERES, _OF_SUMMITS = ("radius", "density", "sigma_s"), ("m0", "m2", "m4")
_UNITS: dict[tuple[str, ...], tuple[str, ...]] = {
    _OF_SPHERES: ("m", "1/m**2", "m"),
    _OF_SUMMITS: ("m**2", "", "1/m**2"),
}


def _rows(
    names: tuple[str, ...], given: tuple[Any, ...], condition: str, at: Any, material: Any
) -> tuple[tuple[FloatArray, ...], list[_native.Material], npt.NDArray[np.int64] | None, tuple[int, ...]]:
    """Arrays of one shape, the materials, which of them each row has, and the shape."""
    if others := [dims for dims in (getattr(value, "dims", ()) for value in (*given, at)) if dims]:
        longest = max(others, key=len)
        if any(longest[len(longest) - len(dims) :] != dims for dims in others):
            named = " and ".join(map(str, dict.fromkeys(others)))
            raise InputError(f"DataArrays of the dims {named} are given, and arrays broadcast by place; give those of xarray.broadcast")
    materials = _materials(material)
    natives = [one._native for one in materials.reshape(-1)]
    arrays = [doubles(name, value, unit) for name, value, unit in zip(names, given, _UNITS[names])]
    is_separation = condition == "separation"
    arrays.append(doubles(condition, at, "m") if is_separation else _pressures(at, natives, materials.shape))
    shapes = {name: array.shape for name, array in zip((*names, condition), arrays)} | {"material": materials.shape}
    shape = _broadcast_shape(shapes)
    which = None
    if materials.ndim:
        # The integers of numpy have 32 bits by default on some platforms, Pyodide among them.
        which = np.broadcast_to(np.arange(materials.size, dtype=np.int64).reshape(materials.shape), shape)
    return tuple(np.broadcast_to(array, shape) for array in arrays), natives, which, shape


def _refuse_idle(model: str, names: tuple[str, ...], idle: tuple[Any, ...]) -> None:
    others = _OF_SPHERES if names == _OF_SUMMITS else _OF_SUMMITS
    named = next(name for name, value in zip(others, idle) if value is not None)
    raise InputError(f"{named} has no effect on model {model}, which takes {', '.join(names)}; leave it out")


def _of_population(population: Any, names: tuple[str, ...], given: tuple[Any, ...]) -> tuple[Any, ...]:
    """The parameters of a population under their own names or those of tables; what is given besides counts before it."""
    if not hasattr(population, "get"):
        raise InputError(
            f"population: a mapping or a data frame of {', '.join(names)} or the moments of a spectrum are needed, and this is of type "
            f"{type(population).__name__}"
        )
    of_table = (population.get(name, population.get(_COLUMNS[name])) for name in names)
    return tuple(there if value is None else value for value, there in zip(given, of_table))


def _broadcast_shape(shapes: dict[str, tuple[int, ...]]) -> tuple[int, ...]:
    """The shape to which arguments broadcast."""
    try:
        return np.broadcast_shapes(*shapes.values())
    except ValueError:
        given = ", ".join(f"{name} {shape}" for name, shape in shapes.items() if shape)
        raise InputError(f"the shapes do not broadcast against each other: {given}") from None


def _materials(given: Any) -> npt.NDArray[np.object_]:
    if given is None:
        raise InputError("material is needed")
    materials = np.array(given, dtype=object)
    for at, one in np.ndenumerate(materials):
        if isinstance(one, str):
            materials[at] = named_material(one)
        elif not isinstance(one, Material):
            raise InputError(f"material: a Material or a name is needed, and this is of type {type(one).__name__}")
    return materials


def _pressures(given: Any, materials: list[_native.Material], shape: tuple[int, ...]) -> FloatArray:
    if type(given) is float:
        return np.array(given)
    if isinstance(given, (Set, Mapping)):
        raise InputError(f"pressure: it has no order, being of type {type(given).__name__}; give a list or an array")
    is_text = isinstance(given, str) or (isinstance(given, (list, tuple)) and any(isinstance(one, str) for one in given))
    is_text = is_text or (isinstance(given, np.ndarray) and given.dtype.kind in "UT")
    if not is_text:
        return doubles("pressure", given, "Pa")
    texts = np.array(given, dtype=object)
    if texts.ndim == 0:
        # In units of the hardness it is another pressure for each material.
        return np.asarray([one.pressure_pa("pressure", str(texts)) for one in materials]).reshape(shape)
    if len(materials) != 1 and any(str(text).rstrip().endswith("H") for text in texts.reshape(-1)):
        raise InputError("pressure: several pressures in H and several materials; give one of the two, or numbers in Pa")
    if not materials:
        raise InputError("material: it is empty; give at least one")
    read = [materials[0].pressure_pa(f"pressure[{at}]", text) for at, text in enumerate(texts.reshape(-1))]
    return np.asarray(read).reshape(texts.shape)

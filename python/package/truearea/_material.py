"""The bodies in contact."""

from __future__ import annotations

from typing import Any, Union

import numpy as np

from truearea import _native
from truearea._results import Fact, rows_html

Quantity = Union[float, str, "np.floating[Any]", "np.integer[Any]"]
"""A number in SI units, or text with a unit, such as ``"210 GPa"``."""


class Material:
    """The rough body, and the body that presses on it.

    Parameters
    ----------
    youngs_modulus : float or str
        E of the rough body, in Pa or as text such as ``"210 GPa"``; or the name of a material of the table, ``"100Cr6"``, as
        ``name`` takes it.
    poisson_ratio : float
        Its Poisson's ratio, above -1 and at most 0.5. May be left out of a named material.
    name : str, optional
        A material of the table, see :func:`materials`; arguments that are given replace its values.
    yield_strength : float or str, optional
        S0 in Pa, for models that yield; a third of the hardness where only that is given.
    indentation_hardness : float or str, optional
        H in Pa, or a number of a scale such as ``"300 HV"``; three times the yield strength where only that is given.
    strain_gradient_length : float or str, optional
        h* in m, with which the strength grows at small depths (Nix & Gao 1998; Jackson & Jacobs, Eq. 8).
    strength_cap : float or str, optional
        The most that the strength grows to, in Pa or as a multiple of the hardness, such as ``"1 H"``.
    counterface : Material, optional
        The body that presses on the rough one; rigid by default. Of two bodies with a hardness the softer flows.
    layer_thickness : float or str, optional
        Thickness in m of an elastic layer bonded to the rough body, which then carries the roughness; strength and hardness are
        those of the layer. Boundary elements and Persson's theory take layers.
    layer_youngs_modulus : float or str, optional
        E of the layer, in Pa.
    layer_poisson_ratio : float, optional
        Poisson's ratio of the layer, from 0 to 0.5.
    layer_base : {"material", "rigid"}, optional
        The base of the layer: the material of the other arguments, or a rigid body, which takes no elastic constants.

    Raises
    ------
    InputError
        For a value that is out of its bound, or a hardness that is not three times the strength within 1 %.

    Examples
    --------
    >>> import truearea as ta
    >>> steel = ta.Material(youngs_modulus="210 GPa", poisson_ratio=0.3, yield_strength="1 GPa")
    >>> round(steel.composite_modulus_pa / 1e9, 1)
    230.8
    >>> steel
    Material(E = 210000000000 Pa, nu = 0.3, E* = 230769230769.2308 Pa, S0 = 1000000000 Pa, rigid counterface)
    >>> ta.Material("100Cr6", counterface=ta.Material("C45")).youngs_modulus
    210000000000.0
    """

    __slots__ = ("_given", "_native")

    def __init__(
        self,
        youngs_modulus: Quantity | None = None,
        poisson_ratio: float | None = None,
        *,
        name: str | None = None,
        yield_strength: Quantity | None = None,
        indentation_hardness: Quantity | None = None,
        strain_gradient_length: Quantity | None = None,
        strength_cap: Quantity | None = None,
        counterface: Material | None = None,
        layer_thickness: Quantity | None = None,
        layer_youngs_modulus: Quantity | None = None,
        layer_poisson_ratio: float | None = None,
        layer_base: str | None = None,
    ) -> None:
        if name is None and isinstance(youngs_modulus, str) and _native.Material.is_name(youngs_modulus):
            name, youngs_modulus = youngs_modulus, None
        self._given: dict[str, Any] = {
            "name": name,
            "youngs_modulus": youngs_modulus,
            "poisson_ratio": poisson_ratio,
            "yield_strength": yield_strength,
            "indentation_hardness": indentation_hardness,
            "strain_gradient_length": strain_gradient_length,
            "strength_cap": strength_cap,
            "counterface": counterface,
            "layer_thickness": layer_thickness,
            "layer_youngs_modulus": layer_youngs_modulus,
            "layer_poisson_ratio": layer_poisson_ratio,
            "layer_base": layer_base,
        }
        if counterface is not None and not isinstance(counterface, Material):
            raise _native.InputError(
                f"counterface: a Material is needed, and this is of type {type(counterface).__name__}"
            )
        other = None if counterface is None else counterface._native
        self._native: _native.Material = _native.Material({**self._given, "counterface": other})

    name = Fact["str | None"]("The name of the material in the table; None where it was made without one.")
    youngs_modulus = Fact["Quantity | None"](
        "E of the rough body, as given; of a named material in Pa. None where the base of a layer is rigid."
    )
    poisson_ratio = Fact["float | None"]("Poisson's ratio of the rough body. None where the base of a layer is rigid.")
    counterface = Fact["Material | None"]("The body that presses on the rough one; None if it is rigid.")
    youngs_modulus_pa = Fact["float | None"]("E of the rough body [Pa]; None where the base of a layer is rigid.")
    composite_modulus_pa = Fact[float]("E* = 1 / ((1 - nu1²)/E1 + (1 - nu2²)/E2) [Pa].")
    indentation_hardness_pa = Fact["float | None"]("H [Pa] of the body that flows, where it or the strength is known.")
    yield_strength_pa = Fact["float | None"]("S0 [Pa] of the body that flows, where it or the hardness is known.")

    @property
    def _facts(self) -> dict[str, Any]:
        """What the core knows, and what was given in its place."""
        elastic = {name: self._given[name] for name in ("youngs_modulus", "poisson_ratio") if self._given[name] is not None}
        return self._native.facts | {name: self._given[name] for name in ("name", "counterface")} | elastic

    def replace(self, **changes: Any) -> Material:
        """Returns this material with some arguments changed.

        Examples
        --------
        >>> import truearea as ta
        >>> steel = ta.Material("210 GPa", 0.3)
        >>> steel.replace(poisson_ratio=0.5).composite_modulus_pa
        280000000000.0
        """
        return Material(**{**self._given, **changes})

    def _value(self, argument: str) -> Any:
        """The value of an argument: as given, or else that of the table; None where neither has one."""
        given = self._given[argument]
        if given is not None or self.name is None:
            return given
        if argument in ("youngs_modulus", "poisson_ratio"):
            return getattr(self, argument)
        strengths = ("yield_strength", "indentation_hardness")
        if argument in strengths and all(self._given[strength] is None for strength in strengths):
            return getattr(self, f"{argument}_pa")
        return None

    def _section(self) -> dict[str, Any]:
        """The keys of the body in a scene, without the counterface and the cap of its strength, which have sections of their own."""
        given = {key: value for key, value in self._given.items() if value is not None}
        layer = {key.removeprefix("layer_"): value for key, value in given.items() if key.startswith("layer_")}
        section = {key: value for key, value in given.items() if not key.startswith(("layer_", "counterface", "strength_cap"))}
        return section | ({"layer": layer} if layer else {})

    def __reduce__(self) -> tuple[Any, ...]:
        return (_material, (self._given,))

    def __eq__(self, other: object) -> bool:
        return self._facts["identity"] == other._facts["identity"] if isinstance(other, Material) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._facts["identity"])

    def __repr__(self) -> str:
        other = "rigid counterface" if self.counterface is None else f"counterface = {self.counterface.name or 'elastic'}"
        return f"Material({self._facts['description']}, {other})"

    def _repr_html_(self) -> str:
        return rows_html(dict(self._facts["properties"]))


def _material(given: dict[str, Any]) -> Material:
    return Material(**given)

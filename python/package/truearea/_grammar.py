"""One grammar for all nouns: (surface, material, ...), and the arguments that are accepted for either."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any, Union

from truearea import _native
from truearea._material import Material
from truearea._native import InputError
from truearea._scan import Scan
from truearea._spectrum import Spectrum, read_psd
from truearea._topography import is_topography

AnySurface = Union[Spectrum, Scan, str, "os.PathLike[str]", Sequence[Any]]
"""A spectrum, or what one is made of: a scan, a list of scans, or the path of a spectrum."""

AnyMaterial = Union[Material, str]
"""A material, or the name of one, see :func:`truearea.materials`."""


def spectrum_of(surface: Any, argument: str = "surface") -> Spectrum:
    """The spectrum of a surface."""
    if isinstance(surface, Spectrum):
        return surface
    if isinstance(surface, (str, os.PathLike)):
        return read_psd(surface)
    if isinstance(surface, (Scan, list, tuple)) or is_topography(surface):
        from truearea._composite import composite

        return composite(list(surface) if isinstance(surface, (list, tuple)) else [surface])
    raise InputError(
        f"{argument}: a Spectrum, the path of one, a Scan or a list of scans is needed, and this is of type "
        f"{type(surface).__name__}; heights of an array need their size: Spectrum.from_heights(h, size)"
    )


def faces_of(surface: Any, arguments: dict[str, Any]) -> Spectrum:
    """The spectrum of a surface, and that of the counterface added, which is taken out of the arguments."""
    other = arguments.pop("counterface_surface", None)
    return spectrum_of(surface) if other is None else spectrum_of(surface).against(spectrum_of(other, "counterface_surface"))


def surface_of(surface: Any, arguments: dict[str, Any]) -> _native.Surface:
    """The core's spectrum of both faces."""
    return faces_of(surface, arguments)._native


def named_material(name: str) -> Material:
    """Returns the material of the table that has this name."""
    try:
        return Material(name=name)
    except InputError as error:
        raise InputError(f"material: {str(error).removeprefix('name: ')}") from None


def material_of(material: Any) -> _native.Material:
    """The core's material."""
    if isinstance(material, str):
        return named_material(material)._native
    if not isinstance(material, Material):
        raise InputError(f"material: a Material or a name is needed, and this is of type {type(material).__name__}")
    return material._native

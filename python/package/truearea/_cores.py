"""What the core works with of arguments that are objects of this package."""

from __future__ import annotations

from typing import Any

from truearea import _native
from truearea._material import Material
from truearea._native import InputError
from truearea._spectrum import Spectrum


def surface_of(spectrum: Any) -> _native.Surface:
    """The core's spectrum."""
    if not isinstance(spectrum, Spectrum):
        raise InputError(f"spectrum: a Spectrum is needed, and this is of type {type(spectrum).__name__}")
    return spectrum._native


def material_of(material: Any) -> _native.Material:
    """The core's material."""
    if not isinstance(material, Material):
        raise InputError(f"material: a Material is needed, and this is of type {type(material).__name__}")
    return material._native

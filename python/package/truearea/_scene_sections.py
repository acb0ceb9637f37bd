"""Sections of a scene from objects: the words that a scene has for spectra, materials and loads."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple, Union

import numpy as np

from truearea._composite import composite
from truearea._material import Material
from truearea._native import InputError
from truearea._scan import Scan
from truearea._scene_files import files_of
from truearea._spectrum import Spectrum
from truearea._topography import is_topography

Body = Union[Material, str, Mapping[str, Any]]
"""A body: a material, a name of the table, or keys of a scene, where values may be uncertain (``"210 GPa +- 5 GPa"``)."""

class SurfaceOfScene(NamedTuple):
    """The surface of a scene: its files, or else a spectrum and the files that it would be written to."""

    files: list[str] | None
    spectrum: Spectrum | None

    def section(self) -> dict[str, Any]:
        """The keys of ``[surface]``; the core finds those of files."""
        return {} if self.spectrum is None else files_of(self.spectrum).section


def surface_of_scene(surface: Any, size: Any) -> SurfaceOfScene:
    """Takes a spectrum, scans, heights, or the paths of any of them."""
    if isinstance(surface, np.ndarray) or (is_topography(surface) and not isinstance(surface, Scan)):
        return SurfaceOfScene(None, Spectrum.from_heights(surface, size=size))
    if size is not None:
        raise InputError("size is that of an array of heights; leave it out")
    if isinstance(surface, Spectrum):
        return SurfaceOfScene(None, surface)
    if isinstance(surface, Scan):
        return SurfaceOfScene(None, composite([surface]))
    if isinstance(surface, (str, os.PathLike)):
        return SurfaceOfScene([_path(surface)], None)
    if isinstance(surface, Sequence) and surface:
        if all(isinstance(one, (str, os.PathLike)) for one in surface):
            return SurfaceOfScene([_path(one) for one in surface], None)
        return SurfaceOfScene(None, composite(surface))
    raise InputError(
        "surface: a Spectrum, scans, an array of heights or paths are needed, and this is of type "
        f"{type(surface).__name__}"
    )


def _path(given: str | os.PathLike[str]) -> str:
    """A path that means the same in any folder; options of a scan may follow it."""
    path = os.fspath(given)
    return path if path.startswith("builtin:") else os.path.abspath(path)


def body_section(argument: str, body: Body) -> dict[str, Any]:
    """The keys of a body."""
    if isinstance(body, Material):
        return body._section()
    if isinstance(body, str):
        return {"name": body}
    if isinstance(body, Mapping):
        return dict(body)
    raise InputError(f"{argument}: a Material, a name or a dictionary is needed, and this is of type {type(body).__name__}")


def curve_tables(curves: Any) -> list[dict[str, Any]]:
    """Curves by the names of their models, or as sections of a scene."""
    if isinstance(curves, (str, Mapping)):
        curves = [curves]
    return [dict(curve) if isinstance(curve, Mapping) else {"model": str(curve)} for curve in curves]

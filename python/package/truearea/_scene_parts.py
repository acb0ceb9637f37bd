"""Parts of a scene from objects: its surface with the files that hold it, its bodies and its curves."""

from __future__ import annotations

import io
import os
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple, Union

import numpy as np

from truearea import _native
from truearea._composite import Heights, Part, _of_parts
from truearea._grammar import spectrum_of
from truearea._material import Material
from truearea._native import InputError
from truearea._scan import File, Options, Scan
from truearea._spectrum import Spectrum
from truearea._topography import is_topography

Body = Union[Material, str, Mapping[str, Any]]
"""A body: a material, a name of the table, or keys of a scene, where values may be uncertain (``"210 GPa +- 5 GPa"``)."""

SPECTRUM_FILE = "surface.csv"
"""The file that holds the spectrum of a surface in memory, where its scene is written."""

COUNTERFACE = "counterface-"
"""What begins the names of the files of the counterface."""


class SurfaceFiles(NamedTuple):
    """The keys of ``[surface]``, and the arrays of heights [m] that its files hold; None for the file of the spectrum."""

    section: dict[str, Any]
    heights_m: dict[str, np.ndarray[Any, Any]] | None

    def written(self, spectrum: Spectrum) -> dict[str, bytes]:
        """The files, by name."""
        if self.heights_m is None:
            return {self.section["psd"]: spectrum._native.csv()}
        files = {}
        for name, heights_m in self.heights_m.items():
            content = io.BytesIO()
            np.save(content, heights_m)
            files[name] = content.getvalue()
        return files


def files_of(spectrum: Spectrum, prefix: str = "") -> SurfaceFiles:
    """The scans of a composite, where files can hold all that is known of them; else the spectrum with its standard errors."""
    maker, given, _ = spectrum._recipe
    if maker is _of_parts:
        parts, options, of_all, *_ = given
        tip_radius = of_all.get("tip_radius")
        scans, arrays = [], {}
        for at, (part, said) in enumerate(zip(parts, options)):
            name = f"{prefix}scan-{at + 1}.npy"
            scan = _scan(part, {"tip_radius": ("tip_radius", tip_radius), **said}, name)
            if scan is None:
                break
            scans.append(scan)
            if isinstance(part, Heights):
                arrays[name] = part.heights_m if part.gaps is None else np.where(part.gaps, np.nan, part.heights_m)
        else:
            recipe = {key: value for key, value in of_all.items() if value is not None and key != "tip_radius"}
            return SurfaceFiles({"scans": scans, **recipe}, arrays)
    return SurfaceFiles({"psd": prefix + SPECTRUM_FILE}, None)


def _scan(part: Part, said: Options, name: str) -> dict[str, Any] | None:
    """An entry of ``scans``; None for what no entry can say."""
    keys: dict[str, Any] = {}
    if isinstance(part, Heights):
        argument, lengths = part.size
        lengths_m = [_native.si_number(argument, "m", length) for length in lengths]
        spacings_m = [length_m / count for length_m, count in zip(lengths_m, part.heights_m.shape[::-1])]
        if part.is_periodic or not np.allclose(spacings_m, spacings_m[0], rtol=1e-12):
            return None
        keys = {"file": name, "unit": "m", "size": f"{lengths_m[0]!r} m"}
    elif isinstance(part, Scan):
        file, before = part._recipe
        said = {**before, **said}
        keys = {"file": os.path.abspath(file.name)}
    elif isinstance(part, File):
        keys = {"file": os.path.abspath(part.name)}
    for key, (argument, value) in said.items():
        if value is None:
            continue
        if key == "measurement":
            return None
        if key in ("tip_radius", "shortest", "size") and not isinstance(value, str):
            value = f"{_native.si_number(argument, 'm', value)!r} m"
        keys["shortest_wavelength" if key == "shortest" else key] = value
    return keys


def surface_of_scene(surface: Any, size: Any) -> tuple[list[str] | None, Spectrum | None]:
    """The files of a surface, paths that mean the same in any folder; or the spectrum of any other surface."""
    if isinstance(surface, np.ndarray) or (is_topography(surface) and not isinstance(surface, Scan)):
        return None, Spectrum.from_heights(surface, size=size)
    if size is not None:
        raise InputError("size is that of an array of heights; leave it out")
    given: Sequence[Any] = surface if isinstance(surface, Sequence) and not isinstance(surface, str) else [surface]
    if given and all(isinstance(one, (str, os.PathLike)) for one in given):
        paths = [os.fspath(one) for one in given]
        # Options of a scan may follow its path.
        return [path if path.startswith("builtin:") else os.path.abspath(path) for path in paths], None
    return None, spectrum_of(surface)


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

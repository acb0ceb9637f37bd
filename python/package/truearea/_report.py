"""From surfaces, bodies and loads to everything that follows from them, in one call."""

from __future__ import annotations

import os
from typing import Any

from truearea._material import Quantity
from truearea._progress import Progress
from truearea._scene import Scene, SceneResults
from truearea._scene_sections import Body


def report(
    surface: Any,
    material: Body,
    *,
    pressure: Any,
    counterface: Body | None = None,
    seal: bool = False,
    strength_cap: Quantity | None = None,
    title: str | None = None,
    size: Any = None,
    out: str | os.PathLike[str] | None = None,
    progress: Progress = False,
) -> SceneResults:
    """Answer how much of a surface touches, with an interval, a verdict on every model, and a page, as ``truearea report`` does.

    Parameters
    ----------
    surface : Spectrum, Scan, array_like, path, or sequence of paths or scans
        The roughness, as :class:`Scene` takes it. Paths may say of their scan what its file leaves open:
        ``"trace.txt:unit=um"``.
    material : Material, str or mapping
        The rough body: a material, a name of the table, or the keys of ``[material]`` in a scene.
    pressure : float, str, or sequence of them
        Nominal pressures, in Pa or as text such as ``"5 MPa"`` or ``"1e-3 H"``.
    counterface : Material, str or mapping, optional
        What presses on the rough body; rigid where left out.
    seal : bool, default False
        Ask from which pressure on the contact seals.
    strength_cap : float or str, optional
        The most that a growing strength grows to [Pa].
    title : str, optional
        The title; the name of the surface where left out.
    size : float, str or pair of them, optional
        Size of an array of heights.
    out : str or path-like, optional
        A folder for the page ``report.html``, tables, figures, ``answer.json``, and ``scene.toml``, which repeats the report.
    progress : bool or callable, default False
        As for :meth:`Scene.run`.

    Returns
    -------
    SceneResults
        Shown in a notebook, it is the page.

    Raises
    ------
    FileNotFoundError
        Where a file is not there.
    InputError
        With argument or file, value and bound, and what to type.

    Examples
    --------
    >>> import truearea as ta
    >>> found = ta.report("builtin:uncd-measured", "diamond", pressure="5.4 MPa")
    >>> print(found.answer.splitlines()[2])
      Touches   17... ppm  ... to ... ppm    boundary elements, elastic
    """
    scene = Scene(
        surface,
        material,
        pressure=pressure,
        counterface=counterface,
        interface=True,
        seal=seal,
        options=None if strength_cap is None else {"strength_cap": strength_cap},
        figures={"format": ["svg", "py"]},
        title=title,
        size=size,
    )
    return scene.run(progress=progress) if out is None else scene.report(out, progress=progress)

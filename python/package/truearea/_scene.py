"""Scenes: a surface, a material, loads, and what to compute and draw of them, in a text."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime, timezone
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

import numpy as np

from truearea import _native
from truearea._choices import Template
from truearea._material import Material, Quantity
from truearea._native import InputError
from truearea._notes import Note, notes_of
from truearea._progress import Progress, observed
from truearea._results import AnyArray, Table
from truearea._scene_parts import COUNTERFACE, Body, body_section, curve_tables, files_of, surface_of_scene
from truearea._spectrum import Spectrum

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_Faces = tuple[Union[Spectrum, None], Union[Spectrum, None]]
"""The two faces of a scene, where they are in memory."""


class SceneTable(Table):
    """A table of a scene: its columns as in the file that the command line writes; the notes tell where it comes from."""

    _title = "table of a scene"
    __slots__ = ()

    if TYPE_CHECKING:
        # Which columns there are, the scene decides.
        def __getattr__(self, name: str) -> AnyArray: ...


class Scene:
    """A surface, a material, loads, and what to compute and draw of them.

    Objects make a scene, and so do a text or a file (:meth:`from_toml`) and the scenes that come with the program
    (:meth:`template`). Scenes are pickled with the bytes of the files that they read, so that they come back the same on
    another machine.

    Parameters
    ----------
    surface : Spectrum, Scan, array_like, path, or sequence of paths or scans
        The roughness: a spectrum, an array of heights [m] with its ``size``, what :func:`composite` takes, or files of a spectrum
        or of scans. A path may say of its scan what the file leaves open, as on the command line: ``"trace.txt:unit=um"``.
        Intervals come from the scatter of several scans.
    material : Material, str or mapping
        The rough body: a material, a name of the table, or the keys of ``[material]`` in a scene, whose values may be uncertain:
        ``{"youngs_modulus": "210 GPa +- 5 GPa", "poisson_ratio": 0.3}``.
    pressure : float, str, or sequence of them
        Nominal pressures, in Pa or as text such as ``"5 MPa"`` or ``"1e-3 H"``.
    counterface : Material, str or mapping, optional
        What presses on the rough body; left out, the counterface of ``material``, or a rigid one.
    counterface_surface : Spectrum, Scan, array_like, path, or sequence of paths or scans, optional
        The roughness of the counterface, as ``surface``; left out, it is smooth. The spectra of the two faces are added.
    curves : "all", or sequence of str or mapping, default "all"
        Models by name, see :func:`models`, or sections of a scene with their options; ``"all"`` are those that apply.
    interface : bool or mapping, default False
        Gap, stiffness, heat and current: True, or the keys of ``[interface]``.
    seal : bool or mapping, default False
        Leaks: True for the pressure from which on the contact seals, or the keys of ``[seal]``.
    judge, uncertainty, options, figures : mapping, optional
        The keys of these sections.
    cutoff : float or str, optional
        The shortest wavelength that takes part [m].
    title : str, optional
        What the scene is about; the name of the surface where left out.
    size : float, str or pair of them, optional
        Size of arrays of heights, as in ``Spectrum.from_heights``.

    Raises
    ------
    InputError
        With argument, or section and key, value and bound.

    Examples
    --------
    >>> import truearea as ta
    >>> spectrum = ta.read_psd("builtin:uncd-measured")
    >>> scene = ta.Scene(spectrum, "100Cr6", pressure=["1 MPa", "10 MPa"], curves=["persson-plastic"])
    >>> scene.run(report=False).tables["persson-plastic"].area_fraction[-1] > 0
    np.True_
    >>> ta.Scene.template("gasket")
    Scene('Rubber gasket on a turned steel flange')
    >>> scene = ta.Scene.template("gasket")
    >>> results = scene.run(judge=False, uncertainty=False)
    >>> sorted(results.tables)
    ['area-fraction', 'persson', 'report-decades', 'report-interface', 'report-scales', 'report-sensitivity']
    >>> bool(results.tables["persson"].area_fraction[-1] > 0)
    True
    """

    __slots__ = ("_native", "_recipe")

    _native: _native.Scene
    _recipe: tuple[str, str, str, dict[str, bytes], _Faces]

    def __init__(
        self,
        surface: Any,
        material: Body,
        *,
        pressure: Any,
        counterface: Body | None = None,
        counterface_surface: Any = None,
        curves: Any = "all",
        interface: bool | Mapping[str, Any] = False,
        seal: bool | Mapping[str, Any] = False,
        judge: Mapping[str, Any] | None = None,
        uncertainty: Mapping[str, Any] | None = None,
        options: Mapping[str, Any] | None = None,
        figures: Mapping[str, Any] | None = None,
        cutoff: Quantity | None = None,
        title: str | None = None,
        size: Any = None,
    ) -> None:
        if pressure is None:
            raise InputError("pressure is needed")
        # One size serves whichever faces are arrays.
        are_arrays = [isinstance(face, np.ndarray) for face in (surface, counterface_surface)]
        paths, spectrum = surface_of_scene(surface, size if are_arrays != [False, True] else None)
        other_paths: list[str] | None = None
        other_spectrum: Spectrum | None = None
        if counterface_surface is not None:
            other_paths, other_spectrum = surface_of_scene(counterface_surface, size if are_arrays[1] else None)
        others: dict[str, Any] = dict(options or {})
        if isinstance(material, Material):
            counterface = material.counterface if counterface is None else counterface
            cap = material._given["strength_cap"]
            if cap is not None and "strength_cap" not in others:
                others["strength_cap"] = cap
        sections = {
            "title": title,
            "surface": {} if spectrum is None else files_of(spectrum).section,
            "material": body_section("material", material),
            "counterface": None if counterface is None else body_section("counterface", counterface),
            "counterface.surface": None
            if counterface_surface is None
            else {}
            if other_spectrum is None
            else files_of(other_spectrum, COUNTERFACE).section,
            "loads": {"pressures": pressure},
            "cutoffs": None if cutoff is None else {"shortest_wavelength": cutoff},
            "options": others or None,
            "curve": None if isinstance(curves, str) and curves == "all" else curve_tables(curves),
            "interface": _section("interface", interface),
            "seal": _section("seal", seal),
            "judge": judge,
            "uncertainty": uncertainty,
            "figures": figures,
        }
        # Files of absolute paths are found from any folder.
        text = _native.scene_text(sections, {"surface": paths, "counterface.surface": other_paths})
        self._set(text, "scene", "", {}, (spectrum, other_spectrum))

    @classmethod
    def from_toml(
        cls,
        path_or_text: str | os.PathLike[str],
        *,
        folder: str | os.PathLike[str] | None = None,
    ) -> Scene:
        """Read a scene, and the files that it names; :meth:`replace` sets other values of its keys.

        Parameters
        ----------
        path_or_text : str or path-like
            The path of a scene, or its text: what has line breaks, or neither ends in ``.toml`` nor names a file.
        folder : str or path-like, optional
            Where the files are that it names. Left out, the folder of the scene; of a text, the working folder.

        Returns
        -------
        Scene

        Raises
        ------
        FileNotFoundError
            Where the scene, or a file that it names, is not there.
        InputError
            With line, key, value and bound for what is wrong in the scene, drawn below the line itself.

        Examples
        --------
        >>> import truearea as ta
        >>> scene = ta.Scene.from_toml('''
        ... title = "Steel on glass"
        ... [surface]
        ... psd = "builtin:uncd-measured"
        ... [material]
        ... youngs_modulus = "210 GPa"
        ... poisson_ratio = 0.3
        ... [loads]
        ... pressures = ["1 MPa", "10 MPa"]
        ... [[curve]]
        ... model = "elastic"
        ... ''')
        >>> scene.scales().area_fraction.shape
        (2,)
        """
        path = _path_of(path_or_text)
        if path is None:
            text, name, beside = str(path_or_text), "scene", Path()
        else:
            text, name, beside = _text(path.read_bytes(), str(path)), str(path), path.parent
        return cls._of(text, name, os.fspath(beside if folder is None else folder), {})

    @classmethod
    def template(cls, name: Template) -> Scene:
        """A scene that comes with the program, as ``truearea scene NAME`` prints it.

        Parameters
        ----------
        name : str
            ``"uncd-measured"``, ``"uncd-reconstructed"``, ``"gasket"``, ``"electrical-contact"``, ``"bolted-joint"``,
            ``"contact-challenge"``, or
            ``"new"``, which is a text to fill in and names a spectrum of one's own, ``my_psd.csv``.

        Raises
        ------
        InputError
            For an unknown name, with the known ones.
        """
        return cls._of(_native.scene_template(name), name, "", {})

    @classmethod
    def _of(
        cls, text: str, name: str, folder: str, files: dict[str, bytes], faces: _Faces = (None, None)
    ) -> Scene:
        scene = cls.__new__(cls)
        scene._set(text, name, folder, files, faces)
        return scene

    def _set(self, text: str, name: str, folder: str, files: dict[str, bytes], faces: _Faces) -> None:
        natives = [None if face is None else face._native for face in faces]
        self._native = _native.Scene(text, name, folder, files, natives)
        self._recipe = (text, name, folder, self._native.files, faces)

    def _faces_in_memory(self) -> list[tuple[Spectrum, str]]:
        """The spectra of the faces that no file holds, and what begins the names of their files."""
        return [(face, prefix) for face, prefix in zip(self._recipe[4], ("", COUNTERFACE)) if face is not None]

    def __reduce__(self) -> tuple[Any, ...]:
        return (Scene._of, self._recipe)

    @property
    def text(self) -> str:
        """The scene as typed."""
        return self._recipe[0]

    @property
    def title(self) -> str:
        """The title of the scene."""
        return self._native.facts["title"]

    @property
    def notes(self) -> tuple[str, ...]:
        """Assumptions of reading, doubts, and keys without effect."""
        notes = notes_of(self._native.facts["notes"])
        if any(face.scans is not None and files_of(face, prefix).heights_m is None for face, prefix in self._faces_in_memory()):
            loss = "to_toml writes the spectrum with standard errors in place of its scans; intervals are then those of the errors"
            notes += (Note(loss, "note", "scene.scans-in-memory"),)
        return notes

    def explain(self) -> str:
        """The steps that a run would take."""
        return self._native.explain()

    def replace(self, **changes: Any) -> Scene:
        """Returns this scene with other values of some keys; comments and the rest of its text stay.

        Parameters
        ----------
        **changes
            Keys and their values: text with a unit, SI numbers, lists of them, or what else the scene takes there. A key is that
            of the one section that has it; ``cutoff`` stands for ``cutoffs.shortest_wavelength``, ``pressure`` for
            ``loads.pressures``. Any other is given with its section:
            ``**{"material.poisson_ratio": 0.3, "curve.0.model": "bgt"}``.

        Raises
        ------
        InputError
            For a name that no section has, or several have, with what is known; and where the scene refuses the value.

        Examples
        --------
        >>> import truearea as ta
        >>> scene = ta.Scene.template("uncd-measured").replace(youngs_modulus="200 GPa", cutoff=10e-9)
        >>> 'youngs_modulus = "200 GPa"' in scene.text
        True
        """
        text, name, folder, files, faces = self._recipe
        return Scene._of(_native.scene_with_keys(text, name, changes), name, folder, files, faces)

    def to_toml(self, path: str | os.PathLike[str] | None = None) -> str:
        """Return the text of the scene, and write it with the files that it names.

        Parameters
        ----------
        path : str or path-like, optional
            The file of the scene. Beside it come the heights of a composite in memory, ``scan-1.npy`` and so on, so that intervals
            have the scatter of the scans; scans that were read from files are named by their paths. What no such file can say
            (heights that repeat themselves, points that are not squares, a measurement of a container) leaves the spectrum,
            ``surface.csv``, with standard errors: areas are the same, intervals are those of the errors, and a note says so.

        Returns
        -------
        str
            The text, which ``truearea run`` takes.

        Examples
        --------
        >>> import truearea as ta
        >>> print(ta.Scene("builtin:uncd-measured", "diamond", pressure="1 MPa").to_toml())
        [surface]
        psd = "builtin:uncd-measured"
        <BLANKLINE>
        [material]
        name = "diamond"
        <BLANKLINE>
        [loads]
        pressures = ["1 MPa"]
        <BLANKLINE>
        """
        if path is not None:
            file = Path(path)
            beside: dict[str, bytes] = {}
            for face, prefix in self._faces_in_memory():
                beside |= files_of(face, prefix).written(face)
            _native.write_files(os.fspath(file.parent), {**beside, file.name: self.text.encode()})
        return self.text

    def report(self, folder: str | os.PathLike[str], *, progress: Progress = False) -> SceneResults:
        """Run the scene and write everything into a folder: the page ``report.html``, tables, figures, ``answer.json``, the scene.

        Parameters
        ----------
        folder : str or path-like
            The folder, which is made where there is none.
        progress : bool or callable, default False
            As for :meth:`run`.

        Returns
        -------
        SceneResults
        """
        results = self.run(progress=progress)
        results.write(folder)
        self.to_toml(Path(folder) / "scene.toml")
        return results

    def run(
        self,
        *,
        progress: Progress = False,
        report: bool = True,
        judge: bool | None = None,
        uncertainty: bool | None = None,
    ) -> SceneResults:
        """Computes everything that the scene requests, as ``truearea run`` does. Ctrl-C ends it.

        Parameters
        ----------
        progress : bool or callable, default False
            True for a line on stderr; or what is called with the steps done and their number, None where that is not known, of
            the part of the work at hand: states, surfaces pressed, draws.
        report : bool, default True
            Make the report and its tables, for which choices of modelling are made another way.
        judge : bool, optional
            Hold every curve against boundary elements. Left out, as the scene says; where it does not, as ``report``.
        uncertainty : bool, optional
            Draw what scatters, for an interval of every area. Left out, as the scene says; where it does not, as ``report``.

        Returns
        -------
        SceneResults

        Raises
        ------
        InputError
            If the scene cannot be run.
        """
        occasion = (datetime.now(timezone.utc).strftime("%Y-%m-%d %H:%M UTC"), f"Scene.run of {self._recipe[1]}")
        flags = {"report": report, "judge": judge, "uncertainty": uncertainty}
        with observed(progress) as observer:
            answer, tables, files = self._native.run(flags, occasion, observer)
        return SceneResults(
            self.title,
            answer,
            {name: SceneTable._of(columns, tuple(origin)) for name, (columns, origin) in tables.items()},
            files,
            self.notes,
            self._native.facts["styles"],
            self._native.facts["loads"],
        )

    def scales(self) -> SceneTable:
        """The area under every load of every curve at the shortest wavelength, and where it settles, without all else of a run.

        Returns
        -------
        SceneTable
            ``curve``, ``nominal_pressure_pa``, ``area_fraction``, ``real_pressure_pa``, ``settled_1_percent_m``, ...: the table
            ``report-scales`` of a run.
        """
        return SceneTable._of(self._native.scales(), self.notes)

    def __eq__(self, other: object) -> bool:
        return self._recipe == other._recipe if isinstance(other, Scene) else NotImplemented

    def __hash__(self) -> int:
        return hash(self.text)

    def __repr__(self) -> str:
        return f"Scene({self.title!r})"

    def _repr_html_(self) -> str:
        notes = "".join(f"<li>{escape(note)}</li>" for note in self.notes)
        return (
            f"<div><b>{escape(self.title)}</b><pre>{escape(self.explain())}</pre>"
            f"{f'<ul>{notes}</ul>' if notes else ''}</div>"
        )


@dataclass(frozen=True, repr=False, eq=False)
class SceneResults:
    """Everything that was made of a scene. It is pickled as it is, and needs no scene any more."""

    title: str
    """What the scene is about."""
    answer: str
    """The summary that the command line prints."""
    tables: dict[str, SceneTable]
    """Every table, by the name of its file without ``.csv``."""
    files: dict[str, bytes]
    """Every file that the command line would write, by name."""
    notes: tuple[str, ...]
    """What reading took for granted, what is doubtful, and the keys that have no effect."""
    styles: dict[str, tuple[str, str, str]]
    """Short name, colour and dashes (as SVG has them) of every curve in figures."""
    loads: int
    """How many loads there are."""

    @property
    def figures(self) -> dict[str, str]:
        """Every figure as the text of an SVG document, by name."""
        svg = ".svg"
        return {
            name[: -len(svg)]: content.decode() for name, content in self.files.items() if name.endswith(svg)
        }

    @property
    def report_html(self) -> str | None:
        """The report as an HTML page; None without a report."""
        page = self.files.get("report.html")
        return None if page is None else page.decode()

    @property
    def conclusions(self) -> dict[str, Any]:
        """The answer as data: for each load the area, its range and the verdict on every model, cautions, and what to measure next.

        It is what ``answer.json`` holds; empty without a report.
        """
        content = self.files.get("answer.json")
        found: dict[str, Any] = {} if content is None else json.loads(content)
        return found

    def plot(self, load: int = 0, *, ax: Axes | None = None) -> Axes:
        """Draw the area of every curve against the shortest wavelength that takes part, and the answer with its range.

        Parameters
        ----------
        load : int, default 0
            The load, counted as in the scene.
        ax : matplotlib.axes.Axes, optional
            The axes to draw in; new ones where left out.

        Returns
        -------
        matplotlib.axes.Axes

        Raises
        ------
        InputError
            For a load that the scene does not have.
        ImportError
            Without Matplotlib; ``pip install truearea[plot]`` adds it.
        """
        from truearea._plot import axes_of, draw_answer, set_axes, style_from

        if not 0 <= load < self.loads:
            raise InputError(f"load {load} does not exist; give a number from 0 to {self.loads - 1}")
        ax = axes_of(ax)
        set_axes(ax, "wavelength_m", "area_fraction")
        ends_m = []
        for name, columns in self.tables.items():
            if name not in self.styles:
                continue
            # A table has its rows load after load.
            wavelengths_m = columns.wavelength_m.reshape(self.loads, -1)[load]
            areas = columns.area_fraction.reshape(self.loads, -1)[load]
            ax.plot(wavelengths_m, areas, **style_from(*self.styles[name]))
            ends_m.append(float(np.nanmin(wavelengths_m)))
        for answer in self.conclusions.get("loads", []):
            if answer["load"] == load and ends_m:
                draw_answer(ax, min(ends_m), answer["area"])
        ax.legend(loc="upper left", fontsize="small")
        return ax

    def write(self, folder: str | os.PathLike[str]) -> list[str]:
        """Write every file into a folder, which is made where there is none: all of them, or none.

        Returns
        -------
        list of str
            Their names.

        Raises
        ------
        OSError
            With the path that cannot be written; the folder is as it was.
        """
        _native.write_files(os.fspath(folder), self.files)
        return list(self.files)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, SceneResults):
            return NotImplemented
        return (self.title, self.answer, self.files) == (other.title, other.answer, other.files)

    def __repr__(self) -> str:
        figures = ", ".join(self.figures) or "none"
        report = "with a report" if "report.html" in self.files else "no report"
        return f"SceneResults({self.title!r}, tables: {', '.join(self.tables)}; figures: {figures}; {report})"

    def _repr_html_(self) -> str:
        page = self.report_html
        if page is None:
            return f"<div><pre>{escape(self.answer)}</pre>{''.join(self.figures.values())}</div>"
        return (
            f'<iframe srcdoc="{escape(page, quote=True)}" style="width:100%;height:800px;border:1px solid #ccc" '
            f'title="{escape(self.title, quote=True)}"></iframe>'
        )


def _path_of(given: str | os.PathLike[str]) -> Path | None:
    """The path that is meant; none where the text of a scene is given."""
    if not isinstance(given, str):
        return Path(given)
    if "\n" in given:
        return None
    is_text = not given.endswith(".toml") and ("=" in given or "[" in given)
    # A line without a key is not a scene: it names a missing file.
    return None if is_text and not os.path.isfile(given) else Path(given)


def _text(content: bytes, name: str) -> str:
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = 1 + content.count(b"\n", 0, error.start)
        raise InputError(f"{name}, line {line}: not UTF-8 text; save the scene as UTF-8") from None


def _section(name: str, given: bool | Mapping[str, Any]) -> Mapping[str, Any] | None:
    """Returns the keys of a section that may be empty."""
    if isinstance(given, Mapping):
        return given
    return {} if _native.truth(name, given) else None


def report(
    surface: Any,
    material: Body,
    *,
    pressure: Any,
    counterface: Body | None = None,
    counterface_surface: Any = None,
    seal: bool = False,
    flatness: str | None = None,
    strength_cap: Quantity | None = None,
    title: str | None = None,
    size: Any = None,
    out: str | os.PathLike[str] | None = None,
    progress: Progress = False,
) -> SceneResults:
    """Answer how much of a surface touches, with an interval, a verdict on every model, and a page, as ``truearea report`` does.

    Parameters
    ----------
    surface, material, pressure, counterface, counterface_surface, title, size : as for ``Scene``
        The roughness of one face or both, the two bodies, the loads, and the title. Paths may say of their scan what its file leaves open: ``"trace.txt:unit=um"``.
    seal : bool, default False
        Ask from which pressure on the contact seals.
    flatness : str, optional
        Flatness of the nominal contact, height from valley to peak over its length: ``"5 um over 40 mm"``. Left out, the parts are flat.
    strength_cap : float or str, optional
        The most that a growing strength grows to [Pa].
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
        counterface_surface=counterface_surface,
        interface=True if flatness is None else {"flatness": flatness},
        seal=seal,
        options=None if strength_cap is None else {"strength_cap": strength_cap},
        figures={"format": ["svg", "py"]},
        title=title,
        size=size,
    )
    return scene.run(progress=progress) if out is None else scene.report(out, progress=progress)

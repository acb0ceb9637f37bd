"""Scenes: a surface, a material, loads, and what to compute and draw of them, in a text."""

from __future__ import annotations

import os
from collections.abc import Mapping
from datetime import datetime, timezone
from html import escape
from pathlib import Path
from typing import Any

import numpy as np

from truearea import _native
from truearea._material import Material, Quantity
from truearea._native import InputError
from truearea._progress import Line, Progress, observer_of
from truearea._results import Table


class SceneTable(Table):
    """A table of a scene: its columns as in the file that the command line writes; the notes tell where it comes from."""

    _title = "table of a scene"
    __slots__ = ()


class Scene:
    """A surface, a material, loads, and what to compute and draw of them.

    Scenes are made with :meth:`from_toml` or :meth:`template`. They are pickled with the bytes of the files that they read, so
    that they come back the same on another machine.

    Examples
    --------
    >>> import truearea as ta
    >>> scene = ta.Scene.template("gasket")
    >>> scene
    Scene('Rubber gasket on a turned steel flange')
    >>> results = scene.run(judge=False, uncertainty=False)
    >>> sorted(results.tables)
    ['area-fraction', 'persson', 'report-decades', 'report-interface', 'report-scales', 'report-sensitivity']
    >>> bool(results.tables["persson"].area_fraction[-1] > 0)
    True
    """

    __slots__ = ("_native", "_recipe")

    _native: _native.Scene
    _recipe: tuple[str, str, str | None, dict[str, bytes], dict[str, Any]]

    def __init__(self) -> None:
        raise TypeError("a Scene is made with Scene.from_toml(path_or_text) or Scene.template(name)")

    @classmethod
    def from_toml(
        cls,
        path_or_text: str | os.PathLike[str],
        *,
        folder: str | os.PathLike[str] | None = None,
        normalisation: str | None = None,
        amplitude: str | None = None,
        scales_per_decade: int | None = None,
        hardness_formula: str | None = None,
        hardness: str | None = None,
        strength_cap: Quantity | None = None,
        cutoff: Quantity | None = None,
        counterface: Material | None = None,
    ) -> Scene:
        """Read a scene, and the files that it names.

        Parameters
        ----------
        path_or_text : str or path-like
            The path of a scene, or its text: what has line breaks, or neither ends in ``.toml`` nor names a file.
        folder : str or path-like, optional
            Where the files are that it names. Left out, the folder of the scene; of a text, the working folder.
        normalisation, amplitude, hardness_formula : str, optional
            Choices of the models, in place of the scene's own, as in its section ``[options]``.
        scales_per_decade : int, optional
            Resample the spectrum to so many wavelengths a decade.
        strength_cap : float or str, optional
            The most that a growing strength grows to [Pa].
        cutoff : float or str, optional
            The shortest wavelength that takes part [m].
        counterface : Material, optional
            What presses on the rough body, in place of the scene's own. Its elastic constants alone count.

        Returns
        -------
        Scene

        Raises
        ------
        FileNotFoundError
            Where the scene, or a file that it names, is not there.
        InputError
            With line, key, value and bound for what is wrong in the scene, drawn below the line itself; and for an argument
            that nothing in the scene depends on.

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
        if counterface is not None and not isinstance(counterface, Material):
            raise InputError(f"counterface: a Material is needed, and this is of type {type(counterface).__name__}")
        overrides = {
            "normalisation": normalisation,
            "amplitude": amplitude,
            "scales_per_decade": scales_per_decade,
            "hardness_formula": hardness_formula,
            "hardness": hardness,
            "strength_cap": strength_cap,
            "cutoff": cutoff,
            "counterface": counterface,
        }
        below = os.fspath(beside if folder is None else folder)
        return cls._of(text, name, below, {}, {key: value for key, value in overrides.items() if value is not None})

    @classmethod
    def template(cls, name: str) -> Scene:
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
            For another name, and tells those there are.
        """
        return cls._of(_native.scene_template(name), name, "", {}, {})

    @classmethod
    def _of(
        cls, text: str, name: str, folder: str | None, files: dict[str, bytes], overrides: dict[str, Any]
    ) -> Scene:
        given = dict(overrides)
        if (other := given.get("counterface")) is not None:
            given["counterface"] = other._native
        scene = cls.__new__(cls)
        scene._native = _native.Scene(text, name, folder, files, given)
        scene._recipe = (text, name, folder, scene._native.files, overrides)
        return scene

    def __reduce__(self) -> tuple[Any, ...]:
        return (Scene._of, self._recipe)

    @property
    def text(self) -> str:
        """The scene as typed."""
        return self._recipe[0]

    @property
    def title(self) -> str:
        """What it is about."""
        return self._native.title

    @property
    def notes(self) -> tuple[str, ...]:
        """What reading took for granted, what is doubtful, and the keys that have no effect."""
        return tuple(self._native.notes)

    def explain(self) -> str:
        """What the scene needs, what of it is shared, and what is skipped, told before anything is computed."""
        return self._native.explain()

    def replace(self, **changes: Any) -> Scene:
        """The same scene with keys of its sections set anew; comments and all else of its text stay.

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
        text, name, folder, files, overrides = self._recipe
        typed = {key: _plain(value) for key, value in changes.items()}
        return Scene._of(_native.scene_with_keys(text, name, typed), name, folder, files, overrides)

    def run(
        self,
        *,
        progress: Progress = False,
        report: bool = True,
        judge: bool | None = None,
        uncertainty: bool | None = None,
    ) -> SceneResults:
        """Compute everything that the scene asks for, as ``truearea run`` does. Ctrl-C ends it.

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
            Where the scene cannot be carried out.
        """
        line = Line()
        occasion = (datetime.now(timezone.utc).strftime("%Y-%m-%d %H:%M UTC"), f"Scene.run of {self._recipe[1]}")
        try:
            answer, tables, files = self._native.run(
                report, judge, uncertainty, occasion, observer_of(progress, line)
            )
        finally:
            line.end()
        return SceneResults(
            self.title,
            answer,
            {name: SceneTable._of(columns, tuple(origin)) for name, (columns, origin) in tables.items()},
            files,
            self.notes,
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


class SceneResults:
    """Everything that was made of a scene. It is pickled as it is, and needs no scene any more.

    Attributes
    ----------
    title : str
        What the scene is about.
    answer : str
        The summary that the command line prints.
    tables : dict of str to SceneTable
        Every table, by the name of its file without ``.csv``.
    files : dict of str to bytes
        Every file that the command line would write, by name.
    notes : tuple of str
        What reading took for granted, what is doubtful, and the keys that have no effect.
    """

    __slots__ = ("answer", "files", "notes", "tables", "title")

    def __init__(
        self,
        title: str,
        answer: str,
        tables: Mapping[str, SceneTable],
        files: Mapping[str, bytes],
        notes: tuple[str, ...],
    ) -> None:
        self.title = title
        self.answer = answer
        self.tables = dict(tables)
        self.files = dict(files)
        self.notes = notes

    def __reduce__(self) -> tuple[Any, ...]:
        return (SceneResults, (self.title, self.answer, self.tables, self.files, self.notes))

    @property
    def figures(self) -> dict[str, str]:
        """Every figure as the text of an SVG document, by name."""
        svg = ".svg"
        return {
            name[: -len(svg)]: content.decode() for name, content in self.files.items() if name.endswith(svg)
        }

    @property
    def report_html(self) -> str | None:
        """The report as an HTML page; None where none was asked for."""
        page = self.files.get("report.html")
        return None if page is None else page.decode()

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

    __hash__ = None  # type: ignore[assignment]

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
    # A line without a key is no scene: what it names is missing, and that is told.
    return None if is_text and not os.path.isfile(given) else Path(given)


def _text(content: bytes, name: str) -> str:
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = 1 + content.count(b"\n", 0, error.start)
        raise InputError(f"{name}, line {line}: not UTF-8 text; save the scene as UTF-8") from None


def _plain(value: Any) -> Any:
    """Arrays and numbers of numpy as Python's own, in lists and dictionaries too."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    if isinstance(value, (list, tuple, range)):
        return [_plain(one) for one in value]
    if isinstance(value, Mapping):
        return {key: _plain(one) for key, one in value.items()}
    return value

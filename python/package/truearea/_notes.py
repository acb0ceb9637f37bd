"""Notes on results: text that knows how serious it is."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Iterable
from typing import Any, NamedTuple, cast

from truearea._choices import NoteLevel

_NativeNote = tuple[str, str, str, tuple[list[str], "int | None", "int | None", "str | None"]]
"""Text, level, code and place of a note, as the core gives it."""


class Caution(UserWarning):
    """A note that changes what to conclude from a result; the filters of ``warnings`` decide how often it is shown."""


class Place(NamedTuple):
    """The place that a note points to, as far as it is known."""

    files: tuple[str, ...] = ()
    """Names of files or scans."""
    row: int | None = None
    """Row of the arrays, counted from 0 in C order."""
    line: int | None = None
    """Line of a scene, counted from 1."""
    key: str | None = None
    """Argument of the call, or key of a scene with its section."""


class Note(str):
    """Note on a result: an assumption, an omission or a doubt, as text with its kind.

    Attributes
    ----------
    level : {"note", "caution", "error"}
        A caution changes what to conclude from a result; with an error part of it is missing, because its input is bad.
    code : str
        The kind of the note, the same for every wording and value, such as ``"doubt.softer-than-its-ratio"``.
    place : Place
        The files, row, line or key that it is about; empty where it is about the whole result.

    Examples
    --------
    >>> import truearea as ta
    >>> soft = ta.Material(210.0, 0.3)
    >>> curve = ta.persson(ta.read_psd("builtin:uncd-measured"), soft, pressure=1e6)
    >>> [note.code for note in curve.notes if note.level == "caution"]
    ['doubt.softer-than-its-ratio', 'doubt.real-above-third-modulus']
    """

    __slots__ = ("code", "level", "place")

    code: str
    level: NoteLevel
    place: Place

    def __new__(cls, text: str, level: NoteLevel = "note", code: str = "", place: Place = Place()) -> Note:
        note = super().__new__(cls, text)
        note.level, note.code, note.place = level, code, place
        return note

    @property
    def text(self) -> str:
        """The words alone."""
        return str(self)

    def __reduce__(self) -> tuple[Any, ...]:
        return (Note, (str(self), self.level, self.code, self.place))


def counted(notes: tuple[Note, ...]) -> str:
    """Counts errors, cautions and notes; empty text without any."""
    counts = {level: sum(note.level == level for note in notes) for level in ("error", "caution", "note")}
    words = [f"{count} {kind}{'s' if count > 1 else ''}" for kind, count in counts.items() if count]
    return f", {', '.join(words)}" if words else ""


def notes_of(native: Iterable[_NativeNote]) -> tuple[Note, ...]:
    """Converts notes of the core."""
    return tuple(
        Note(text, cast(NoteLevel, level), code, Place(tuple(place[0]), *place[1:])) for text, level, code, place in native
    )


def noted(native: Iterable[_NativeNote]) -> tuple[Note, ...]:
    """Notes on the result of a call, whose cautions become warnings at the place that called the package."""
    notes = notes_of(native)
    for note in notes:
        if note.level == "caution":
            warnings.warn(note.removeprefix("warning: "), Caution, stacklevel=_outside())
    return notes


def _outside() -> int:
    """How far the frame that called the package is above the caller of this function."""
    frame, level = sys._getframe(1), 1
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] == "truearea":
        frame, level = frame.f_back, level + 1
    return level

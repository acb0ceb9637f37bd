"""Notes on results: text that knows how serious it is."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Iterable
from types import FrameType
from typing import Any


class Caution(UserWarning):
    """A note that changes what to conclude from a result; each place that calls is warned once of each kind."""


class Note(str):
    """Note on a result: an assumption, an omission or a doubt, as text with its kind.

    Attributes
    ----------
    level : {"note", "caution"}
        A caution changes what to conclude from a result.
    code : str
        The kind of the note, the same for every wording and value, such as ``"doubt.softer-than-its-ratio"``.

    Examples
    --------
    >>> import truearea as ta
    >>> soft = ta.Material(210.0, 0.3)
    >>> curve = ta.persson(ta.read_psd("builtin:uncd-measured"), soft, pressure=1e6)
    >>> [note.code for note in curve.notes if note.level == "caution"]
    ['doubt.softer-than-its-ratio', 'doubt.real-above-third-modulus']
    """

    __slots__ = ("code", "level")

    code: str
    level: str

    def __new__(cls, text: str, level: str = "note", code: str = "") -> Note:
        note = super().__new__(cls, text)
        note.level, note.code = level, code
        return note

    @property
    def text(self) -> str:
        """The words alone."""
        return str(self)

    def __reduce__(self) -> tuple[Any, ...]:
        return (Note, (str(self), self.level, self.code))


def counted(notes: tuple[Note, ...]) -> str:
    """How many cautions and notes there are; nothing where there are none."""
    cautions = sum(note.level == "caution" for note in notes)
    counts = {"caution": cautions, "note": len(notes) - cautions}
    words = [f"{count} {kind}{'s' if count > 1 else ''}" for kind, count in counts.items() if count]
    return f", {', '.join(words)}" if words else ""


def notes_of(told: Iterable[tuple[str, str, str]]) -> tuple[Note, ...]:
    """Notes of texts with levels and codes."""
    return tuple(Note(*one) for one in told)


_WARNED: set[tuple[str, int, str]] = set()
"""Places that were warned, each with the code of the note: the same kind is not told again for other values."""


def noted(native: Iterable[tuple[str, str, str]]) -> tuple[Note, ...]:
    """Notes on the result of a call, whose cautions become warnings at the place that called the package."""
    notes = notes_of(native)
    if not notes:
        return notes
    cautions = [note for note in notes if note.level == "caution"]
    if cautions:
        frame, level = _outside()
        for note in cautions:
            place = (frame.f_code.co_filename, frame.f_lineno, note.code)
            if place not in _WARNED:
                _WARNED.add(place)
                warnings.warn(str(note), Caution, stacklevel=level)
    return notes


def _outside() -> tuple[FrameType, int]:
    """The frame that called the package, and how far it is above the caller of this function."""
    frame, level = sys._getframe(1), 1
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] == "truearea":
        frame, level = frame.f_back, level + 1
    return frame, level

"""Notes on results: text that knows how serious it is."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Iterable
from typing import Any


class Caution(UserWarning):
    """A note that changes what to conclude from a result; each place that calls is warned once."""


class Note(str):
    """What was assumed, left out, or is doubtful, as text with its kind.

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

    def __reduce__(self) -> tuple[Any, ...]:
        return (Note, (str(self), self.level, self.code))


def notes_of(told: Iterable[tuple[str, str, str]]) -> tuple[Note, ...]:
    """Notes of texts with levels and codes."""
    return tuple(Note(*one) for one in told)


def noted(native: Iterable[tuple[str, str, str]]) -> tuple[Note, ...]:
    """Notes on the result of a call, whose cautions become warnings at the place that called the package."""
    notes = notes_of(native)
    for note in notes:
        if note.level == "caution":
            warnings.warn(str(note), Caution, stacklevel=_outside())
    return notes


def _outside() -> int:
    """How many frames above the caller of this function the package was called."""
    frame, level = sys._getframe(1), 1
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] == "truearea":
        frame, level = frame.f_back, level + 1
    return level

"""Progress of long work: a line on stderr, or a callable."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Union

Watcher = Callable[[int, "int | None"], object]
"""A callable that receives the steps done and their number, None if unknown."""

Progress = Union[bool, Watcher]
"""True for a line on stderr, False for nothing, or a callable."""

Observer = Callable[[str, int, "int | None"], object]


class Line:
    """A line on stderr, written anew at most ten times a second, and gone in the end."""

    def __init__(self) -> None:
        self._width = 0
        self._shown = 0.0

    def __call__(self, steps: str, done: int, total: int | None) -> None:
        now = time.monotonic()
        if now - self._shown < 0.1:
            return
        self._shown = now
        self._write(f"{done} {steps}" if total is None else f"{done} of {total} {steps}")

    def _write(self, text: str) -> None:
        print(f"\r{text:<{self._width}}", end="", file=sys.stderr, flush=True)
        self._width = len(text)

    def end(self) -> None:
        """Wipes the line."""
        if self._width:
            self._write("")
            print("\r", end="", file=sys.stderr, flush=True)


@contextmanager
def observed(progress: Progress | None) -> Iterator[Observer | None]:
    """Gives the observer for a request of progress; its line is gone in the end."""
    if progress is None or progress is False:
        yield None
    elif progress is True:
        line = Line()
        try:
            yield line
        finally:
            line.end()
    elif callable(progress):
        yield lambda _, done, total: progress(done, total)
    else:
        raise TypeError(f"progress: give True, False or a callable, not a value of type {type(progress).__name__}")

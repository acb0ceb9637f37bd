"""The number of threads that the work takes: for some calls, or for as long as a worker's task lasts."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager
from typing import overload

from truearea import _native

_lock = threading.Lock()
_tasks = 0
_before = 1


@overload
def threads(count: None = None) -> int: ...
@overload
def threads(count: int) -> AbstractContextManager[None]: ...
def threads(count: int | None = None) -> int | AbstractContextManager[None]:
    """Returns the number of threads; with a number, lets the calls within a ``with`` block take so many.

    Examples
    --------
    >>> import truearea as ta
    >>> with ta.threads(2):
    ...     ta.threads()
    2
    """
    return _native.threads() if count is None else _while_within(count)


@contextmanager
def _while_within(count: int) -> Iterator[None]:
    before = _native.threads()
    _native.set_threads(count)
    try:
        yield
    finally:
        _native.set_threads(before)


@contextmanager
def one_thread() -> Iterator[None]:
    """Work takes one thread; what was set before comes back with the end of the last task."""
    global _tasks, _before
    with _lock:
        if _tasks == 0:
            _before = _native.threads()
            _native.set_threads(1)
        _tasks += 1
    try:
        yield
    finally:
        with _lock:
            _tasks -= 1
            if _tasks == 0:
                _native.set_threads(_before)

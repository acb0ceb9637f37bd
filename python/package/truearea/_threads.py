"""The number of threads that the work takes: for some calls, or for as long as a worker's task lasts."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager
from typing import overload

from truearea import _native

_lock = threading.Lock()
_blocks: dict[object, int] = {}
"""The numbers of the blocks that are open, in any thread; the latest counts."""
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
    return _native.threads() if count is None else within(count)


@contextmanager
def within(count: int) -> Iterator[None]:
    """Work takes so many threads; what was set before comes back with the end of the last block of any thread."""
    global _before
    block = object()
    with _lock:
        before = _native.threads()
        _native.set_threads(count)
        if not _blocks:
            _before = before
        _blocks[block] = count
    try:
        yield
    finally:
        with _lock:
            del _blocks[block]
            _native.set_threads(next(reversed(_blocks.values()), _before))

"""One thread for as long as a worker's task lasts, however many tasks a process does at once."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager

from truearea import _native

_lock = threading.Lock()
_tasks = 0
_before = 1


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

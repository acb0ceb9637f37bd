"""Digests of functions and values: equal for equal code and state, in any process."""

from __future__ import annotations

import copyreg
import dis
import functools
import sys
import sysconfig
from collections.abc import Iterable, Mapping
from pathlib import Path
from types import CodeType, FunctionType, MethodType, ModuleType
from typing import TYPE_CHECKING, Any

from truearea._native import InputError
from truearea._scene import Scene

if TYPE_CHECKING:
    import hashlib

_PLAIN = (type(None), bool, int, float, complex, str, bytes, type(Ellipsis), type(NotImplemented))
# Attributes of a class that differ between processes, or say nothing of what its objects do.
_IDLE = ("_abc_impl", "__dict__", "__weakref__", "__doc__", "__module__", "__annotations__", "__dataclass_fields__",
         "__dataclass_params__", "__firstlineno__", "__static_attributes__", "__annotate_func__", "__annotations_cache__")  # fmt: skip


def sha256(content: bytes = b"") -> hashlib._Hash:
    """A checksum to begin with, from a library that takes longer to import than all else of the package."""
    import hashlib

    return hashlib.sha256(content)


def digest_of(value: Any, name: str) -> str:
    """The digest of a function, a scene, an object, or a value of ``over``; ``name`` says in messages whose it is.

    Code counts with the globals, the captured values and the state of objects that it uses; installed packages by their names.
    """
    return _Digests(name).of(value, name).hex()


def name_of(function: Any) -> str:
    """The name of a function or of the class of an object."""
    if isinstance(function, functools.partial):
        return f"partial of {name_of(function.func)}"
    return f"{getattr(function, '__module__', '')}.{getattr(function, '__qualname__', type(function).__qualname__)}"


class _Digests:
    """Digests of the values that one value refers to. A value within itself counts by its depth."""

    def __init__(self, name: str) -> None:
        self._name = name
        # Values are held, so that no other takes the identity of one that is gone.
        self._done: dict[int, tuple[Any, bytes]] = {}
        self._open: dict[int, int] = {}

    def of(self, value: Any, place: str) -> bytes:
        """The digest of a value; ``place`` says in messages where it was found."""
        if isinstance(value, _PLAIN) and type(value) in _PLAIN:
            return _sha(type(value).__name__, repr(value))
        if id(value) in self._done:
            return self._done[id(value)][1]
        if id(value) in self._open:
            return _sha("within itself", str(self._open[id(value)]))
        self._open[id(value)] = len(self._open)
        try:
            found = self._of_compound(value, place)
        finally:
            del self._open[id(value)]
        self._done[id(value)] = (value, found)
        return found

    def _of_compound(self, value: Any, place: str) -> bytes:
        kind = type(value)
        if kind in (list, tuple):
            return _sha(kind.__name__, *self._each(value, place))
        if kind in (set, frozenset):
            return _sha(kind.__name__, *sorted(self._each(value, place)))
        if kind is dict:
            return _sha("dict", *self._items(value, place))
        if isinstance(value, CodeType):
            return self._of_code(value, place)
        if isinstance(value, ModuleType):
            file = getattr(value, "__file__", None)
            is_own = file is not None and not _is_installed(value.__name__)
            return _sha("module", value.__name__, Path(str(file)).read_bytes() if is_own else b"")
        if isinstance(value, (FunctionType, type)) and _is_installed(value.__module__):
            return _sha("installed", name_of(value))
        if isinstance(value, FunctionType):
            return self._of_function(value, place)
        if isinstance(value, type):
            attributes = {name: value.__dict__[name] for name in sorted(value.__dict__) if name not in _IDLE}
            return _sha("class", name_of(value), *self._each(value.__bases__, place), *self._items(attributes, place))
        if isinstance(value, MethodType):
            return _sha("method", *self._each((value.__func__, value.__self__), place))
        if isinstance(value, (staticmethod, classmethod)):
            return _sha(kind.__name__, self.of(value.__func__, place))
        if isinstance(value, property):
            return _sha("property", *self._each((value.fget, value.fset), place))
        if isinstance(value, functools.cached_property):
            return _sha("property", self.of(value.func, place))
        if kind.__name__ in ("member_descriptor", "getset_descriptor"):
            return _sha(kind.__name__, value.__name__)
        if isinstance(value, Scene):
            text, _, _, files, overrides, spectrum = value._recipe
            of_surface = b"" if spectrum is None else spectrum._native.csv()
            given = {key: str(overrides[key]) for key in sorted(overrides)}
            return _sha("scene", *self._each((text, dict(files), given, of_surface), place))
        if isinstance(value, functools.partial):
            return _sha(
                "partial", *self._each((value.func, value.args, value.__dict__), place), *self._items(value.keywords, place)
            )
        wrapped = getattr(value, "__wrapped__", None)
        if callable(value) and wrapped is not None:
            return _sha("wrapper", name_of(kind), self.of(wrapped, place))
        return self._of_object(value, place)

    def _of_object(self, value: Any, place: str) -> bytes:
        """An object by its class and by what pickle makes of its state."""
        try:
            reduce = copyreg.dispatch_table.get(type(value))
            reduced = reduce(value) if reduce else value.__reduce_ex__(4)
        except Exception as error:
            raise InputError(
                f"{self._name} uses {place}, of type {type(value).__name__}, which no folder can tell from another "
                f"({error}); make it within the function, or sweep without to"
            ) from None
        if isinstance(reduced, str):
            return _sha("named", getattr(value, "__module__", None) or "", reduced)
        function, arguments, *state = reduced
        parts = [list(part) if at in (1, 2) and part is not None else part for at, part in enumerate(state)]
        head = self._each((type(value), function), place)
        state_digests = self._items(parts[0], place) if parts and type(parts[0]) is dict else self._each(parts[:1], place)
        return _sha("object", *head, self.of(arguments, place), *state_digests, *self._each(parts[1:], place))

    def _of_function(self, function: FunctionType, place: str) -> bytes:
        used = sorted(_globals_of(function.__code__) & function.__globals__.keys())
        captured: dict[str, Any] = {}
        for name, cell in zip(function.__code__.co_freevars, function.__closure__ or ()):
            try:
                captured[name] = cell.cell_contents
            except ValueError:
                captured[name] = NotImplemented
        return _sha(
            "function",
            name_of(function),
            self._of_code(function.__code__, place),
            *self._each((function.__defaults__, function.__kwdefaults__), place),
            *self._items(captured, ""),
            *self._items({name: function.__globals__[name] for name in used}, ""),
        )

    def _of_code(self, code: CodeType, place: str) -> bytes:
        names = (code.co_names, code.co_varnames, code.co_freevars, code.co_cellvars)
        return _sha("code", code.co_code, *self._each((*names, code.co_consts), place))

    def _each(self, values: Iterable[Any], place: str) -> list[bytes]:
        return [self.of(value, place) for value in values]

    def _items(self, values: Mapping[Any, Any], place: str) -> list[bytes]:
        found = []
        for name, value in values.items():
            found += [self.of(name, place), self.of(value, f"{place}.{name}".lstrip("."))]
        return found


def _globals_of(code: CodeType) -> set[str]:
    """The globals that some code reads, functions within it included."""
    names = {one.argval for one in dis.get_instructions(code) if one.opname in ("LOAD_GLOBAL", "LOAD_NAME")}
    return names.union(*(_globals_of(one) for one in code.co_consts if isinstance(one, CodeType)))


# Where Python and its packages are.
_LIBRARIES = tuple(sysconfig.get_paths()[of] for of in ("stdlib", "platstdlib", "purelib", "platlib"))


def _is_installed(module: str) -> bool:
    """Whether a module belongs to Python or to an installed package, as opposed to code that users write."""
    if module.partition(".")[0] == "truearea":
        return True
    if module == "__main__":
        return False
    file = getattr(sys.modules.get(module), "__file__", None)
    if file is None:
        return module in sys.modules
    return any(Path(file).is_relative_to(folder) for folder in _LIBRARIES)


def _sha(*parts: str | bytes) -> bytes:
    content = sha256()
    for part in parts:
        encoded = part.encode("utf-8", "surrogatepass") if isinstance(part, str) else part
        content.update(len(encoded).to_bytes(8, "little") + encoded)
    return content.digest()

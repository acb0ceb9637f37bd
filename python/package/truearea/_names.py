"""The names that calls take, and the versions at work."""

from __future__ import annotations

import sys

from truearea import _native
from truearea._options import documented
from truearea._results import AnyArray, FloatArray, Table


class Materials(Table):
    """The materials that are known by name, properties as text with their units, empty where the source has none."""

    _title = "materials"
    __slots__ = ()
    name: AnyArray
    aliases: AnyArray
    youngs_modulus: AnyArray
    poisson_ratio: FloatArray
    yield_strength: AnyArray
    indentation_hardness: AnyArray
    thermal_conductivity: AnyArray
    resistivity: AnyArray
    sources: AnyArray


class Models(Table):
    """The models: ``model`` as it is typed, other names, options and publication."""

    _title = "models"
    __slots__ = ()
    model: AnyArray
    short_name: AnyArray
    full_name: AnyArray
    framework: AnyArray
    options: AnyArray
    citation: AnyArray


@documented
def materials() -> Materials:
    """List the materials that ``Material("NAME")`` knows, with the source of each.

    Examples
    --------
    >>> import truearea as ta
    >>> table = ta.materials()
    >>> str(table.youngs_modulus[list(table.name).index("steel 100Cr6")])
    '210 GPa'
    """
    return Materials._of(_native.materials_table())


@documented
def models() -> Models:
    """List the models, with their options and citations.

    Examples
    --------
    >>> import truearea as ta
    >>> "hertz" in ta.models().model
    True
    """
    return Models._of(_native.models_table())


def show_versions() -> None:
    """Print the versions of truearea, Python and the packages that it works with: for reports of errors."""
    # They take longer to import than all else of the package.
    import platform
    from importlib import metadata

    print(f"truearea    {_native.VERSION}")
    print(f"python      {platform.python_version()} ({sys.platform}, {platform.machine()})")
    for package in ("numpy", "pandas", "xarray", "matplotlib", "pint", "dask"):
        try:
            version = metadata.version(package)
        except metadata.PackageNotFoundError:
            version = "not installed"
        print(f"{package:<11} {version}")
    print(f"threads     {_native.threads()}")

"""Arguments that several calls share: each is typed and documented here, once."""

from __future__ import annotations

import functools
import inspect
import re
import textwrap
from collections.abc import Callable, Sequence
from difflib import get_close_matches
from typing import TYPE_CHECKING, Any, TypedDict, TypeVar, cast

from truearea import _native

if TYPE_CHECKING:
    import numpy.typing as npt
    from typing_extensions import Unpack as Unpack

    from truearea._choices import (
        Band,
        Detrend,
        EnergyFactor,
        Flattening,
        HardnessFormula,
        InterferenceLaw,
        Normalisation,
        Phases,
        SummitHeights,
    )
    from truearea._grammar import AnySurface
    from truearea._material import Quantity
    from truearea._progress import Progress
else:
    # Checkers alone unpack dictionaries of options.
    Unpack = dict

Call = TypeVar("Call", bound=Callable[..., Any])


class TwoFaces(TypedDict, total=False):
    """The roughness of the other face."""

    counterface_surface: AnySurface | None


class Sampling(TypedDict, total=False):
    """Scales of the spectrum that take part."""

    cutoff: Quantity | None
    scales_per_decade: int | None


class Asperities(TypedDict, total=False):
    """How an asperity deforms."""

    strain_gradient: bool | None
    hardness_formula: HardnessFormula | None
    flattening: Flattening | None
    interference_law: InterferenceLaw | None


class MeanGap(TypedDict, total=False):
    """The mean gap of Persson's theory."""

    gamma: EnergyFactor | None
    band: Band | None


class RandomSurfaces(TypedDict, total=False):
    """Random surfaces with a spectrum, for boundary elements."""

    grid: int | None
    realisations: int | None
    seed: int | None
    longest: Quantity | None
    shortest: Quantity | None
    side: Quantity | None
    phases: Phases | None


class StackedOptions(TwoFaces, Sampling):
    """Options of stacks."""


class PerssonOptions(TwoFaces, Sampling, MeanGap):
    """Options of Persson's theory."""


class StatisticalOptions(TwoFaces, Sampling, Asperities, total=False):
    """Options of statistical models."""

    normalisation: Normalisation | None


class PopulationOptions(StatisticalOptions, total=False):
    """Options of statistical models against the cutoff."""

    summit_heights: SummitHeights | None


class GapOptions(StatisticalOptions, MeanGap):
    """Options of models with a mean gap."""


class GapAndSurfaceOptions(GapOptions, RandomSurfaces):
    """Options of models with a mean gap, and of random surfaces for boundary elements."""


class PressOptions(RandomSurfaces, total=False):
    """A map of heights, or random surfaces, and how boundary elements press them; the other face is of the kind of the surface."""

    counterface_surface: Any
    size: Quantity | Sequence[Quantity] | npt.NDArray[Any] | None
    detrend: Detrend | None
    tolerance: float | None
    progress: Progress | None


class FlatOptions(PressOptions, total=False):
    """A map or random surfaces under a flat."""

    periodic: bool | None
    per_realisation: bool | None


def with_options(*groups: Any) -> Callable[[Call], Call]:
    """Makes the options of some groups arguments of a function that takes them as ``**options``.

    They appear in its signature and its docstring, and a name that is not among them is a TypeError.
    """

    def decorate(call: Call) -> Call:
        signature = inspect.signature(call)
        options = dict.fromkeys(name for group in groups for name in group.__annotations__)
        named = [one for one in signature.parameters.values() if one.kind is not inspect.Parameter.VAR_KEYWORD]
        named += [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=None) for name in options]
        known = frozenset(one.name for one in named)

        @functools.wraps(call)
        def checked(*given: Any, **arguments: Any) -> Any:
            if not known.issuperset(arguments):
                unknown = min(arguments.keys() - known)
                near = "".join(f"; did you mean {name}?" for name in get_close_matches(unknown, known, 1))
                instead = _native.way_out(unknown) if unknown != "work_of_adhesion" or call.__name__ == "ball" else None
                raise TypeError(f"{call.__name__}() takes no argument {unknown}{f': {instead}' if instead else near}")
            return call(*given, **arguments)

        vars(checked)["__signature__"] = signature.replace(parameters=named)
        return documented(cast(Call, checked))

    return decorate


def documented(call: Call) -> Call:
    """Adds to the docstring of a function the shared entries of its arguments, and those of the classes that it returns."""
    arguments = list(inspect.signature(call).parameters)
    known = inspect.unwrap(call).__globals__
    results = {name: known[name] for name in call.__annotations__["return"].split(" | ")}
    returns = [result_entry(name, kind.__doc__ or "", _arrays(kind)) for name, kind in results.items()]
    call.__doc__ = completed(call.__doc__ or "", arguments, returns)
    return call


def _arrays(result: type) -> list[str]:
    """Names of the arrays that a class of results declares."""
    declared = [inspect.get_annotations(base) for base in reversed(inspect.getmro(result))]
    return [name for annotations in declared for name, kind in annotations.items() if str(kind).endswith("Array")]


def result_entry(result: str, docstring: str, arrays: list[str]) -> str:
    """Describes a result by the docstring of its class and the names of its arrays."""
    listed = textwrap.fill("Arrays: " + ", ".join(f"``{name}``" for name in arrays), 124)
    return "\n".join([result, textwrap.indent(f"{inspect.cleandoc(docstring)}\n\n{listed}", "    ")])


def completed(docstring: str, arguments: list[str], returns: list[str]) -> str:
    """Adds the sections and entries that a docstring does not have itself, entries in the order of the arguments."""
    head, *sections = re.split(r"\n\n(?=[A-Z][a-z]+\n---)", inspect.cleandoc(docstring))
    own = {title: entries for title, _, entries in (section.split("\n", 2) for section in sections)}
    entries = _ENTRIES | _entries(own.pop("Parameters", ""))
    shared = {"Returns": "\n".join(returns)}
    if arguments:
        parameters = "\n".join(dict.fromkeys(entries[name] for name in arguments if name in entries))
        raises = "InputError\n    With argument, value and bound; also for options without effect."
        shared = {"Parameters": parameters, **shared, "Raises": raises}
    return "\n\n".join([head, *(f"{title}\n{'-' * len(title)}\n{text}" for title, text in (shared | own).items())])


def _entries(text: str) -> dict[str, str]:
    """The entries of a section, by the names of the arguments that each describes."""
    return {name: entry for entry in re.split(r"\n(?! )", text) for name in entry.partition(" :")[0].split(", ")}


_ENTRIES = _entries("""\
surface : Spectrum, Scan, sequence of scans, or path of a spectrum
    The roughness.
counterface_surface : as ``surface``, optional
    The roughness of the other face; smooth where left out. Spectra add; a map that faces a map is turned over and added.
material : Material or str
    The bodies in contact, or the name of a material of the table.
pressure : float, str, or sequence of them
    Nominal pressures, in Pa or as text such as ``"5 MPa"`` or ``"1e-3 H"``.
gamma : float or "fitted", optional
    Elastic energy factor of the mean gap in Persson's theory, above 0 and at most 1 (Almqvist et al. 2011), 0.45 where left
    out; or the form fitted to boundary elements.
band : {"1d", "2d"}, optional
    The spectrum that a cutoff ends in Persson's theory: that of the surface, ``"2d"``, as where left out and nearer to boundary
    elements, or that of profiles.
strain_gradient : bool, default False
    Let the strength grow at small depths, with the material's ``strain_gradient_length``.
hardness_formula : {"2005", "cosine"}, optional
    The form of the hardness of spheres that yield.
flattening : {"area-and-force", "area"}, optional
    The quantities of flattened spheres that no longer grow: both from a contact radius of 0.41 R on, as where left out, or the
    area from R on.
elastic_plastic_area : {"blended", "elastic-shape"}, optional
    The area of a scale of a stack that yields: the published fit limited to 1, as where left out, or the elastic area at p/p*_ep.
interference_law : {"rostami-jackson", "bem"}, optional
    The relation between pressure and interference of elastic sinusoids.
summit_heights : {"gaussian", "exponential"}, optional
    The distribution of the heights of elastic spheres: Gaussian where left out; exponential ones have the standard deviation
    sigma_s, and separations from their least height.
normalisation : {"parseval", "as-printed"}, optional
    The factor of the moments of statistical models: 1/pi, with which m0 is the mean square height; or 1, as Jackson & Jacobs
    print it.
amplitude : {"eq5", "parseval"}, optional
    How the amplitude of a scale is made from the spectrum: by Eq. 5 of Jackson & Jacobs where left out.
tolerance : float, default 1e-12
    Relative tolerance of statistical states, above 0 and at most 0.01.
cutoff : float or str, optional
    The shortest wavelength that takes part, in m or as text such as ``"5 nm"``.
scales_per_decade : int, optional
    Resample to so many wavelengths a decade, as sampled where left out; areas of ``stacked`` depend on it.
grid : int, default 512
    Points along each side of a random surface, from 16 to 16384.
realisations : int, default 8
    How many surfaces are made of the spectrum.
seed : int, default 1
    The seed of their phases.
longest, shortest : float or str, optional
    The longest and the shortest wavelength of the surfaces; where left out, that of the spectrum for the shortest, and as
    long as the grid holds for the longest.
side : float or str, optional
    Length of a side of the surfaces.
phases : {"fixed-modulus", "gaussian"}, optional
    What is random: phases alone, or moduli as well.
size : float or str, or two of them, optional
    Lengths (lx, ly) of the map in m or as text, ``columns`` and ``rows`` spacings; one for a square of as many rows as columns.
    Scans, topographies and spectra know their own.
detrend : {"plane", "line", "mean", "none"}, optional
    What is subtracted from heights: by default a plane, from those that repeat themselves the mean.
periodic : bool, default False
    What lies beyond the edges of a map: the map again, or an unloaded half-space. Of a scan or topography what it says itself,
    where left out.
per_realisation : bool, default False
    Return each random surface instead of their mean.
work_of_adhesion : float or str
    Work of adhesion w in J/m² or as text such as ``"50 mJ/m^2"``.
adhesion_range : float or str
    Range rho of the attraction, in m or as text such as ``"2 nm"``.
progress : bool or callable, default False
    True shows a line on stderr; a callable receives the steps done and their number, None where it is not known.""")

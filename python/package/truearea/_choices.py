"""Names that calls take, as types: a mistyped one is found by a type checker, and offered by an editor."""

from __future__ import annotations

from typing import Literal

StackedModel = Literal["elastic-plastic", "elastic"]
"""Models of the stack."""

StatisticalModel = Literal["hertz", "ep-sphere", "elastic-sine", "ep-sine", "bgt"]
"""Models of a population of asperities."""

PerssonModel = Literal["elastic", "elastic-plastic"]
"""Persson's theory for bodies that do not yield, and that do."""

LawModel = Literal["persson", "persson-plastic", "hertz", "ep-sphere", "elastic-sine", "ep-sine", "bgt"]
"""Models that know a distance between the surfaces."""

GapModel = Literal["persson", "persson-plastic", "hertz", "ep-sphere", "elastic-sine", "ep-sine", "bgt", "bem"]
"""Models that know a distance between the surfaces, and boundary elements."""

ShearedModel = Literal["persson", "hertz", "elastic-sine", "bgt", "bem"]
"""Models that know a distance between the surfaces and do not yield."""

Band = Literal["1d", "2d"]
"""Waves that a cutoff ends: those of profiles, or those of the surface."""

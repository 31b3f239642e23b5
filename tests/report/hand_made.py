"""Results built by hand, so that what is shown can be tested without computing anything.

The numbers of the eleven bearings are those of a published study of a marine reverse gear (2023), tables 4 and 5.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from babbitt.core.kind import Kind
from babbitt.core.notices import Notice
from babbitt.core.result import Bound, Check, Outcome, Result
from babbitt.core.solution import Solution
from babbitt.kinds.journal.report.views import ISO7902
from babbitt.report.view import View

ZERO_CELSIUS = 273.15

# name, p̄ MPa, h_min µm, h_lim µm, T_ex, T_eff, Q3, Qp l/min, Re, Re_cr, ψ permille, ε
PUBLISHED = (
    ("Input pinion, gas turbine", 1.24, 89, 16, 77, 63, 26.2, 9.9, 445, 1077, 1.47, 0.52),
    ("First-stage wheel", 1.19, 86, 16, 72, 61, 21.9, 9.6, 235, 1267, 1.06, 0.54),
    ("Second-stage pinion (a)", 2.51, 47, 16, 88, 69, 8.5, 4.0, 226, 1259, 1.08, 0.71),
    ("Second-stage pinion (b)", 2.51, 57, 16, 76, 63, 17.8, 3.4, 196, 1250, 1.09, 0.66),
    ("Output wheel", 2.10, 49, 16, 60, 55, 12.0, 7.9, 52, 1467, 0.79, 0.77),
    ("Input pinion, electric motor", 1.63, 51, 16, 59, 54, 9.2, 9.3, 89, 1065, 1.50, 0.73),
    ("MRP drive pinion", 2.40, 51, 16, 70, 60, 19.0, 12.3, 197, 1304, 1.00, 0.71),
    ("MRP pinion left", 1.02, 91, 16, 70, 60, 19.8, 9.4, 213, 1266, 1.06, 0.51),
    ("MRP wheel left", 1.87, 68, 16, 71, 60, 22.1, 10.7, 210, 1266, 1.06, 0.64),
    ("MRP wheel right", 1.89, 66, 16, 69, 60, 21.0, 10.9, 196, 1265, 1.07, 0.65),
    ("MRP pinion right", 1.02, 91, 16, 70, 60, 19.8, 9.4, 213, 1266, 1.06, 0.51),
)


VIEW = View("ISO 7902", ISO7902.key_results, columns=ISO7902.columns, overview=ISO7902.overview)
"""Of results that nothing was computed for: no inputs, no calculation, no figures."""

KIND = Kind("hand_made", "results built by hand", "", "", views={"iso7902": "hand_made:VIEW"})


@dataclass(frozen=True)
class HandMadeProblem:
    """What the reports read of a problem."""

    name: str
    given: tuple[tuple[str, str], ...] = ()
    warnings: tuple[Notice, ...] = ()


@dataclass(frozen=True)
class HandMadeMachine:
    """What the reports read of a solved machine."""

    name: str
    results: tuple[Result, ...]
    problems: tuple[object, ...] = ()
    case_hash: str = "0f1e2d3c4b5a69788796a5b4c3d2e1f00f1e2d3c4b5a69788796a5b4c3d2e1f0"
    version: str = "0.1.0"
    case_text: str = ""
    source: str = ""
    notes: str = ""
    own_words: tuple[str, ...] = ()
    title_block: None = None
    given: Mapping[str, frozenset[str]] = field(default_factory=dict)

    @property
    def solutions(self) -> tuple[Solution, ...]:
        problems = self.problems or [HandMadeProblem(result.name) for result in self.results]
        return tuple(Solution(*pair) for pair in zip(problems, self.results, strict=True))


def hand_made_result(row: tuple[object, ...]) -> Result:
    name, p, film, limit, t_ex, t_eff, q3, qp, re, re_cr, psi, eps = row
    values = {
        "specific_load": p * 1e6,
        "surface_speed": 24.0,
        "operating_relative_clearance": psi * 1e-3,
        "supply_temperature": 50.0 + ZERO_CELSIUS,
        "outlet_temperature": t_ex + ZERO_CELSIUS,
        "effective_temperature": t_eff + ZERO_CELSIUS,
        "eccentricity_ratio": eps,
        "minimum_film_thickness": film * 1e-6,
        "friction_power": 28.3e3,
        "side_flow": q3 / 6e4,
        "supply_flow": qp / 6e4,
        "film_reynolds_number": float(re),
        "critical_reynolds_number": float(re_cr),
        "wall_time": 0.01,
    }
    checks = (
        Check("C101", "minimum_film_thickness", film * 1e-6, limit * 1e-6, Bound.AT_LEAST, "surface geometry"),
        Check("C102", "specific_load", p * 1e6, 15e6, Bound.AT_MOST, "B83, calm load"),
        Check("C103", "outlet_temperature", t_ex + ZERO_CELSIUS, 110 + ZERO_CELSIUS, Bound.AT_MOST, "experience"),
    )
    return Result(str(name), KIND.name, "iso7902", Outcome.CONVERGED, values, checks)

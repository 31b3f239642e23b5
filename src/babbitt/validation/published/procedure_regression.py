"""Two bearings computed by an independent prototype of the procedure."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

from babbitt.core.result import Result
from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.journal.iso7902.model import Bearing, DesignCase, Friction, OilSupply, PrescribedLoad
from babbitt.kinds.journal.iso7902.procedure import check
from babbitt.kinds.journal.iso7902.supply import Arrangement, Holes, Pockets
from babbitt.properties.lubricants import Lubricant, OilProperties, lubricant_from_points
from babbitt.validation.case import Comparison, Evidence, Story, ValidationCase
from babbitt.validation.figure import draw_deviations
from babbitt.validation.tolerance import Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_RPM = math.pi / 30.0
_SOURCE = "independent prototype"
_VALUE = Within(relative=5e-4)
_KELVIN = Within(absolute=0.01)
_DEGREE = Within(absolute=0.03)


def _oil() -> Lubricant:
    """46 and 6.8 mm²/s at 40 and 100 °C, 870 kg/m³ at 20 °C."""
    properties = OilProperties(
        density=870.0,
        density_temperature=20.0 + ZERO_CELSIUS,
        density_slope=-0.63,
        volumetric_heat_capacity=1.8e6,
    )
    colder, warmer = (40.0 + ZERO_CELSIUS, 46e-6), (100.0 + ZERO_CELSIUS, 6.8e-6)
    return lubricant_from_points("oil 46/6.8", colder, warmer, properties)


def full_bearing() -> DesignCase:
    """A: full bearing, one hole opposite the load, film all around."""
    return DesignCase(
        "A",
        Bearing(0.120, 0.060, 1.12e-3, 360, 23e-6, 11e-6, Holes(0.005, Arrangement.OPPOSITE)),
        PrescribedLoad(36e3),
        2000.0 * _RPM,
        _oil(),
        OilSupply(58.0 + ZERO_CELSIUS, 0.5e6),
    )


def partial_bearing() -> DesignCase:
    """C: arc of 120°, two pockets beside the load, film on the arc."""
    return DesignCase(
        "C",
        Bearing(0.300, 0.200, 1.2e-3, 120, 11e-6, 11e-6, Pockets(0.73 * 0.200, Arrangement.BOTH_SIDES)),
        PrescribedLoad(150e3),
        1400.0 * _RPM,
        _oil(),
        OilSupply(50.0 + ZERO_CELSIUS, 0.15e6),
        friction=Friction.ARC,
    )


_QUANTITIES: tuple[tuple[str, str, Callable[[Result], float], Within, float, float], ...] = (
    ("T_ex", "°C", lambda r: r.outlet_temperature - ZERO_CELSIUS, _KELVIN, 66.226930, 70.908730),
    ("ψ_eff", "‰", lambda r: r.operating_relative_clearance * 1e3, _VALUE, 1.6253616, 1.2),
    ("η_eff", "mPa s", lambda r: r.effective_viscosity * 1e3, _VALUE, 16.170888, 17.142310),
    ("So", "", lambda r: r.sommerfeld_number, _VALUE, 3.9001157, 1.4324402),
    ("ε", "", lambda r: r.eccentricity_ratio, _VALUE, 0.88027594, 0.73859880),
    ("h_min", "µm", lambda r: r.minimum_film_thickness * 1e6, _VALUE, 11.675693, 47.052216),
    ("β", "°", lambda r: math.degrees(r.attitude_angle), _DEGREE, 25.612191, 30.987222),
    ("P_f", "W", lambda r: r.friction_power, _VALUE, 1388.2398, 8110.8944),
    ("Q₃", "L/min", lambda r: r.side_flow * 6e4, _VALUE, 3.6629558, 9.4614723),
    ("Qp", "L/min", lambda r: r.supply_flow * 6e4, _VALUE, 1.9618231, 3.4691623),
    ("Re", "", lambda r: r.film_reynolds_number, _VALUE, 63.921374, 195.01041),
    ("Re_cr", "", lambda r: r.critical_reynolds_number, _VALUE, 1024.4129, 1192.2283),
)


@lru_cache
def run() -> tuple[Comparison, ...]:
    """Compare twelve results of both bearings."""
    return tuple(_rows())


def _rows() -> Iterator[Comparison]:
    first, second = check(full_bearing()), check(partial_bearing())
    for symbol, unit, read, tolerance, expected_first, expected_second in _QUANTITIES:
        for place, expected, result in (("A", expected_first, first), ("C", expected_second, second)):
            yield Comparison(symbol, f"bearing {place}", expected, read(result), tolerance, unit, _SOURCE)


def draw(figure: Figure) -> None:
    """All deviations, a panel for each bearing."""
    figure.set_size_inches(7.2, 3.8)
    panels = figure.subplots(1, 2, sharey=True)
    for axes, place in zip(panels, ("A", "C"), strict=True):
        draw_deviations(axes, [row for row in run() if row.place == f"bearing {place}"])
        axes.set_title(f"bearing {place}")


CASE = ValidationCase(
    name="procedure_regression",
    title="The whole procedure: two bearings by an independent prototype",
    story=Story(
        what=(
            "No worked example of ISO 7902 with its intermediate numbers is public. Two bearings were therefore "
            "computed by a second program, written before Babbitt and without its code: its own tables of "
            "characteristics, its own interpolation, another iteration of the temperature. A is a full bearing of "
            "120 × 60 mm with 36 kN and 2000 rpm, fed by a hole of 5 mm opposite the load; C an arc of 120° of "
            "300 × 200 mm with 150 kN and 1400 rpm, fed by two pockets."
        ),
        source="Independent prototype, temperatures converged to 1e-6 K. Not published.",
        assumptions=(
            "The same formulas, so an error in a formula itself would not show here; the other cases are "
            "there for that. Oil of 46 and 6.8 mm²/s, 870 kg/m³ at 20 °C, ρc = 1.8 MJ/(m³ K). Pockets of "
            "0.73 of the width take the correction q_P of 0.7, where its formula ends."
        ),
        tolerances=(
            "0.05 % of every value, 0.01 K in temperature and 0.03° in the attitude angle: what the "
            "interpolation of the prototype, in a table with fewer nodes, is good for."
        ),
        differences="Only the interpolation of the characteristics.",
    ),
    run=run,
    draw=draw,
    caption="Deviation from the prototype in units of the tolerance.",
    evidence=Evidence.REGRESSION,
)

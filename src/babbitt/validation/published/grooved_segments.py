"""A groove in the loaded zone: identities, own reference numbers, and what its source says of it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.journal.grooved_long_bearing.model import Groove, GrooveKind, SegmentFilm
from babbitt.kinds.journal.grooved_long_bearing.solve import film_at_eccentricity, film_under_load
from babbitt.kinds.journal.grooved_long_bearing.state import SegmentFilmState
from babbitt.properties.lubricants import ConstantProperty, Lubricant, PowerLaw, ViscosityKind
from babbitt.validation.case import Comparison, Story, ValidationCase
from babbitt.validation.figure import GREY, INK, MARKERS
from babbitt.validation.published.long_film_isothermal import exact
from babbitt.validation.reference_data import reference_data
from babbitt.validation.tolerance import AtLeast, AtMost, SetBy, Within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

CELLS = 2000
ANGLES = (135, 150, 165)
DESCRIBED = (20.0 + ZERO_CELSIUS, 120.0 + ZERO_CELSIUS)


def oil(viscosity: float, exponent: float) -> Lubricant:
    """Oil of the power law by its dynamic viscosity at 50 °C in mPa s."""
    data = reference_data("grooved")
    return Lubricant(
        name=f"{viscosity:g} mPa s at 50 °C",
        viscosity_law=PowerLaw(1e-3 * viscosity, exponent, ViscosityKind.DYNAMIC, DESCRIBED),
        density_law=ConstantProperty(data["density"]),
        heat_capacity_law=ConstantProperty(data["heat_capacity"]),
        conductivity_law=ConstantProperty(0.13),
        temperature_range=DESCRIBED,
        source="assumed",
    )


def film(
    kind: str = "none",
    angle: float = 150.0,
    mixing_factor: float = 1.0,
    lubricant: Lubricant | None = None,
    width: float | None = None,
    **more: Any,
) -> SegmentFilm:
    """The published bearing; angle of the groove in degrees, its width in m (published if not given)."""
    data = reference_data("grooved")
    groove = None
    if kind != "none":
        wide = 1e-3 * data["groove_width_mm"] if width is None else width
        groove = Groove(math.radians(angle), wide, GrooveKind(kind), mixing_factor)
    return SegmentFilm(
        diameter=1e-3 * data["diameter_mm"],
        width=1e-3 * data["width_mm"],
        clearance=0.5e-6 * data["relative_clearance_permille"] * data["diameter_mm"],
        surface_speed=data["surface_speed_m_s"],
        lubricant=lubricant or oil(data["viscosity_50_mPas"], data["exponent"]),
        supply_temperature=data["supply_temperature_C"] + ZERO_CELSIUS,
        groove=groove,
        cells=more.pop("cells", CELLS),
        **more,
    )


@lru_cache
def solved(kind: str, angle: float = 150.0, mixing_factor: float = 1.0) -> SegmentFilmState:
    """At the eccentricity of the reference."""
    return film_at_eccentricity(film(kind, angle, mixing_factor), reference_data("grooved")["eccentricity_ratio"])


@lru_cache
def loaded(kind: str, angle: float = 150.0) -> SegmentFilmState:
    """Under the published load."""
    data = reference_data("grooved")
    bearing = film(kind, angle)
    return film_under_load(bearing, 1e6 * data["specific_load_MPa"] * bearing.diameter * bearing.width)


@lru_cache
def run() -> tuple[Comparison, ...]:
    """Identities, reference numbers, published statements, and the finding at equal load."""
    return (*_identities(), *_reference(), *_statements(), *_equal_load())


def _identities() -> Iterator[Comparison]:
    plain = solved("none")
    closed = exact(0.8)
    place = "ungrooved, ε = 0.8"
    yield Comparison(
        "θ₂", place, closed["θ_r"], math.degrees(plain.segments[0].segment.end), Within(relative=1e-4), "°",
        "closed form", 2,
    )  # fmt: skip
    yield Comparison(
        "friction number", place, closed["F"], plain.segments[0].segment.friction, Within(relative=1e-4), "",
        "closed form", 4,
    )  # fmt: skip
    yield Comparison(
        "attitude angle", place, 42.18, math.degrees(plain.attitude_angle), Within(relative=5e-4), "°",
        "closed form", 2,
    )  # fmt: skip


def _reference() -> Iterator[Comparison]:
    for row in reference_data("grooved")["reference"]:
        kind, angle, factor = row["kind"], row["angle"] or 150.0, row["mixing_factor"]
        place = "ungrooved" if kind == "none" else f"{kind} groove at {angle:g}°"
        if factor != 1.0:
            place += f", κ = {factor:g}"
        state = solved(kind, angle, factor)
        load, heat = Within(relative=0.005, absolute=0.05), Within(relative=0.005, absolute=0.5)
        pairs = [("p_m", row["p_MPa"], 1e-6 * state.specific_load, Within(relative=0.005), "MPa", 2)]
        pairs.append(("p_max", row["p_max_MPa"], 1e-6 * float(state.film_pressure.max()), load, "MPa", 1))
        if kind == "blind":
            pairs.append(("p_g", row["p_g_MPa"], 1e-6 * state.groove_pressure, load, "MPa", 1))
        for n, one in enumerate(state.segments):
            name = "" if kind == "none" else f" of segment {n + 1}"
            flow = Within(relative=0.005, absolute=0.005)
            warm = Within(absolute=0.2)
            pairs += [
                (f"Q{name}", row["Q_cm3_s"][n], 1e6 * one.flow, flow, "cm³/s", 2),
                (f"A{name}", row["A_W"][n], one.friction_power, heat, "W", 0),
                (f"t_m{name}", row["T_m_C"][n], one.mean_temperature - ZERO_CELSIUS, warm, "°C", 1),
                (f"t_out{name}", row["T_out_C"][n], one.outlet_temperature - ZERO_CELSIUS, warm, "°C", 1),
            ]
        for quantity, reference, ours, tolerance, unit, decimals in pairs:
            yield Comparison(
                quantity, place, reference, ours, tolerance, unit, "own reference, not published", decimals
            )


def _statements() -> Iterator[Comparison]:
    finding = "finding 3 at equal gap"
    for angle in ANGLES:
        hot = solved("none").outlet_temperature
        open_ends = hot - solved("through", angle).outlet_temperature
        closed = abs(hot - solved("blind", angle).outlet_temperature)
        yield Comparison(
            "colder by",
            f"through groove at {angle}°",
            15.0,
            open_ends,
            AtLeast(SetBy.SPECIFICATION),
            "K",
            finding,
            0,
        )
        yield Comparison(
            "differs by", f"blind groove at {angle}°", 6.0, closed, AtMost(SetBy.SPECIFICATION), "K", finding, 0
        )
        share = solved("through", angle).specific_load / solved("none").specific_load
        yield Comparison(
            "load over ungrooved", f"through groove at {angle}°", 0.625, share, Within(absolute=0.125), "",
            "finding 2, rigid film", 2,
        )  # fmt: skip
    for eccentricity, ratio in ((0.98, 50.0), (0.995, 200.0)):
        wide = film("none").clearance
        thin = float(film_at_eccentricity(film("none"), eccentricity).film_thickness.min())
        yield Comparison(
            "flow of wide over least gap", f"ε = {eccentricity:g}", ratio, wide / thin, Within(relative=1e-6), "",
            "finding 1, tens to hundreds", 0,
        )  # fmt: skip


def _equal_load() -> Iterator[Comparison]:
    """Not published: what the same model says under the same load."""
    why = "not published: under the same load the groove heats the rigid film"
    plain = loaded("none")
    yield Comparison("ε", "ungrooved, 6.5 MPa", 0.66, plain.eccentricity_ratio, Within(absolute=0.005), "",
                     "own reference, not published", 2)  # fmt: skip
    leaving = plain.outlet_temperature - ZERO_CELSIUS
    yield Comparison("t_out", "ungrooved, 6.5 MPa", 69.0, leaving, Within(absolute=0.5), "°C",
                     "own reference, not published", 0)  # fmt: skip
    for angle, eccentricity, outlet in ((135, 0.915, 110.0), (150, 0.925, 108.0), (165, 0.955, 121.0)):
        state = loaded("through", angle)
        place = f"through groove at {angle}°, 6.5 MPa"
        yield Comparison("ε", place, eccentricity, state.eccentricity_ratio, Within(absolute=0.005), "",
                         "own reference, not published", 3, remark=why)  # fmt: skip
        leaving = state.outlet_temperature - ZERO_CELSIUS
        yield Comparison("t_out", place, outlet, leaving, Within(absolute=1.0), "°C",
                         "own reference, not published", 0, remark=why)  # fmt: skip


def draw(figure: Figure) -> None:
    """Outlet temperature at equal gap and under equal load."""
    figure.set_size_inches(7.2, 3.4)
    left, right = figure.subplots(1, 2, sharey=True)
    for axes, answer, title in ((left, solved, "equal gap, ε = 0.8"), (right, loaded, "equal load, 6.5 MPa")):
        axes.axhline(answer("none").outlet_temperature - ZERO_CELSIUS, color=GREY, label="ungrooved")
        for kind, marker in zip(("through", "blind"), MARKERS, strict=False):
            leaves = [answer(kind, angle).outlet_temperature - ZERO_CELSIUS for angle in ANGLES]
            axes.plot(
                ANGLES, leaves, marker=marker, color=INK, markerfacecolor="none", label=f"{kind} groove",
                linestyle="-" if kind == "through" else "--",
            )  # fmt: skip
        axes.set_title(title)
        axes.set_xticks(ANGLES)
        axes.set_xlabel("angle of the groove from the widest gap in °")
    left.set_ylabel("oil leaves the last segment at °C")
    left.legend(fontsize=7)


CASE = ValidationCase(
    name="grooved_segments",
    title="A groove in the loaded zone: colder at equal gap, hotter under equal load",
    story=Story(
        what=(
            "Does an axial groove cut into the loaded zone cool it? The source says that a groove open at both "
            "ends does and a closed one does not. `method: segments` repeats its method, checks it against closed "
            "forms, and puts the grooved film beside the ungrooved one at the same gap and under the same load."
        ),
        source=(
            "A published segment-wise heat balance of a thick-walled babbitt bearing with one groove (D = 100 mm, "
            "L = 70 mm, ψ = 1.53 ‰, 10 m/s, 6.5 MPa, groove 6 mm wide). It prints no computed numbers, its "
            "temperature curves are lost, and author, title and journal could not be looked up. What "
            "is marked as own reference is a second calculation, not a print."
        ),
        assumptions=(
            "Oil (19.5 mPa s at 50 °C, exponent 2.2, 2000 J/(kg K), 880 kg/m³), supply at 40 °C, groove 150° from "
            "the widest gap (varied), film from the widest gap on, only fresh oil behind the groove unless κ says "
            "so, rigid surfaces, adiabatic walls."
        ),
        tolerances=(
            "Closed forms 0.01 % (attitude as printed); reference numbers 0.5 % or half their last digit, "
            "temperatures 0.2 K; statements as bounds: at least 15 K colder through, at most 6 K apart blind, "
            "load 50 to 75 %."
        ),
        differences=(
            "At equal gap the statements hold: the through groove leaves 18 to 33 K colder. (Not for every oil of "
            "the source's classes: below about 12 mm²/s at 50 °C the through groove gains less than 15 K, above "
            "about 60 mm²/s the blind one differs by more than 6 K.) Under equal load they "
            "turn round: the rigid film needs ε = 0.915 to 0.955 instead of 0.66 and leaves at 108 to 121 °C "
            "instead of 69. Cooling under load depends on the deformed film keeping its load capacity, which a "
            "wall that yields to the local pressure does not give either. Most of what the blind groove seems to "
            "gain is that a film cut in two has two mean temperatures: with no width at all it leaves at 85.9 °C "
            "instead of 88.1. And the eccentricities of 0.98 to 0.995 that the source claims for working bearings "
            "cannot be those of a rigid film with adiabatic walls, which would leave at 270 to 530 °C."
        ),
    ),
    run=run,
    draw=draw,
    caption="Temperature at which the oil leaves the last segment over the place of the groove: at the same gap, "
    "and under the same load.",
)

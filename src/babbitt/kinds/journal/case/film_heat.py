"""Heat of the film method: thermal model, and the walls that take heat from a full thermal film."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal

from pydantic import Field

from babbitt.case.part import Issue, Part, is_given, rule
from babbitt.case.parts.walls import ConductingJournalInput, Conductivity, HeatTransfer, Surroundings
from babbitt.core.units import si, written
from babbitt.kinds.journal.case.film_features import GrooveInput

if TYPE_CHECKING:
    from babbitt.kinds.journal.case.journal import JournalBearing

__all__ = [
    "AxialTemperatureInput",
    "CarryOverInput",
    "CoefficientsInput",
    "SOLVED_BY_COMPARE",
    "ThermalInput",
    "WallsInput",
    "heat_goes_with_the_film",
    "unknown_to_own_temperatures",
]

ThermalInput = Literal["isothermal", "global", "adiabatic", "full"]
AxialTemperatureInput = Literal["mean", "resolved"]
CoefficientsInput = Literal["frozen", "following"]

CarryOverInput = Annotated[float, si("1", "0", "1")]
OuterDiameter = Annotated[float, si("m", "1 mm", "10 m")]

SOLVED_BY_COMPARE = "of which `babbitt compare` solves this film, too, without the factor"
"""What to do about a factor on friction that a film does not know."""

BUSH_OVER_BORE = 1.25
"""Outside diameter of the bush over that of the bore where it is not given: an assumption."""
HOUSING_OVER_BUSH = 1.6
"""Outside diameter of the housing over that of the bush where it is not given: an assumption (twice the bore)."""
CONTACT_THICKNESS = 1e-5
"""Of the layer that stands for the contact between bush and housing, m; its conductivity makes the coefficient."""


class LinerInput(Part):
    """The layer of bearing metal on the bush."""

    example: ClassVar[str] = "{thickness: 1 mm, conductivity: 50 W/(m K)}"

    thickness: Annotated[float, si("m", "1 um", "100 mm")] = Field(description="Thickness of the bearing metal.")
    conductivity: Conductivity = Field(description="Its thermal conductivity.")


class ConductingBushInput(Part):
    """The bush, or what lies next to the bore."""

    example: ClassVar[str] = "{outer_diameter: 120 mm, conductivity: 45 W/(m K)}"

    outer_diameter: OuterDiameter | None = Field(
        None, description="Outside diameter of the bush. 1.25 D if not given, and no liner thicker than that."
    )
    conductivity: Conductivity | None = Field(
        None, description="Thermal conductivity. That of materials.bearing if not given."
    )
    liner: LinerInput | None = Field(None, description="Bearing metal on the bush. None if not given.")


class ConductingHousingInput(Part):
    """What surrounds the bush."""

    example: ClassVar[str] = "{outer_diameter: 200 mm, heat_transfer_coefficient: 20 W/(m2 K)}"

    outer_diameter: OuterDiameter | None = Field(
        None, description="Outside diameter of the housing. Twice that of the bore if not given."
    )
    conductivity: Conductivity | None = Field(
        None, description="Thermal conductivity. That of the bush if not given."
    )
    contact_coefficient: Annotated[float, si("W/(m2 K)", "1 W/(m2 K)", "10000000 W/(m2 K)")] | None = Field(
        None, description="Heat transfer coefficient between bush and housing. Perfect contact if not given."
    )
    heat_transfer_coefficient: HeatTransfer | None = Field(
        None, description="On the outside of the housing. That of cooling, or still air, if not given."
    )
    ambient_temperature: Surroundings | None = Field(
        None, description="Of the air around the housing. That of cooling, or 20 degC, if not given."
    )


class WallsInput(Part):
    """Bush, housing and journal, which take heat from the film."""

    example: ClassVar[str] = "{bush: {outer_diameter: 120 mm}}"

    bush: ConductingBushInput = Field(ConductingBushInput(), description="The bush.")
    housing: ConductingHousingInput = Field(ConductingHousingInput(), description="The housing around it.")
    journal: ConductingJournalInput = Field(ConductingJournalInput(), description="The journal.")
    thermal_distortion: bool = Field(
        False,
        description="Whether the uneven temperature of the bush distorts the bore, as that of a free ring of one "
        "material. Its mean temperature widens the bore either way.",
    )


OWN_TEMPERATURES = ("adiabatic", "full")

REFUSED = (
    ("dynamic_load", "the orbit under a changing load has one temperature for the whole film"),
    ("mixed_friction", "the mixed branch has one viscosity for the whole film"),
    ("tilt_coefficients", "coefficients of tilt are those of a film of one temperature"),
    ("error_estimate", "the error of the grid is estimated for films of one temperature"),
    ("pressure_viscosity", "a film with its own temperatures does not count viscosity under pressure"),
)
"""Fields that a film with its own temperatures does not know, and why."""

BESIDES = ("dynamic_load", "mixed_friction", "tilt_coefficients", "error_estimate", "cavitation", "friction")
"""What is computed besides the film, and choices that one with its own temperatures makes by itself."""


@rule
def heat_goes_with_the_film(bearing: JournalBearing) -> Iterator[Issue]:
    """Complain about a thermal model and what does not go with it."""
    if bearing.method != "film":
        for name in ("thermal", "walls", "axial_temperature", "temperature_coefficients", "carry_over"):
            if is_given(bearing, name):
                says = f"{name} belongs to the film method"
                yield Issue((name,), says, "method: film, or leave it out")
        return
    own = bearing.thermal in OWN_TEMPERATURES
    if bearing.thermal == "isothermal" and bearing.effective_temperature is None:
        says = "is missing: an isothermal film needs its temperature"
        yield Issue(("effective_temperature",), says, "a temperature such as '60 degC'", code="E003")
    if bearing.thermal not in (None, "isothermal") and bearing.effective_temperature is not None:
        says = f"a film with thermal: {bearing.thermal} finds its temperature itself"
        yield Issue(("effective_temperature",), says, "thermal: isothermal, or leave it out")
    if is_given(bearing, "walls") and bearing.thermal != "full":
        says = "walls take heat from a full thermal film only"
        yield Issue(("walls",), says, "thermal: full")
    for name in ("axial_temperature", "temperature_coefficients", "carry_over"):
        if is_given(bearing, name) and not own:
            says = "the film has one temperature"
            yield Issue((name,), says, "thermal: adiabatic or full")
    if own:
        yield from _issues_of_own_temperatures(bearing)
        if bearing.friction.factor != 1.0:
            says = "a film with its own temperatures makes its own friction"
            yield Issue(("friction", "factor"), says, f"1, or thermal: global, {SOLVED_BY_COMPARE}")
    if bearing.walls is not None:
        yield from _issues_of_sizes(bearing, bearing.walls)


def unknown_to_own_temperatures(bearing: JournalBearing) -> str:
    """What about a bearing keeps its film from having its own temperatures, and what to do, in words; empty where
    nothing does. A factor on friction is left to the methods that know it."""
    return next(
        (
            f"{one.says}; take {'.'.join(map(str, one.path))} out of the case to see it"
            for one in _issues_of_own_temperatures(bearing)
        ),
        "",
    )


def may_have_own_temperatures(bearing: JournalBearing) -> bool:
    """Whether the film of a bearing could have its own temperatures, but for what is computed besides it."""
    return all(one.path[0] in BESIDES for one in _issues_of_own_temperatures(bearing))


def _issues_of_own_temperatures(bearing: JournalBearing) -> Iterator[Issue]:
    also = "thermal: global"
    for name, says in REFUSED:
        if getattr(bearing, name) not in (None, False):
            yield Issue((name,), says, also)
    if bearing.cavitation != "mass_conserving":
        says = "oil that comes from nowhere has no temperature: only a film that conserves it knows its own"
        yield Issue(("cavitation",), says, f"mass_conserving, or {also}")
    if bearing.film_start == "widest_gap":
        says = "a film with its own temperatures begins at what feeds it"
        yield Issue(("film_start",), says, "groove")
    if bearing.bearing_speed:
        says = "the heat of a bearing that turns is not computed"
        yield Issue(("bearing_speed",), says, f"0 rpm, or {also}")
    for path, feed in bearing.feeds():
        if feed.flow:
            says = "a film with its own temperatures is fed by pressure"
            closable = "" if isinstance(feed, GrooveInput) else "0 L/min (a blind pocket), or "
            yield Issue((*path, "flow"), says, f"{closable}a pressure, or {also}")
    if bearing.carry_over < 1.0 and any(feed.flow == 0.0 for _, feed in bearing.feeds()):
        says = "a closed pocket or hole (flow: 0 L/min) has no fresh oil that could flush out what the film brings"
        yield Issue(("carry_over",), says, "100 %, or leave it out")


def _issues_of_sizes(bearing: JournalBearing, walls: WallsInput) -> Iterator[Issue]:
    bush, housing = walls.bush, walls.housing
    liner = 2.0 * bush.liner.thickness if bush.liner is not None else 0.0
    inside = bearing.diameter + liner
    outside = bush.outer_diameter
    if outside is not None and outside <= inside:
        what = "bore and liner" if liner else "the bore"
        says = f"the bush, {written(outside, 'mm')}, is not larger than {what}"
        yield Issue(("walls", "bush", "outer_diameter"), says, f"more than {written(inside, 'mm')}")
    if outside is None and inside >= BUSH_OVER_BORE * bearing.diameter:
        says = (
            f"the liner reaches beyond the bush, {written(BUSH_OVER_BORE * bearing.diameter, 'mm')} if not given"
        )
        yield Issue(("walls", "bush", "liner", "thickness"), says, "a thinner liner, or outer_diameter")
    inner = outside if outside is not None else BUSH_OVER_BORE * bearing.diameter
    if housing.outer_diameter is None:
        return
    touching = inner + 2.0 * CONTACT_THICKNESS
    if housing.outer_diameter <= inner:
        says = f"the housing, {written(housing.outer_diameter, 'mm')}, is not larger than the bush"
        yield Issue(("walls", "housing", "outer_diameter"), says, f"more than {written(inner, 'mm')}")
    elif housing.contact_coefficient is not None and housing.outer_diameter <= touching:
        wall = written(0.5 * (housing.outer_diameter - inner), "um")
        says = f"the housing is {wall} thick, no more than the contact with its contact_coefficient"
        allowed = f"a wall of more than {written(CONTACT_THICKNESS, 'um')}, or no contact_coefficient"
        yield Issue(("walls", "housing", "outer_diameter"), says, allowed)

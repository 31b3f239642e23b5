"""What a pad stands on."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from pydantic import Discriminator, Field

from babbitt.case.part import Issue, Part, is_given, refused, rule
from babbitt.core.units import si, written
from babbitt.reynolds.tilting_pads.pivots import (
    YIELD,
    HertzContact,
    LineContact,
    Pivot,
    PointContact,
    RigidPivot,
    RockerContact,
    SpringPivot,
    TablePivot,
)

if TYPE_CHECKING:
    from babbitt.reynolds.tilting_pads.model import TiltingPad

__all__ = [
    "FlexureInput",
    "LinePivotInput",
    "PivotInput",
    "PointPivotInput",
    "RigidPivotInput",
    "RockerPivotInput",
    "SpringPivotInput",
    "TablePivotInput",
    "contact_assumptions",
    "written_pivot",
]

Stiffness = Annotated[float, si("N/m", "1 kN/m", "1e18 N/m", "MN/m")]
Damping = Annotated[float, si("N s/m", "0 N s/m", "1e12 N s/m")]
Length = Annotated[float, si("m", "0.1 mm", "10 m", "mm")]
Modulus = Annotated[float, si("Pa", "1 MPa", "2000 GPa")]
Poisson = Annotated[float, si("1", "0", "0.5")]


class _AnyPivot(Part):
    """What all pivots have."""

    fraction: Annotated[float, si("1", "0.3", "0.8")] = Field(
        0.5,
        description="Angle from the leading edge to the pivot over that of the pad. 0.5: in the middle; more: "
        "offset, as for one sense of rotation. It holds for the sense of the speed of the case.",
    )

    def motions(self) -> dict[str, Any]:
        """Give what the pad of the calculation has besides the law of its pivot."""
        return {"pivot_fraction": self.fraction}


class _ElasticPivot(_AnyPivot):
    """What pivots have that give way."""

    damping: Damping = Field(0.0, description="Damping of the pivot, in parallel with its stiffness.")
    housing_stiffness: Stiffness | None = Field(
        None, description="Stiffness of what carries the pivot, in series. Rigid if not given."
    )

    @property
    def behind(self) -> float:
        """Stiffness in series, infinite where rigid, N/m."""
        return math.inf if self.housing_stiffness is None else self.housing_stiffness

    def motions(self) -> dict[str, Any]:
        """Give what the pad of the calculation has besides the law of its pivot."""
        return super().motions() | {"pivot_damping": self.damping}


class RigidPivotInput(_AnyPivot):
    """A pivot that does not give way."""

    kind: Literal["rigid"] = Field(description="Does not give way.")

    def law(self, width: float) -> Pivot:
        """Give the law of the calculation for a pad of a width in m."""
        return RigidPivot()


class SpringPivotInput(_ElasticPivot):
    """A pivot of constant stiffness."""

    kind: Literal["spring"] = Field(description="Constant stiffness.")
    stiffness: Stiffness = Field(description="Stiffness along the radius.")

    def law(self, width: float) -> Pivot:
        """Give the law of the calculation for a pad of a width in m."""
        return SpringPivot(1.0 / (1.0 / self.stiffness + 1.0 / self.behind))


class _HertzPivot(_ElasticPivot):
    """A round pivot in a hollow, by Hertz."""

    pivot_radius: Length = Field(description="Radius of the pivot.")
    housing_radius: Length | None = Field(
        None, description="Radius of the hollow in which it stands. None: a plane, as under a button."
    )
    elastic_modulus: Modulus = Field(210e9, description="Young's modulus of the pivot. 210 GPa as of steel.")
    poisson_ratio: Poisson = Field(0.3, description="Poisson's ratio of the pivot.")
    housing_elastic_modulus: Modulus = Field(210e9, description="Young's modulus of the housing.")
    housing_poisson_ratio: Poisson = Field(0.3, description="Poisson's ratio of the housing.")
    yield_strength: Annotated[float, si("Pa", "50 MPa", "5000 MPa", "MPa")] = Field(
        YIELD,
        description="Yield strength of the softer body, for the pressure in the contact alone. 650 MPa as of "
        "42CrMo4, quenched and tempered, 40 to 100 mm.",
    )

    @rule
    def _conforms(self) -> Iterator[Issue]:
        hollow = self.housing_radius
        if hollow is not None and not hollow > self.pivot_radius:
            yield Issue(
                ("housing_radius",),
                f"a pivot of radius {written(self.pivot_radius, 'mm')} does not fit into a hollow of "
                f"{written(hollow, 'mm')}",
                f"more than {written(self.pivot_radius, 'mm')}, or left out for a plane",
                "are the two exchanged?",
            )

    def contact(self) -> dict[str, float]:
        """Give the fields that both contacts of the calculation have."""
        return {
            "radius": self.pivot_radius,
            "housing_radius": math.inf if self.housing_radius is None else self.housing_radius,
            "elastic_modulus": self.elastic_modulus,
            "poisson_ratio": self.poisson_ratio,
            "housing_elastic_modulus": self.housing_elastic_modulus,
            "housing_poisson_ratio": self.housing_poisson_ratio,
            "housing_stiffness": self.behind,
            "yield_strength": self.yield_strength,
        }


class PointPivotInput(_HertzPivot):
    """A ball in a hollow, or a button on a plane: a contact of points."""

    kind: Literal["point"] = Field(description="A ball or button, by Hertz.")

    def law(self, width: float) -> Pivot:
        """Give the law of the calculation for a pad of a width in m."""
        return PointContact(**self.contact())


class LinePivotInput(_HertzPivot):
    """A cylinder along the pad in a hollow one: a contact of lines."""

    kind: Literal["line"] = Field(description="A cylinder along the pad, by Hertz.")
    length: Length | None = Field(None, description="Length of the contact. That of the pad if not given.")
    depth: Length = Field(description="Depth of the pad behind the contact, to which it is counted.")
    housing_depth: Length = Field(description="Depth of the housing behind the contact.")

    def law(self, width: float) -> Pivot:
        """Give the law of the calculation for a pad of a width in m."""
        length = width if self.length is None else self.length
        return LineContact(**self.contact(), length=length, depth=self.depth, housing_depth=self.housing_depth)


class RockerPivotInput(_ElasticPivot):
    """A steel rocker by an empirical law."""

    kind: Literal["rocker"] = Field(
        description="Steel rocker in a steel housing, by Palmgren's empirical law of a roller on its raceway: "
        "u = 1.530451e-10 P^0.9/l^0.8 (SI)."
    )
    length: Length | None = Field(None, description="Length of the rocker. That of the pad if not given.")

    def law(self, width: float) -> Pivot:
        """Give the law of the calculation for a pad of a width in m."""
        return RockerContact(width if self.length is None else self.length, self.behind)


class PivotPoint(Part):
    """One point of a measured pivot."""

    example: ClassVar[str] = "{load: 10 kN, displacement: 8 um}"

    load: Annotated[float, si("N", "1 mN", "1000 MN")] = Field(description="Load on the pivot.")
    displacement: Annotated[float, si("m", "0.1 nm", "10 mm", "um")] = Field(description="How far it gives way.")


class TablePivotInput(_AnyPivot):
    """A pivot that was measured."""

    kind: Literal["table"] = Field(description="Measured: loads and displacements.")
    points: tuple[PivotPoint, ...] = Field(
        min_length=1,
        max_length=200,
        description="Rising loads with rising displacements; a line from zero to the first, and on behind the "
        "last.",
    )
    damping: Damping = Field(0.0, description="Damping of the pivot, in parallel with its stiffness.")

    @rule
    def _both_rise(self) -> Iterator[Issue]:
        yield from refused(("points",), lambda: self.law(0.0))

    def law(self, width: float) -> Pivot:
        """Give the law of the calculation for a pad of a width in m."""
        return TablePivot(
            tuple(point.load for point in self.points), tuple(point.displacement for point in self.points)
        )

    def motions(self) -> dict[str, Any]:
        """Give what the pad of the calculation has besides the law of its pivot."""
        return super().motions() | {"pivot_damping": self.damping}


class FlexureInput(_AnyPivot):
    """A web that carries the pad and bends with its tilt."""

    kind: Literal["flexure"] = Field(description="A web, which bends as the pad tilts.")
    rotational_stiffness: Annotated[float, si("N m/rad", "0.001 N m/rad", "1e12 N m/rad", "kN m/rad")] = Field(
        description="Stiffness against tilt."
    )
    rotational_damping: Annotated[float, si("N m s/rad", "0 N m s/rad", "1e9 N m s/rad")] = Field(
        0.0, description="Damping of tilt."
    )
    stiffness: Stiffness | None = Field(None, description="Stiffness along the radius. Rigid if not given.")
    damping: Damping = Field(0.0, description="Damping along the radius.")
    tangential_stiffness: Stiffness | None = Field(
        None, description="Stiffness along the motion of the journal. Rigid if not given."
    )
    tangential_damping: Damping = Field(0.0, description="Damping along the motion of the journal.")
    rest_tilt: Annotated[float, si("rad", "-5 deg", "5 deg")] = Field(
        0.0, description="Tilt of the pad without moment, positive counter-clockwise."
    )

    @rule
    def _damped_where_it_gives_way(self) -> Iterator[Issue]:
        for damping, stiffness in (("damping", "stiffness"), ("tangential_damping", "tangential_stiffness")):
            if getattr(self, damping) > 0.0 and getattr(self, stiffness) is None:
                says = f"a web that is rigid there has no damping, for {stiffness} is not given"
                yield Issue((damping,), says, f"{stiffness} besides it")

    def law(self, width: float) -> Pivot:
        """Give the law of the calculation for a pad of a width in m."""
        return RigidPivot() if self.stiffness is None else SpringPivot(self.stiffness)

    def motions(self) -> dict[str, Any]:
        """Give what the pad of the calculation has besides the law of its pivot."""
        along = math.inf if self.tangential_stiffness is None else self.tangential_stiffness
        return super().motions() | {
            "rotational_stiffness": self.rotational_stiffness,
            "rotational_damping": self.rotational_damping,
            "pivot_damping": self.damping,
            "tangential_stiffness": along,
            "tangential_damping": self.tangential_damping,
            "rest_tilt": self.rest_tilt,
        }


STEEL = {
    "elastic_modulus": "pivots of 210 GPa",
    "poisson_ratio": "with Poisson's ratio 0.3",
    "housing_elastic_modulus": "housing of 210 GPa",
    "housing_poisson_ratio": "with Poisson's ratio 0.3",
    "yield_strength": f"yield strength {1e-6 * YIELD:g} MPa (42CrMo4, quenched and tempered)",
}
"""Fields of the contacts of pivots that are those of steel where they are not given."""


def contact_assumptions(pivots: Iterable[Part]) -> Iterator[str]:
    """What of the contacts of pivots is that of steel for want of anything else."""
    contacts = [one for one in pivots if isinstance(one, _HertzPivot)]
    said = [words for name, words in STEEL.items() if not all(is_given(one, name) for one in contacts)]
    if said:
        yield f"Contacts of pivots as of steel: {', '.join(said)}."


PivotInput = Annotated[
    RigidPivotInput
    | SpringPivotInput
    | PointPivotInput
    | LinePivotInput
    | RockerPivotInput
    | TablePivotInput
    | FlexureInput,
    Discriminator("kind"),
]


def written_pivot(pad: TiltingPad) -> str:
    """What a pivot is, in words, for the report."""
    if pad.rotational_stiffness > 0.0:
        return f"flexure of {pad.rotational_stiffness / 1e3:.4g} kN m/rad"
    match pad.pivot:
        case SpringPivot(stiffness):
            return f"spring of {stiffness / 1e6:.4g} MN/m"
        case LineContact() as line:
            depths = f"{1e3 * line.depth:.4g} and {1e3 * line.housing_depth:.4g} mm"
            return f"line, {written_contact(line)}, {1e3 * line.length:.4g} mm long, to depths of {depths}"
        case PointContact() as point:
            return f"point, {written_contact(point)}"
        case RockerContact() as rocker:
            return f"rocker, {1e3 * rocker.length:.4g} mm long, empirical (Palmgren)"
        case TablePivot() as table:
            return f"measured at {len(table.loads)} loads"
        case _:
            return "rigid"


def written_contact(contact: HertzContact) -> str:
    """Radii of a contact in words."""
    flat = math.isinf(contact.housing_radius)
    hollow = "a plane" if flat else f"{1e3 * contact.housing_radius:.5g} mm"
    return f"radius {1e3 * contact.radius:.5g} mm in {hollow}"

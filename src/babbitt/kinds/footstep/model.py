"""What is computed: the cylindrical heel of a pump's screw, its oil, its pressures, and what is assumed.

The heel runs in a cup. Oil at the pressure of delivery comes through a bore (radius r2) into a recess (to r3),
leaves through the face gap h (to r1), reaches the rim and escapes through the clearance δ along the heel. A screw
groove on the heel drags oil from the outer end towards the rim, against the leakage.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from functools import cached_property

from babbitt.core.notices import InputError

__all__ = [
    "BackflowViscosity",
    "FaceOutlet",
    "Footstep",
    "FrictionViscosity",
    "FootstepGeometry",
    "FootstepOil",
    "FootstepOptions",
    "LoadReference",
    "ScrewGroove",
    "Wall",
]

PITCH_TOLERANCE = 0.03
"""Relative misfit of grooves and lands around the heel that is taken for rounding."""


class FrictionViscosity(Enum):
    """At which temperature the oil in the clearance of a grooved heel is sheared."""

    MEAN = "mean of the viscosities at the inlet and at the end of the groove"
    MIXED = "viscosity at the mixed temperature of the rim"


class FaceOutlet(Enum):
    """How the oil is heated on its way through recess and face gap."""

    CONSISTENT = "by the pressure lost from the bore to the rim"
    PRINTED = "as if the face gap reached from the bore to the rim (as printed in the source)"


class BackflowViscosity(Enum):
    """Viscosity in the face gap where the rim feeds the recess."""

    INLET = "that of the inlet temperature (as in the source)"
    GROOVE = "that of the oil which leaves the groove"


class LoadReference(Enum):
    """Which pressures count in the load."""

    ABSOLUTE = "absolute pressure between bore and rim"
    GAUGE = "pressure above ambient between bore and rim"


def _require(value: float, name: str, allowed: str, fits: bool) -> None:
    if not (math.isfinite(value) and fits):
        raise InputError("E130", f"{name} is {value!r}; allowed: {allowed}")


def _positive(part: object, *names: str) -> None:
    for name in names:
        value = getattr(part, name)
        _require(value, name, "a positive number in SI units", value > 0.0)


@dataclass(frozen=True)
class FootstepGeometry:
    """Lengths of heel and recess, m.

    Attributes
    ----------
    length, radius : float
        Of the cylindrical surface (L, r1).
    recess_radius, bore_radius, recess_depth : float
        r3, r2, H.
    """

    length: float
    radius: float
    recess_radius: float
    bore_radius: float
    recess_depth: float

    def __post_init__(self) -> None:
        _positive(self, "length", "radius", "recess_radius", "bore_radius", "recess_depth")
        if not self.bore_radius < self.recess_radius < self.radius:
            raise InputError(
                "E130",
                f"bore_radius {1e3 * self.bore_radius:.4g} mm, recess_radius {1e3 * self.recess_radius:.4g} mm "
                "and "
                f"radius {1e3 * self.radius:.4g} mm; allowed: each larger than the one before",
            )


@dataclass(frozen=True)
class ScrewGroove:
    """A groove of several starts around the heel; SI.

    Attributes
    ----------
    angle : float
        Of the groove, from the circumferential direction (phi), rad.
    depth, groove_width, land_width : float
        h_k, a, b; both widths are normal to the groove.
    starts : int
        z_n.
    """

    angle: float
    depth: float
    groove_width: float
    land_width: float
    starts: int

    def __post_init__(self) -> None:
        _positive(self, "depth", "groove_width", "land_width")
        _require(self.angle, "angle", "between 0 and 90 degrees", 0.0 < self.angle < 0.5 * math.pi)
        whole = float(self.starts).is_integer() if math.isfinite(self.starts) else False
        _require(self.starts, "starts", "a whole number of 1 or more", whole and self.starts >= 1)

    @property
    def groove_share(self) -> float:
        """Share of the surface that is groove, a/(a+b)."""
        return self.groove_width / (self.groove_width + self.land_width)

    def misfit(self, radius: float) -> float:
        """z_n (a+b) over 2 pi r1 sin(phi), less one: zero where the grooves close around the heel."""
        pitch = self.groove_width + self.land_width
        return self.starts * pitch / (2.0 * math.pi * radius * math.sin(self.angle)) - 1.0


@dataclass(frozen=True)
class FootstepOil:
    """Oil with mu = mu0 exp(-alpha (theta - theta0)).

    Attributes
    ----------
    viscosity : float
        mu0, Pa s, at `temperature`.
    temperature : float
        theta0, K: that of the oil in recess and groove inlet.
    exponent : float
        alpha, 1/K; zero for a viscosity that does not change.
    heat_capacity : float
        Per volume, J/(m³ K).
    density : float
        kg/m³; for Reynolds numbers, entry loss and centrifugal pressure only.
    """

    viscosity: float
    temperature: float
    exponent: float
    heat_capacity: float
    density: float

    def __post_init__(self) -> None:
        _positive(self, "viscosity", "temperature", "heat_capacity", "density")
        _require(self.exponent, "exponent", "zero or a positive number in 1/K", self.exponent >= 0.0)

    def at(self, temperature: float) -> float:
        """Viscosity, Pa s, at a temperature in K."""
        return self.viscosity * math.exp(-self.exponent * (temperature - self.temperature))


@dataclass(frozen=True)
class Wall:
    """Metal that takes heat from the films: its temperature, K, and its conductance, W/K, shared by both films."""

    temperature: float
    conductance: float

    def __post_init__(self) -> None:
        _positive(self, "temperature")
        _require(self.conductance, "conductance", "zero or a positive number in W/K", self.conductance >= 0.0)


@dataclass(frozen=True)
class FootstepOptions:
    """Choices that the source leaves open or that its print gets wrong; the defaults are the consistent ones.

    Attributes
    ----------
    friction_viscosity : FrictionViscosity
    face_outlet : FaceOutlet
    backflow_viscosity : BackflowViscosity
    load_reference : LoadReference
    entry_loss : float
        Local loss coefficient at the groove inlet: the pressure there is lower by k rho (q/h_k)²/2.
    speed_reduction : float
        beta: groove and all friction are computed with omega0/(1 + beta).
    any_pitch : bool
        Accept grooves that do not close around the heel.
    """

    friction_viscosity: FrictionViscosity = FrictionViscosity.MEAN
    face_outlet: FaceOutlet = FaceOutlet.CONSISTENT
    backflow_viscosity: BackflowViscosity = BackflowViscosity.INLET
    load_reference: LoadReference = LoadReference.ABSOLUTE
    entry_loss: float = 0.0
    speed_reduction: float = 0.0
    any_pitch: bool = False

    def __post_init__(self) -> None:
        for name in ("entry_loss", "speed_reduction"):
            _require(getattr(self, name), name, "zero or a positive number", getattr(self, name) >= 0.0)


@dataclass(frozen=True)
class Footstep:
    """A footstep with a smooth heel (no groove) or a screw-grooved one; SI, pressures absolute.

    Attributes
    ----------
    geometry : FootstepGeometry
    oil : FootstepOil
    angular_speed : float
        omega0, rad/s.
    supply_pressure, ambient_pressure : float
        p2 and p_a, Pa, absolute.
    face_gap, clearance : float
        h and radial delta, m.
    groove : ScrewGroove or None
    options : FootstepOptions
    wall : Wall or None
        For narrow-groove theory; None: the films are as warm as the oil that comes in.
    eccentricity_ratio : float
        Of the heel in its cup at half length.
    tilt : float
        Slope of the heel's axis in the plane of the eccentricity, rad; positive: the rim end lies farther out.
    """

    geometry: FootstepGeometry
    oil: FootstepOil
    angular_speed: float
    supply_pressure: float
    ambient_pressure: float
    face_gap: float
    clearance: float
    groove: ScrewGroove | None = None
    options: FootstepOptions = FootstepOptions()
    wall: Wall | None = None
    eccentricity_ratio: float = 0.0
    tilt: float = 0.0

    def __post_init__(self) -> None:
        _positive(self, "angular_speed", "supply_pressure", "ambient_pressure", "face_gap", "clearance")
        if not self.supply_pressure > self.ambient_pressure:
            raise InputError(
                "E130",
                f"supply_pressure is {self.supply_pressure:.6g} Pa and ambient_pressure "
                f"{self.ambient_pressure:.6g} Pa, "
                "both absolute; allowed: a supply pressure above ambient",
            )
        for name in ("eccentricity_ratio", "tilt"):
            _require(getattr(self, name), name, "a finite number", True)
        if max(map(abs, self.end_eccentricities)) >= 1.0:
            raise InputError(
                "E130",
                f"eccentricity_ratio {self.eccentricity_ratio:.3g} with tilt {self.tilt:.3g} rad brings the "
                "heel to "
                f"{max(map(abs, self.end_eccentricities)):.3g} of the clearance; allowed: less than 1 at both "
                "ends",
            )
        groove = self.groove
        if groove is not None and not self.options.any_pitch:
            misfit = groove.misfit(self.geometry.radius)
            if abs(misfit) > PITCH_TOLERANCE:
                raise InputError(
                    "E130",
                    f"{groove.starts} grooves and lands take {1.0 + misfit:.4g} of the way around the heel, "
                    "starts (groove_width + land_width) over 2 pi radius sin(angle), a misfit of "
                    f"{100.0 * misfit:+.2g} %; allowed: {100.0 * PITCH_TOLERANCE:.0f} %; both widths are normal "
                    "to the "
                    "groove; any_pitch accepts the numbers as they are",
                )

    @property
    def end_eccentricities(self) -> tuple[float, float]:
        """Eccentricity over clearance at the rim and at the outer end of the heel."""
        half = 0.5 * self.tilt * self.geometry.length / self.clearance
        return self.eccentricity_ratio + half, self.eccentricity_ratio - half

    @property
    def groove_speed(self) -> float:
        """omega = omega0/(1 + beta), rad/s."""
        return self.angular_speed / (1.0 + self.options.speed_reduction)

    @cached_property
    def kappa(self) -> float:
        """(F1): ln(r1/r3)/h³ + ln(r3/r2)/H³, 1/m³."""
        part = self.geometry
        return (
            math.log(part.radius / part.recess_radius) / self.face_gap**3
            + math.log(part.recess_radius / part.bore_radius) / part.recess_depth**3
        )

"""Restrictors of hydrostatic bearings, as an engineer writes them."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from pydantic import Discriminator, Field

from babbitt.case.part import Part
from babbitt.case.parts.fields import WholeNumber
from babbitt.case.parts.own_lubricant import DynamicViscosity
from babbitt.core.units import si
from babbitt.kinds.hydrostatic.restrictors import (
    Capillary,
    CheckValve,
    ConstantFlow,
    FlowValve,
    MembraneValve,
    MeteredFlow,
    Orifice,
    Restrictor,
    Slot,
)

Bore = Annotated[float, si("m", "0.05 mm", "20 mm")]
FlowRate = Annotated[float, si("m3/s", "1e-6 L/min", "10000 L/min")]
Conductance = Annotated[float, si("m3/(s Pa)", "1e-9 L/(min MPa)", "1e5 L/(min MPa)")]
Leakage = Annotated[float, si("m3/(s Pa)", "0 L/(min MPa)", "1e5 L/(min MPa)")]


class WithCheckValve(Part):
    """Restrictors that may have a check valve."""

    check_valve: bool = Field(False, description="Whether a check valve keeps oil from flowing back.")


class CapillaryInput(WithCheckValve):
    """A round tube before every recess."""

    example: ClassVar[str] = "{kind: capillary, diameter: 0.8 mm, length: 100 mm}"

    kind: Literal["capillary"] = Field(description="Laminar round tube.")
    diameter: Bore = Field(description="Inside diameter.")
    length: Annotated[float, si("m", "0.5 mm", "20 m")] = Field(description="Length.")
    tubes: Annotated[int, WholeNumber(1, 1000)] = Field(1, description="Equal tubes side by side.")
    entry_loss: Annotated[float, si("1", "0", "10")] = Field(
        0.0, description="Loss at the entry over rho U²/2. Usual 2.24; zero leaves it out."
    )
    viscosity: DynamicViscosity | None = Field(
        None, description="Viscosity of the oil in it, where it differs from that of the supply."
    )

    def restrictor(self, viscosity: float, density: float) -> Restrictor:
        """Give the restrictor of the calculation."""
        law = Capillary(
            self.diameter, self.length, self.viscosity or viscosity, self.tubes, self.entry_loss, density
        )
        return CheckValve(law) if self.check_valve else law


class OrificeInput(WithCheckValve):
    """A sharp-edged hole before every recess."""

    example: ClassVar[str] = "{kind: orifice, diameter: 0.4 mm}"

    kind: Literal["orifice"] = Field(description="Sharp-edged hole.")
    diameter: Bore = Field(description="Diameter.")
    discharge: Annotated[float, si("1", "0.1", "1")] = Field(0.6, description="Discharge coefficient C_d.")

    def restrictor(self, viscosity: float, density: float) -> Restrictor:
        """Give the restrictor of the calculation."""
        law = Orifice(self.diameter, density, self.discharge)
        return CheckValve(law) if self.check_valve else law


class SlotInput(WithCheckValve):
    """A flat slot before every recess."""

    example: ClassVar[str] = "{kind: slot, width: 10 mm, gap: 0.1 mm, length: 20 mm}"

    kind: Literal["slot"] = Field(description="Laminar flat slot.")
    width: Annotated[float, si("m", "0.1 mm", "10 m")] = Field(description="Width across the flow.")
    gap: Annotated[float, si("m", "5 um", "5 mm")] = Field(description="Height.")
    length: Annotated[float, si("m", "0.1 mm", "1 m")] = Field(description="Length along the flow.")
    viscosity: DynamicViscosity | None = Field(
        None, description="Viscosity of the oil in it, where it differs from that of the supply."
    )

    def restrictor(self, viscosity: float, density: float) -> Restrictor:
        """Give the restrictor of the calculation."""
        law = Slot(self.width, self.gap, self.length, self.viscosity or viscosity)
        return CheckValve(law) if self.check_valve else law


class ConstantFlowInput(Part):
    """A pump for every recess."""

    example: ClassVar[str] = "{kind: constant_flow, flow: 0.75 L/min}"

    kind: Literal["constant_flow"] = Field(
        description="A pump for every recess, at its pressure; `supply.pressure` is what the pump can reach."
    )
    flow: FlowRate = Field(description="Flow of one.")
    leakage: Leakage = Field(0.0, description="What it delivers less for every pascal.")

    def restrictor(self, viscosity: float, density: float) -> Restrictor:
        """Give the restrictor of the calculation."""
        return ConstantFlow(self.flow, self.leakage)


class MeteredFlowInput(Part):
    """A metering stage before every recess, fed by the common supply."""

    example: ClassVar[str] = "{kind: metered_flow, flow: 0.75 L/min}"

    kind: Literal["metered_flow"] = Field(
        description="A constant flow that a valve meters from `supply.pressure`, to which all oil is pumped."
    )
    flow: FlowRate = Field(description="Flow of one.")

    def restrictor(self, viscosity: float, density: float) -> Restrictor:
        """Give the restrictor of the calculation."""
        return MeteredFlow(self.flow)


class FlowValveInput(Part):
    """A pressure-compensating valve before every recess: more oil where the recess pressure rises."""

    kind: Literal["flow_valve"] = Field(description="Q = min(Q0 + k p, G (p_s - p)).")
    flow: FlowRate = Field(description="Flow Q0 at zero recess pressure.")
    gain: Conductance = Field(description="Rise k of the flow with the recess pressure.")
    open_conductance: Conductance = Field(description="Conductance G of its open ports: what it can pass at most.")

    def restrictor(self, viscosity: float, density: float) -> Restrictor:
        """Give the restrictor of the calculation."""
        return FlowValve(self.flow, self.gain, self.open_conductance)


class MembraneValveInput(Part):
    """A membrane valve before every recess: its gap opens with the recess pressure."""

    kind: Literal["membrane_valve"] = Field(description="Q = G (1 + s p)³ (p_s - p).")
    conductance: Conductance = Field(description="Conductance G at zero recess pressure.")
    compliance: Annotated[float, si("1/Pa", "1e-4 1/MPa", "100 1/MPa")] = Field(
        description="Growth s of its gap with the recess pressure, over the gap at zero pressure."
    )

    def restrictor(self, viscosity: float, density: float) -> Restrictor:
        """Give the restrictor of the calculation."""
        return MembraneValve(self.conductance, self.compliance)


RestrictorInput = Annotated[
    CapillaryInput
    | OrificeInput
    | SlotInput
    | ConstantFlowInput
    | MeteredFlowInput
    | FlowValveInput
    | MembraneValveInput,
    Discriminator("kind"),
]
"""All restrictors."""

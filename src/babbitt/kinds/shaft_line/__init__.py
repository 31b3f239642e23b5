"""Axial dynamics of a shaft line on its thrust bearing: propeller, elastic shaft, collar, pads, ring, seating."""

from babbitt.core.kind import Kind
from babbitt.kinds.thrust import NO_COEFFICIENTS

KINDS = (
    Kind(
        name="thrust_line",
        description="axial vibration of a shaft line on its thrust bearing",
        model="babbitt.kinds.shaft_line.case.shaft_line:ThrustLineCase",
        template="babbitt.kinds.shaft_line:thrust_line.yaml",
        views={"frequency domain": "babbitt.kinds.shaft_line.view:FREQUENCY_DOMAIN"},
        one_method="a shaft line has one method, there is nothing to compare; its report sets runout, ripple, "
        "tilt and rings side by side (babbitt solve --report), and babbitt sweep varies a field",
        no_coefficients=NO_COEFFICIENTS,
        meanings="babbitt.kinds.thrust.report.words:OF_THRUST",
    ),
)

"""Thrust bearings: pads that tilt on pivots or stand fixed, and how they share a load."""

from babbitt.core.kind import Kind

NO_COEFFICIENTS = (
    "coefficients of thrust bearings are not exported; those of each pad are in the results: "
    "babbitt solve FILE --json OUT"
)

KINDS = (
    Kind(
        name="thrust",
        description="one thrust bearing of tilting or fixed pads",
        model="babbitt.kinds.thrust.case.thrust:ThrustCase",
        template="babbitt.kinds.thrust:thrust.yaml",
        views={"film": "babbitt.kinds.thrust.view:FILM"},
        one_method="thrust pads have one film method, there is nothing to compare; to see what its options do, "
        "solve copies of the case with another thermal or turbulence, or vary a field with babbitt sweep",
        no_coefficients=NO_COEFFICIENTS,
        meanings="babbitt.kinds.thrust.report.words:OF_THRUST",
        vocabulary="babbitt.kinds.thrust.report.words:THRUST_WORDS",
    ),
)

"""Statics and bending of shafts with gears, couplings and masses: what their bearings carry."""

from babbitt.core.kind import Kind

KINDS = (
    Kind(
        name="shaft",
        description="shaft with gears, couplings and masses: loads, thrust and slopes of its bearings",
        model="babbitt.kinds.shaft.case.shaft:ShaftCase",
        template="babbitt.kinds.shaft:shaft.yaml",
        views={"statics": "babbitt.kinds.shaft.view:STATICS", "beam": "babbitt.kinds.shaft.view:BEAM"},
        comparison="babbitt.kinds.shaft.comparison:compare",
        vocabulary="babbitt.kinds.shaft.report.words:SHAFT_WORDS",
        envelope=(("speed",), ("power",)),
    ),
    Kind(
        name="overhung_coupling",
        description="load share of two bearings with an overhung coupling; kind shaft does the same and more",
        model="babbitt.kinds.shaft.case.overhung_coupling:OverhungCouplingCase",
        template="babbitt.kinds.shaft:overhung_coupling.yaml",
        views={"statics": "babbitt.kinds.shaft.view:OVERHUNG_COUPLING"},
        envelope=(("coupling_mass",), ("mesh_force",)),  # knows no speed and no supply
    ),
)

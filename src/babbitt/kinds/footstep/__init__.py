"""The hydrostatic footstep of a pump's screw, with a smooth or a screw-grooved heel.

``model`` says what is computed; ``states`` finds every steady state by ``superposition`` (the equations of the
published study, corrected) or by ``thermal_films`` (narrow-groove theory with heat to the metal); ``clearances``
tells where states vanish; ``axial`` and ``eccentric`` hold stiffness, damping and side forces; ``check`` makes
results of them.
"""

from babbitt.core.kind import Kind

KINDS = (
    Kind(
        name="screw_heel",
        description="footstep of a pump's screw, smooth or grooved heel",
        model="babbitt.kinds.footstep.case.footstep:FootstepCase",
        template="babbitt.kinds.footstep:screw_heel.yaml",
        views={
            "superposition": "babbitt.kinds.footstep.view:SUPERPOSITION",
            "narrow_groove": "babbitt.kinds.footstep.view:NARROW_GROOVE",
        },
        comparison="babbitt.kinds.footstep.study.comparison:compare",
        meanings="babbitt.report.meanings:PUMPED",
        vocabulary="babbitt.kinds.footstep.report.words:FOOTSTEP_WORDS",
        envelope=(("speed",), ("face_gap",)),  # the load follows from the gap
    ),
)

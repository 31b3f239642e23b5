"""Journal bearings of pads that tilt."""

from babbitt.core.kind import Kind

HERE = "babbitt.kinds.tilting_pad_journal"

KINDS = (
    Kind(
        name="tilting_pad_journal",
        description="journal bearing of tilting pads",
        model=f"{HERE}.case.bearing:TiltingPadJournalCase",
        template=f"{HERE}:tilting_pad_journal.yaml",
        views={"film": f"{HERE}.view:FILM"},
        comparison=f"{HERE}.comparison:compare",
        meanings=f"{HERE}.report.words:OF_PADS",
        vocabulary=f"{HERE}.report.words:PAD_WORDS",
        study_results=(
            "probe_temperature",
            *(f"{name}_{axes}" for name in ("stiffness", "damping") for axes in ("xx", "xy", "yx", "yy")),
            "log_decrement",
            "cross_coupling_ratio",
        ),
    ),
)

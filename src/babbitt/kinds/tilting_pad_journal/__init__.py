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
        one_method="tilting pads have one film method, there is nothing to compare; to see what its options do, "
        "solve copies of the case with another thermal, or vary a field with babbitt sweep",
        meanings=f"{HERE}.report.words:OF_PADS",
        vocabulary=f"{HERE}.report.words:PAD_WORDS",
    ),
)

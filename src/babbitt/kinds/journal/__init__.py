"""Journal bearings: case language, methods, report."""

from babbitt.core.kind import Kind

HERE = "babbitt.kinds.journal"
VIEWS = {
    "iso7902": f"{HERE}.report.views:ISO7902",
    "film": f"{HERE}.report.views:FILM",
    "long_film": f"{HERE}.report.views:LONG_FILM",
    "segments": f"{HERE}.report.views:SEGMENTS",
}

KINDS = (
    Kind(
        name="journal",
        description="one journal bearing, by ISO 7902 or its film",
        model=f"{HERE}.case.files:JournalCase",
        template=f"{HERE}:journal.yaml",
        views=VIEWS,
        comparison=f"{HERE}.compare.comparison:compare",
        vocabulary=f"{HERE}.report.words:JOURNAL_WORDS",
        solve_many=f"{HERE}.study.many_rows:solve_many",
        first_design=f"{HERE}.study:first_design",
    ),
    Kind(
        name="machine",
        description="several journal bearings that share oil and supply",
        model=f"{HERE}.case.files:Machine",
        template=f"{HERE}:machine.yaml",
        views={**VIEWS, "oil_balance": f"{HERE}.report.views:OIL_BALANCE"},
        comparison=f"{HERE}.compare.comparison:compare",
        solve_many=f"{HERE}.study.many_rows:solve_many",
    ),
)

"""The command that goes from a duty to first designs: the one-line form of a study of kind design."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from babbitt.cli.app import NO_SOLUTION, System, Units, app
from babbitt.cli.studying import Kept, PlotFolder, Processes, Report, StudyTongue, Workbook, computed
from babbitt.core.notices import InputError

__all__ = ["design"]


@app.command()
def design(
    diameter: Annotated[str, typer.Option(metavar="D", help="Of the bore: '120 mm'.")],
    load: Annotated[str, typer.Option(metavar="F", help="'12 kN'.")],
    speed: Annotated[str, typer.Option(metavar="N", help="'2000 rpm'.")],
    lubricant: Annotated[
        list[str] | None,
        typer.Option(
            metavar="OIL", help="An oil that may be used; several times. All viscosity grades if left out."
        ),
    ] = None,
    fit: Annotated[
        list[str] | None,
        typer.Option(metavar="FIT", help="A fit such as H7/e8; several times. By the speed if left out."),
    ] = None,
    kind: Annotated[str, typer.Option(metavar="KIND", help="Of bearing.")] = "journal",
    name: Annotated[
        str | None, typer.Option(metavar="NAME", help="Of the bearing; what the duty says if left out.")
    ] = None,
    supply_temperature: Annotated[
        str | None, typer.Option(metavar="T", help="Of the oil that is supplied; 45 degC are assumed.")
    ] = None,
    supply_pressure: Annotated[str | None, typer.Option(metavar="P", help="0.2 MPa are assumed.")] = None,
    metal: Annotated[str | None, typer.Option(metavar="NAME", help="Bearing metal; SnSb8Cu4 is assumed.")] = None,
    reserve: Annotated[
        str, typer.Option(metavar="R", help="Margin to every limit from which designs are ranked by power.")
    ] = "10 %",
    proposals: Annotated[int, typer.Option(metavar="N", help="How many are made.", min=1, max=50)] = 5,
    out_dir: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Write each proposal as a case file into a folder.")
    ] = None,
    out: Kept = None,
    workers: Processes = None,
    xlsx: Workbook = None,
    report: Report = None,
    plots: PlotFolder = None,
    language: StudyTongue = None,
    units: Units = System.SI,
) -> None:
    """Propose bearings for a diameter, a load and a speed: width, fit, oil and feed, ranked, with reasons."""
    from babbitt.core.quantities import displayed_in
    from babbitt.core.units import QuantityError, read
    from babbitt.report.study_output import require_language, require_study_outputs, write_study
    from babbitt.report.study_table import print_study
    from babbitt.study.best_designs import require_designs, write_designs
    from babbitt.study.design import designs_of, duty_study

    require_study_outputs({}, xlsx, report, plots)
    if out_dir is not None:
        require_designs(out_dir, "--out-dir")
    try:
        least = read(reserve, "1")
    except QuantityError as error:
        raise InputError("E003", f"--reserve: {error}") from None
    if not 0.0 <= least <= 1.0:
        raise InputError("E003", f"--reserve: {reserve} is not possible; allowed: 0 to 100 %")
    given = {
        "diameter": diameter,
        "load": load,
        "speed": speed,
        "supply_temperature": supply_temperature,
        "supply_pressure": supply_pressure,
        "metal": metal,
        "name": name,
    }
    oils = [one for one in lubricant or () if one != "any"]
    case, block = duty_study(kind, given, oils, fit or (), reserve=least, proposals=proposals)
    require_language(case, language, report, plots)
    found = computed(case.name, case, block, out, workers)
    with displayed_in(units):
        write_study(found, xlsx, report, plots, language)
        print_study(found)
        if out_dir is not None:
            for path in write_designs(found, out_dir):
                print(f"wrote {path}")
    if not designs_of(found).proposals:
        raise typer.Exit(NO_SOLUTION)

"""The figures of the bearings of a machine as files."""

from __future__ import annotations

from pathlib import Path

from babbitt.core.files.writing import write_files
from babbitt.report.drawing import require_format
from babbitt.report.view import view_of
from babbitt.solving import MachineResult

__all__ = ["write_plots"]


def write_plots(machine: MachineResult, folder: Path, image_format: str = "svg") -> tuple[Path, ...]:
    """Write the figures of all solved bearings into a folder, one file each.

    Parameters
    ----------
    machine : MachineResult
    folder : Path
        Made if it does not exist.
    image_format : {"svg", "pdf", "png"}

    Returns
    -------
    tuple of Path
        The files written, ``01-speed-and-load.svg`` and so on, numbered as the bearings are.

    Raises
    ------
    InputError
        E007 if the folder cannot be written to, the format is unknown, or matplotlib is not installed.
    """
    require_format(image_format)
    made = {}
    for place, solution in enumerate(machine.solutions, start=1):
        for drawing in view_of(solution.result).figures(solution, image_format):
            made[f"{place:02d}-{drawing.name}.{image_format}"] = drawing.image
    return write_files(folder, made)

"""The figures of `babbitt compare` as files."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from babbitt.core.files.writing import write_files
from babbitt.report.drawing import rendered, require_format, style
from babbitt.study.comparison import Comparison

__all__ = ["write_comparison_plots"]


def write_comparison_plots(
    comparisons: Sequence[Comparison], folder: Path, image_format: str = "svg"
) -> tuple[Path, ...]:
    """Write one figure per bearing into a folder.

    Parameters
    ----------
    comparisons : sequence of Comparison
    folder : Path
        Made if it does not exist.
    image_format : {"svg", "pdf", "png"}

    Returns
    -------
    tuple of Path
        The files written, ``01-methods.svg`` and so on.

    Raises
    ------
    InputError
        E007 if the folder cannot be written to, the format is unknown, or matplotlib is not installed.
    """
    require_format(image_format)
    with style():
        made = {
            f"{place:02d}-methods.{image_format}": rendered(figure, image_format)
            for place, comparison in enumerate(comparisons, start=1)
            if comparison.draw is not None and (figure := comparison.draw(comparison)) is not None
        }
    return write_files(folder, made)

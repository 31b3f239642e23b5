"""The page on screen as a browser prints it: nothing is cut at the edge of the paper."""

import re

from babbitt.report.document import TEMPLATES


def test_wide_tables_are_not_cut_by_the_paper():
    style = (TEMPLATES / "report.css").read_text(encoding="utf-8")
    _, _, printed = style.partition("@media print {")
    assert re.search(r"\.wide \{[^}]*overflow: visible", printed)
    assert "table.machine { font-size: 7pt" in printed


def test_the_layout_of_narrow_screens_is_not_that_of_paper():
    """A4 within its margins is narrower than 46 rem, and would get tables of a least width."""
    style = (TEMPLATES / "report.css").read_text(encoding="utf-8")
    assert all("screen" in rule for rule in re.findall(r"@media[^{]*max-width[^{]*", style))

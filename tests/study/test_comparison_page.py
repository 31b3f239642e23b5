"""The page of a comparison: everything that the terminal says, with the figure, in one file."""

import re
from pathlib import Path

import pytest

from babbitt.case import load_case, parse_case
from babbitt.case.kinds import template
from babbitt.cli import main
from babbitt.core.language import written_in
from babbitt.core.limited_flow import quantity_held
from babbitt.core.notices import InputError
from babbitt.report.comparison_page import comparison_page, write_comparison_page
from babbitt.report.comparison_table import compared_rows
from babbitt.study.comparison import compare_methods

EXAMPLES = Path(__file__).parents[2] / "examples"
CASE = EXAMPLES / "input_pinion_heat.yaml"


@pytest.fixture(scope="module")
def found():
    return compare_methods(load_case(CASE))


def test_the_page_says_what_one_temperature_costs_and_what_each_method_neglects(found):
    page = comparison_page(found)
    (comparison,) = found
    methods = [one for one in comparison.variants if one.is_method]
    assert page.count("data:image/svg+xml;base64,") == 1
    for one in comparison.variants:
        assert f"<b>{one.label}</b>: {one.remark}." in page
    said = re.search(r"is (\d+)% thinner at its thinnest", page)
    compared = [one.result for one in methods if one.label in ("full thermal film", "ISO 7902")]
    thin = [one.values[quantity_held(one, "minimum_film_thickness")] for one in compared]
    assert int(said[1]) == round(100.0 * (1.0 - thin[0] / thin[1]))
    for row in compared_rows(comparison.compared, methods):
        assert len(row.cells) == len(methods)
        assert all(f'<td class="number">{cell}</td>' in page for cell in row.cells)


def test_a_name_is_never_markup(found):
    from dataclasses import replace

    assert "<script" not in comparison_page([replace(found[0], name="<script>alert(1)</script>")])


def test_the_page_is_written_whole_or_not_at_all(found, tmp_path):
    with pytest.raises(InputError, match=r"ends in \.html"):
        write_comparison_page(found, tmp_path / "page.pdf")
    assert not list(tmp_path.iterdir())
    write_comparison_page(found, tmp_path / "page.html")
    assert (tmp_path / "page.html").read_text(encoding="utf-8").startswith("<!DOCTYPE html>")


def test_the_command_writes_it(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("sys.argv", ["babbitt", "compare", str(CASE), "--report", str(tmp_path / "page.html")])
    with pytest.raises(SystemExit) as ended:
        main()
    assert not ended.value.code
    assert (tmp_path / "page.html").exists()
    assert "full thermal film" in capsys.readouterr().out


def test_the_column_of_quantities_keeps_its_width_beside_many_others(found):
    page = comparison_page(found)
    assert re.search(r"table\.compared td:first-child \{ min-width: \d+em; \}", page)
    assert page.count('<table class="sheet compared">') == 1 + bool(found[0].choices)


@pytest.mark.parametrize("language_code", ["de", "ru"])
def test_the_page_in_another_language_lacks_no_word_and_has_the_same_numbers(found, language_code):
    with written_in(language_code) as missing:
        made = comparison_page(found)
    assert not list(missing)
    assert f'<html lang="{language_code}">' in made
    cells = re.compile(r'<td class="number">([^<\d]*[\d.,]+)[^<]*</td>')
    numbers = [re.findall(r"[\d.]+", one.replace(",", ".")) for one in cells.findall(made)]
    assert numbers == [re.findall(r"[\d.]+", one) for one in cells.findall(comparison_page(found))]
    (told,) = re.findall(r"<body>(.*?)<h3>[^<]*(?:Warnungen|Предупреждения)", made, re.DOTALL)
    assert not re.search(r"\b(the|of|is|by|film at|neglects|temperatures?|heat)\b", told)


def test_the_command_writes_the_page_in_a_language(tmp_path, monkeypatch, capsys):
    page = tmp_path / "page.html"
    call = [
        "babbitt",
        "compare",
        str(EXAMPLES / "spindle_bearing.yaml"),
        "--report",
        str(page),
        "--language",
        "de",
    ]
    monkeypatch.setattr("sys.argv", call)
    with pytest.raises(SystemExit) as ended:
        main()
    assert not ended.value.code
    assert "Ergebnisse im Vergleich" in page.read_text(encoding="utf-8")
    told = capsys.readouterr()
    assert "what the case asks for" in told.out
    assert "English" not in told.err


@pytest.mark.parametrize("kind", ["screw_heel", "hydrostatic_pad", "jacking_pocket", "tilting_pad_journal"])
def test_pages_of_other_kinds_lack_no_word(kind):
    compared = compare_methods(parse_case(template(kind)))
    for language_code in ("de", "ru"):
        with written_in(language_code) as missing:
            comparison_page(compared)
        assert not list(missing)

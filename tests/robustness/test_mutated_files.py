"""Files and tables with random faults are used or refused with one clear message; thousands more run by hand."""

import sys

import pytest
from answers import run_seeds
from mutated_files import check_mutated_file
from mutated_tables import check_mutated_table

SEEDS = 300
"""Of each generator; ``python benchmarks/robustness/mutated_files.py 1 SEED`` runs one again."""

BATCH = 50


@pytest.mark.parametrize("first", range(1, SEEDS + 1, BATCH))
@pytest.mark.parametrize("check", [check_mutated_file, check_mutated_table])
def test_what_is_wrong_is_told(check, first, tmp_path):
    faults = {seed: check(seed, tmp_path) for seed in range(first, first + BATCH)}
    assert {seed: fault for seed, fault in faults.items() if fault} == {}


def test_an_archive_whose_member_ends_early_cannot_be_read(tmp_path):
    """An EOFError came through, which the command line takes for an interrupt: "Aborted."."""
    assert check_mutated_table(531366, tmp_path) == ""


def test_the_loop_over_seeds_tells_how_it_is_called(monkeypatch, capsys):
    """It ended in a traceback."""
    monkeypatch.setattr(sys, "argv", ["mutated_files.py", "--help"])
    with pytest.raises(SystemExit) as ended:
        run_seeds("case files", check_mutated_file, 6000)
    assert ended.value.code == 0
    assert "6000 where left out" in capsys.readouterr().out


def test_the_loop_over_seeds_runs_those_asked_for(monkeypatch, capsys):
    seeds = []
    monkeypatch.setattr(sys, "argv", ["mutated_files.py", "2", "7"])
    assert run_seeds("case files", lambda seed, folder: seeds.append(seed) or "", 6000) == 0
    assert seeds == [7, 8]
    assert "seeds 7 to 8: 0 wrong" in capsys.readouterr().out

"""Files and tables with random faults are used or refused with one clear message; thousands more run by hand."""

import pytest
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

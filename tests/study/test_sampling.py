"""Joint samples: even, independent, the same for the same seed."""

from __future__ import annotations

import numpy as np
import pytest
from slider_cases import block, slider

from babbitt.study.inputs import inputs_of
from babbitt.study.sampling import batch_sizes, sampled


@pytest.fixture
def inputs(sliders):
    vary = {"width": {"uniform": ["0.1 m", "1.1 m"]}, "length": {"uniform": ["0.1 m", "0.2 m"]}}
    return inputs_of(slider(), block(kind="tolerance", vary=vary))


@pytest.mark.parametrize("sampling", ["latin_hypercube", "sobol", "random"])
def test_the_seed_alone_decides(inputs, sampling):
    first, again, other = (sampled(inputs, 300, sampling, seed) for seed in (3, 3, 4))
    assert np.array_equal(first["width"], again["width"])
    assert not np.array_equal(first["width"], other["width"])
    assert abs(np.corrcoef(first["width"], first["length"])[0, 1]) < 0.2


def test_every_batch_of_a_hypercube_has_one_sample_in_each_layer(inputs):
    width = sampled(inputs, 1000, "latin_hypercube", 0)["width"] - 0.1
    sizes = batch_sizes(1000, "latin_hypercube")
    for batch in np.split(width, np.cumsum(sizes)[:-1]):
        assert sorted(np.floor(batch * batch.size).astype(int)) == list(range(batch.size))


def test_fields_of_one_table_stay_together(sliders, tmp_path):
    rows = "\n".join(f"{10 + number},{2 * (10 + number)}" for number in range(40))
    (tmp_path / "shafts.csv").write_text(f"width [mm],length [mm]\n{rows}\n")
    (tmp_path / "case.yaml").write_text("")
    case = slider()
    case = case.with_origin(type(case.origin)(case.origin.given, tmp_path / "case.yaml", case.origin.reach))
    vary = {name: {"table": "shafts.csv"} for name in ("width", "length")}
    found = sampled(inputs_of(case, block(kind="tolerance", vary=vary)), 200, "latin_hypercube", 0)
    np.testing.assert_allclose(found["length"], 2.0 * found["width"], rtol=1e-12)
    assert np.unique(found["width"]).size == 40

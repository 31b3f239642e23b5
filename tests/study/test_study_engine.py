"""Chunks, workers and the store: the same table whoever computes it, in whatever pieces, from whatever it left."""

from __future__ import annotations

import json
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest
from slider_cases import many_sliders, slider
from studied_cases import block, journal

from babbitt.core.notices import InputError
from babbitt.study.engine import Engine, InterruptedStudyError, NoWatch
from babbitt.study.grids import corners, joint_sample, nominal, stacked
from babbitt.study.plan import plan
from babbitt.study.store import Store
from babbitt.study.study import case_of, open_study, run_study
from babbitt.study.workers import Alone, Given

VARY = {"viscosity": {"uniform": ["20 mPa s", "40 mPa s"]}, "outlet_film": {"normal": ["25 um", "3 um"]}}


def same(one, other):
    assert list(one) == list(other)
    for name in one:
        assert one[name].dtype == other[name].dtype, name
        numbers = one[name].dtype != object
        assert np.array_equal(one[name], other[name], equal_nan=numbers and one[name].dtype.kind == "f"), name


def tolerance(samples=60, **given):
    return plan(slider(), block(kind="tolerance", vary=VARY, samples=samples, **given))


def with_chunks(made, rows):
    """The same plan in chunks of so many rows, however fast this machine is."""
    return replace(made, seconds_a_row=1.0 / rows)


def test_rows_solved_as_arrays_are_those_solved_one_by_one(sliders):
    made = tolerance(200)
    task = replace(made.task, codes=("X102",))
    values, groups = joint_sample(task.inputs, made.block)
    rows = {"row": np.arange(200), "group": groups, **values}
    as_arrays = many_sliders(task, rows)
    for place in range(0, 200, 20):
        case = task.case({name: column[place] for name, column in values.items()})
        (result,) = [one.solve()[0].result for one in case.calculations()]
        assert as_arrays["load"][place] == pytest.approx(result.load, rel=1e-13)
        assert as_arrays["margin"][place] == pytest.approx(result.margin, abs=1e-13)
        assert as_arrays["verdict"][place] == result.verdict.key
        assert as_arrays["failed_checks"][place] == ("" if result.within_limits else "X102")


@pytest.mark.solves_anew
@pytest.mark.parametrize("rows", [1, 7, 16, 4096])
def test_the_table_does_not_depend_on_its_chunks(single_sliders, rows):
    made = tolerance()
    same(run_study(made).columns, run_study(with_chunks(made, rows)).columns)


@pytest.mark.solves_anew
def test_the_table_does_not_depend_on_who_computes_or_in_which_order(single_sliders):
    made = with_chunks(tolerance(), 4)
    with ThreadPoolExecutor(3) as pool:
        same(run_study(made).columns, run_study(made, workers=Given(pool, 3)).columns)


def test_a_study_is_kept_and_read_back(single_sliders, tmp_path):
    made = with_chunks(tolerance(), 16)
    found = run_study(made, folder=tmp_path / "a.study")
    again = open_study(tmp_path / "a.study")
    same(found.columns, again.columns)
    assert again.complete
    assert again.block == made.block
    parts = sorted(path.name for path in (tmp_path / "a.study" / "chunks").iterdir())
    assert parts == [f"part-{number:06d}.parquet" for number in range(5)]
    told = json.loads((tmp_path / "a.study" / "study.json").read_text())
    assert told["rows"] == made.rows == 1 + 60 + 4
    assert str(tmp_path) not in json.dumps(told)


def test_units_stand_with_the_columns(single_sliders, tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    run_study(tolerance(), folder=tmp_path / "a.study")
    schema = parquet.read_schema(tmp_path / "a.study" / "chunks" / "part-000000.parquet")
    assert schema.field("viscosity").metadata == {b"unit": b"Pa s"}
    assert schema.field("load").metadata == {b"unit": b"N"}
    assert schema.field("verdict").metadata is None


def test_a_study_goes_on_where_it_ended(single_sliders, tmp_path, monkeypatch):
    made = with_chunks(tolerance(), 16)
    whole = run_study(made).columns
    run_study(made, folder=tmp_path / "a.study")
    chunks = tmp_path / "a.study" / "chunks"
    for number in (1, 3):
        (chunks / f"part-{number:06d}.parquet").unlink()
    (chunks / ".babbitt-left").write_bytes(b"of a run that was killed")
    computed = []
    submit = Alone.submit

    def counted(self, task, rows):
        computed.append(rows)
        return submit(self, task, rows)

    monkeypatch.setattr(Alone, "submit", counted)
    same(whole, run_study(made, folder=tmp_path / "a.study").columns)
    assert [int(rows["row"][0]) for rows in computed] == [16, 48]
    assert not (chunks / ".babbitt-left").exists()


def test_an_interrupt_keeps_the_finished_chunks(single_sliders, tmp_path, monkeypatch):
    made = with_chunks(tolerance(), 16)
    submit, calls = Alone.submit, []

    def interrupted(self, task, rows):
        calls.append(rows)
        if len(calls) == 4:
            raise KeyboardInterrupt
        return submit(self, task, rows)

    monkeypatch.setattr(Alone, "submit", interrupted)
    with pytest.raises(InterruptedStudyError) as told:
        run_study(made, folder=tmp_path / "a.study")
    assert told.value.rows == 65
    assert open_study(tmp_path / "a.study").rows == told.value.done > 0
    monkeypatch.setattr(Alone, "submit", submit)
    same(run_study(made).columns, run_study(made, folder=tmp_path / "a.study").columns)


THICKER = {"viscosity": {"uniform": ["20 mPa s", "41 mPa s"]}}
OTHERS = {
    "the case": lambda: plan(slider(speed="6 m/s"), block(kind="tolerance", vary=VARY, samples=60)),
    "the study": lambda: tolerance(61),
    "the distributions": lambda: plan(slider(), block(kind="tolerance", vary={**VARY, **THICKER}, samples=60)),
}


@pytest.mark.parametrize("what", OTHERS)
def test_another_study_is_not_mixed_in(single_sliders, tmp_path, what):
    run_study(tolerance(), folder=tmp_path / "a.study")
    with pytest.raises(InputError, match=what) as refused:
        run_study(OTHERS[what](), folder=tmp_path / "a.study")
    assert "choose another --out" in refused.value.message


def test_another_version_is_not_mixed_in(single_sliders, tmp_path):
    run_study(tolerance(), folder=tmp_path / "a.study")
    file = tmp_path / "a.study" / "study.json"
    file.write_text(file.read_text().replace('"babbitt": "', '"babbitt": "0.'))
    with pytest.raises(InputError, match="the version of Babbitt"):
        run_study(tolerance(), folder=tmp_path / "a.study")


def test_a_folder_with_something_else_is_left_alone(single_sliders, tmp_path):
    (tmp_path / "a.study").mkdir()
    (tmp_path / "a.study" / "notes.txt").write_text("mine")
    with pytest.raises(InputError, match="holds no study"):
        run_study(tolerance(), folder=tmp_path / "a.study")
    assert [path.name for path in (tmp_path / "a.study").iterdir()] == ["notes.txt"]


def test_two_writers_are_refused(single_sliders, tmp_path):
    made = tolerance()
    first = Store(tmp_path / "a.study")
    first.begin(made.description)
    with pytest.raises(InputError, match="is in use"):
        run_study(made, folder=tmp_path / "a.study")
    first.close()
    assert run_study(made, folder=tmp_path / "a.study").complete


def test_a_disk_that_is_full_leaves_what_was_stored(single_sliders, tmp_path, monkeypatch):
    from babbitt.core.files import writing

    made = with_chunks(tolerance(), 16)
    write, calls = writing._write_beside, []

    def full(target, named, content):
        calls.append(target)
        if len(calls) == 4:  # the description, two chunks, then nothing more
            raise writing._cannot_write(named, OSError(28, "No space left on device"))
        return write(target, named, content)

    monkeypatch.setattr(writing, "_write_beside", full)
    with pytest.raises(InputError, match="No space left on device; the finished chunks are kept") as told:
        run_study(made, folder=tmp_path / "a.study")
    assert "\n" not in told.value.message
    assert open_study(tmp_path / "a.study").rows == 32


def test_rows_that_fail_stop_nothing(single_sliders):
    films = {"values": ["20 um", "59 um", "60 um", "70 um"]}  # from 60 um on the film does not narrow
    found = run_study(plan(slider(), block(kind="sweep", vary={"outlet_film": films}))).columns
    assert found["status"].tolist() == ["converged", "converged", "refused", "refused"]
    assert found["verdict"].tolist() == ["pass", "pass", "no_solution", "no_solution"]
    assert np.isnan(found["load"][2:]).all()
    assert all("does not narrow" in message for message in found["message"][2:])


def test_a_row_of_a_study_is_the_case_with_its_values():
    vary = {"clearance": {"fit": "H7/e8"}, "lubricant": {"scatter": "vg"}, "load": {"uniform": ["10 kN", "20 kN"]}}
    found = run_study(plan(journal(), block(kind="tolerance", vary=vary, samples=3)))
    for row in (0, 2, 5):
        (result,) = [one.solve()[0].result for one in case_of(found, row).calculations()]
        assert found.columns["minimum_film_thickness"][row] == result.minimum_film_thickness
        assert found.columns["margin"][row] == result.margin
        assert found.columns["load"][row] == pytest.approx(result.load)


def test_a_chunk_of_other_samples_is_refused(single_sliders, tmp_path):
    made = tolerance()
    store = Store(tmp_path / "a.study")
    store.begin(made.description)
    inputs = made.task.inputs
    rows = stacked([nominal(inputs), joint_sample(inputs, made.block), corners(inputs)])
    Engine(made.task, Alone(), 128, store, NoWatch()).answers(*rows)
    rows[0]["viscosity"][3] *= 1.1
    with pytest.raises(InputError, match="chunks of other samples"):
        Engine(made.task, Alone(), 128, store, NoWatch()).answers(*rows)
    store.close()

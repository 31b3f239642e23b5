"""Studies in processes of their own: the same table, kills and interrupts, a cluster."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from concurrent.futures import BrokenExecutor
from pathlib import Path
from threading import Event

import numpy as np
import pytest
import yaml
from studied_cases import JOURNAL, block, journal
from test_study_engine import same, with_chunks

from babbitt.study.plan import plan
from babbitt.study.study import open_study, run_study
from babbitt.study.workers import Cluster, Processes

pytestmark = pytest.mark.slow

STUDY = {
    "kind": "tolerance",
    "samples": 400,
    "outputs": ["minimum_film_thickness", "friction_power", "iterations"],  # iterations: row by row, not as arrays
    "vary": {"clearance": {"fit": "H7/e8"}, "load": {"uniform": ["20 kN", "60 kN"]}},
}


@pytest.fixture(scope="module")
def made():
    return with_chunks(plan(journal(), block(**{**STUDY, "samples": 60})), 8)


@pytest.fixture(scope="module")
def table(made):
    return run_study(made).columns


def test_two_processes_give_the_table_of_one(made, table):
    same(table, run_study(made, workers=Processes(2)).columns)


def test_a_process_that_is_killed_costs_its_chunks_only(made, table, monkeypatch):
    from babbitt.study.engine import Engine

    hands, take, killed = Processes(2), Engine._take, []

    def killing(self, future, running, done):
        if len(done) == 2 and not killed:
            killed.append(True)
            os.kill(next(iter(hands._pool._processes)), signal.SIGKILL)
        return take(self, future, running, done)

    monkeypatch.setattr(Engine, "_take", killing)
    same(table, run_study(made, workers=hands).columns)
    assert killed


def test_a_chunk_that_is_handed_over_when_a_process_is_lost_fails_by_itself(made, table):
    """The study ended with BrokenProcessPool where a process was lost between two chunks."""
    hands = Processes(1)
    rows = {"row": np.arange(1), **{one.path: table[one.path][:1] for one in made.task.inputs}}
    assert hands.submit(made.task, rows).result()["row"].tolist() == [0]
    os.kill(next(iter(hands._pool._processes)), signal.SIGKILL)
    while hands.submit(made.task, rows).exception() is None:
        pass  # the loss is not known yet
    assert isinstance(hands.submit(made.task, rows).exception(), BrokenExecutor)
    assert hands.renew()
    assert hands.submit(made.task, rows).result()["row"].tolist() == [0]
    hands.stop()


@pytest.mark.thorough
def test_a_local_cluster_gives_the_same_table_though_a_worker_is_killed(made, table, monkeypatch):
    distributed = pytest.importorskip("distributed")
    from babbitt.study.engine import Engine

    options = {"n_workers": 2, "threads_per_worker": 1, "dashboard_address": None, "processes": True}
    with distributed.LocalCluster(**options) as cluster:
        take, killed = Engine._take, []

        def killing(self, future, running, done):
            if len(done) == 2 and not killed:
                killed.append(True)
                os.kill(next(iter(cluster.workers.values())).pid, signal.SIGKILL)
            return take(self, future, running, done)

        monkeypatch.setattr(Engine, "_take", killing)
        same(table, run_study(made, workers=Cluster(cluster.scheduler_address)).columns)
        assert killed


def _started(folder: Path, *options: str) -> subprocess.Popen:
    file = folder / "case.yaml"
    file.write_text(yaml.safe_dump({**JOURNAL, "study": STUDY}, sort_keys=False))
    command = [sys.executable, "-m", "babbitt", "study", "case.yaml", "--out", "a.study", *options]
    quiet = subprocess.PIPE
    return subprocess.Popen(command, cwd=folder, stdout=quiet, stderr=quiet, text=True, start_new_session=True)


def _chunks(folder: Path) -> list[Path]:
    return sorted((folder / "a.study" / "chunks").glob("part-*"))


def _wait_for_chunks(folder: Path, count: int, process: subprocess.Popen) -> None:
    while len(_chunks(folder)) < count and process.poll() is None:
        Event().wait(0.01)


@pytest.mark.thorough
def test_a_study_that_is_killed_goes_on_to_the_table_of_an_undisturbed_one(tmp_path):
    import pyarrow.parquet as parquet

    pieces = np.random.default_rng(5).integers(0, 3, 4)
    for more in pieces:
        process = _started(tmp_path, "--workers", "2")
        _wait_for_chunks(tmp_path, len(_chunks(tmp_path)) + int(more), process)
        process.kill()
        process.communicate()
        for part in _chunks(tmp_path):
            assert parquet.read_table(part).num_rows > 0, "what has its final name is whole"
    process = _started(tmp_path, "--workers", "2")
    _, err = process.communicate()
    assert (process.returncode, err) == (0, "")
    whole = run_study(plan(journal(), block(**STUDY))).columns
    same(whole, open_study(tmp_path / "a.study").columns)


@pytest.mark.skipif(os.name == "nt", reason="interrupts of a process group")
@pytest.mark.parametrize("workers", ["1", "2"])
def test_an_interrupt_ends_it_at_once_with_what_is_finished(tmp_path, workers):
    process = _started(tmp_path, "--workers", workers)
    _wait_for_chunks(tmp_path, 2, process)
    os.killpg(process.pid, signal.SIGINT)  # as a terminal does: to the program and all that it started
    _, err = process.communicate(timeout=20)
    assert process.returncode == 130
    assert "the same command goes on" in err
    assert len(err.strip().splitlines()) == 1
    assert 0 < open_study(tmp_path / "a.study").rows < 405

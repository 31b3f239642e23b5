"""Worker processes: bounded, replaced when they die, and the latest question is answered."""

import asyncio
import os
import signal
import threading

import pytest

from babbitt.app.solver import Ended, Latest, Solver, outcome_of

pytestmark = pytest.mark.slow
FOREVER = 600.0


@pytest.fixture(scope="module")
def solver():
    made = Solver(workers=1)
    yield made
    made.close()


def doubled(number):
    return 2 * number


def asleep():
    threading.Event().wait(FOREVER)


def killed_once(trace):
    """Kills its own process while it is at work, but for the second time."""
    if not trace.exists():
        trace.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return 42


class LastWords:
    """An answer whose process is killed while it is sent, but for the second time."""

    def __init__(self, trace):
        self.trace = trace

    def __reduce__(self):
        return int, (killed_once(self.trace),)


def soon(questions, *asked):
    """The answer, within a time that starting a process anew takes on a busy machine."""
    return asyncio.run(asyncio.wait_for(questions.ask(*asked), 300.0))


@pytest.mark.parametrize("function", [killed_once, LastWords])
def test_a_change_is_answered_though_its_process_was_killed(solver, tmp_path, function):
    """At work, and while it held the pipe of its answer: the question is asked again."""
    assert soon(Latest(solver), function, tmp_path / "latest") == 42
    assert soon(solver, function, tmp_path / "any") == 42
    assert soon(solver, doubled, 21) == 42


def test_an_answer_comes_from_another_process(solver):
    assert asyncio.run(solver.ask(os.getpid)) != os.getpid()


def test_the_latest_question_is_answered_though_its_process_was_killed(solver):
    killed = asyncio.run(solver.ask(os.getpid))
    os.kill(killed, signal.SIGKILL)
    assert asyncio.run(Latest(solver).ask(doubled, 21)) == 42
    assert asyncio.run(solver.ask(os.getpid)) != killed


def test_a_busy_process_that_is_killed_ends_its_question_alone(solver):
    async def asked():
        process = await solver.ask(os.getpid)
        waiting = solver.start(asleep, longest=FOREVER)
        while not waiting.running():
            await asyncio.sleep(0.05)
        os.kill(process, signal.SIGKILL)
        with pytest.raises(Ended) as ended:
            await outcome_of(waiting)
        return ended.value.why, await solver.ask(doubled, 21)

    assert asyncio.run(asked()) == ("died", 42)


def test_what_takes_too_long_is_ended(solver):
    with pytest.raises(Ended) as ended:
        asyncio.run(solver.ask(asleep, longest=0.2))
    assert ended.value.why == "too_long"


def test_of_questions_that_wait_the_latest_is_answered(solver):
    async def asked():
        latest = Latest(solver)
        return await asyncio.gather(*(latest.ask(doubled, number) for number in range(5)))

    first, *between, last = asyncio.run(asked())
    assert last == 8
    assert first in (0, None)
    assert between == [None] * 3


def test_a_question_that_waits_for_a_process_can_be_withdrawn(solver):
    async def asked():
        latest, busy = Latest(solver), solver.start(asleep, longest=0.5)
        while not busy.running():
            await asyncio.sleep(0.05)
        waiting = asyncio.create_task(latest.ask(doubled, 1))
        await asyncio.sleep(0.1)
        latest.withdraw()
        with pytest.raises(Ended) as ended:
            await waiting
        return busy.done(), ended.value.why, await latest.ask(doubled, 2)

    assert asyncio.run(asked()) == (False, "cancelled", 4)

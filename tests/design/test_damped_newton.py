"""Newton's method that keeps a gap open: equilibria of a journal before a wall, and a status at every end."""

from dataclasses import dataclass, field

import numpy as np
import pytest

from babbitt.numerics.damped_newton import damped_newton, halved_for_room


@dataclass
class Wall:
    """A film before a wall at x = 1: it carries 1/(1 - x)^2 - 1, and the gap is 1 - x."""

    load: float
    kept: float = 0.25
    no_room: str = "no room"
    too_many_steps: str = "too many"
    places: list[float] = field(default_factory=list)

    def room(self, at):
        return 1.0 - float(at[0])

    def kept_room(self, at, room):
        return self.kept * room

    def look(self, at, step):
        self.places.append(float(at[0]))
        self.left = self.load - (self.room(at) ** -2 - 1.0)
        return "carried" if abs(self.left) < 1e-9 * self.load else None

    def move(self, at, room):
        return np.array([self.left * room**3 / 2.0])


@pytest.mark.parametrize("load", [0.1, 1.0, 50.0, 1e6])
def test_every_load_is_carried_before_the_wall(load):
    """Newton from afar would step through the wall; no step takes more than three quarters of the gap."""
    wall = Wall(load)
    found = damped_newton(wall, np.zeros(1), 60)
    assert found.status == "carried"
    assert found.room == pytest.approx((1.0 + load) ** -0.5, rel=1e-8)
    gaps = 1.0 - np.array(wall.places)
    assert (gaps[1:] > 0.25 * gaps[:-1]).all()
    assert found.steps == len(wall.places)


def test_every_search_ends_with_a_status():
    assert damped_newton(Wall(1e6), np.zeros(1), 3).status == "too many"
    assert damped_newton(Wall(1.0), np.array([2.0]), 9).status == "no room"
    thin = damped_newton(Wall(1e6), np.zeros(1), 60, least_room=0.1)
    assert thin.status == "no room"
    assert thin.room > 0.1
    nowhere = Wall(1.0)
    nowhere.move = lambda at, room: None
    assert damped_newton(nowhere, np.zeros(1), 9).status == "no room"


def test_a_step_is_halved_as_often_as_allowed():
    def room(at):
        return 1.0 - float(at[0])

    step, left = halved_for_room(room, np.zeros(1), np.array([8.0]), 0.4, 4)
    assert step == pytest.approx([0.5])
    assert left == pytest.approx(0.5)
    assert halved_for_room(room, np.zeros(1), np.array([8.0]), 0.4, 3) is None

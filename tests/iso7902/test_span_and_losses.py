"""The rule of conventional spans, and pressure losses against Hagen-Poiseuille and published figures."""

import math

import pytest
from design_cases import oil
from hypothesis import given
from hypothesis import strategies as st

from babbitt.design.ducts import Duct, pipe_friction_factor
from babbitt.design.span import SpanRounding, conventional_span


@pytest.mark.parametrize(
    ("entry", "exit_", "rounding", "expected"),
    [
        (65, 94, SpanRounding.DOWN, 120),  # second-stage pinion, variant (a): 130 -> 120 as published
        (65, 94, SpanRounding.NEAREST, 120),
        (94, 65, SpanRounding.DOWN, 180),  # variant (b): 188 -> 180, the exit edge at 65 is disregarded
        (94, 50, SpanRounding.DOWN, 90),  # the exit edge within 60 limits: 100 -> 90
        (80, 90, SpanRounding.DOWN, 150),
        (80, 90, SpanRounding.NEAREST, 150),
        (85, 90, SpanRounding.NEAREST, 180),
        (40, 90, SpanRounding.DOWN, 90),
    ],
)
def test_spans(entry, exit_, rounding, expected):
    span = conventional_span(math.radians(entry), math.radians(exit_), rounding)
    assert span.tabulated == expected
    assert span.too_short == (2 * min(entry, exit_ if exit_ < 60 else entry) < 90)


@given(entry=st.floats(45.0, 180.0), exit_=st.floats(45.0, 180.0))
def test_rounding_down_never_promises_more_arc_than_there_is(entry, exit_):
    span = conventional_span(math.radians(entry), math.radians(exit_))
    assert math.radians(span.tabulated) <= span.exact + 1e-9


@given(flow=st.floats(1e-9, 1e-5))
def test_laminar_tube_is_hagen_poiseuille(flow):
    diameter, length, density, nu = 0.02, 3.0, 880.0, 40e-6
    exact = 128.0 * density * nu * length * flow / (math.pi * diameter**4)
    assert Duct(diameter, length).pressure_loss(flow, density, nu) == pytest.approx(exact, rel=1e-12)


def test_friction_factor_is_continuous():
    for edge in (2300.0, 4000.0):
        assert pipe_friction_factor(edge * (1 - 1e-9)) == pytest.approx(pipe_friction_factor(edge), rel=1e-6)


def test_ducts_in_parallel_share_the_flow():
    one = Duct(0.02, 1.0, 1.5).pressure_loss(1e-4, 880.0, 40e-6)
    assert Duct(0.02, 1.0, 1.5, number=2).pressure_loss(2e-4, 880.0, 40e-6) == pytest.approx(one)


def test_published_tube_of_the_gas_turbine_pinion():
    # 36.1 L/min through 3 m of 24 mm, oil 63.5/8.0; the 13 200 Pa of the study are met with the viscosity of 40 °C
    lubricant, flow = oil(63.5, 8.0, 895.0), 36.1 / 6e4

    def loss(duct: Duct, celsius: float) -> float:
        kelvin = celsius + 273.15
        return duct.pressure_loss(flow, lubricant.density(kelvin), lubricant.kinematic_viscosity(kelvin))

    assert loss(Duct(0.024, 3.0), 50.0) == pytest.approx(7728.0, rel=1e-3)
    assert loss(Duct(0.024, 3.0, 1.0), 50.0) == pytest.approx(8503.0, rel=1e-3)
    assert loss(Duct(0.024, 3.0, 1.0), 40.0) == pytest.approx(13201.0, rel=1e-3)
    assert loss(Duct(0.024, 0.0, 1.5), 50.0) == pytest.approx(1162.0, rel=1e-3)

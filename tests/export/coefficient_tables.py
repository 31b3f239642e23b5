"""Tables to test the exchange with."""

import math

import numpy as np

from babbitt.export import CoefficientTable, Frame


def table(name="Drive end", speeds=8, **given):
    """Smooth coefficients of a plausible bearing over speed: stiffening, damping falling, cross-coupled."""
    omega = np.linspace(60.0, 320.0, speeds) if speeds > 1 else np.array([200.0])
    k = np.stack([0.9e9 + 2e6 * omega, 0.3e9 - 1e6 * omega, -1.2e9 - 4e6 * omega, 1.5e9 + 1e6 * omega], axis=-1)
    c = np.stack([4e9 / omega, -2e9 / omega, -2.2e9 / omega, 9e9 / omega], axis=-1)
    values = {
        "speeds": omega,
        "stiffness": k.reshape(-1, 2, 2),
        "damping": c.reshape(-1, 2, 2),
        "frame": Frame(load_angle=math.radians(-75.0)),
        "static": {"load": 1e5 + 3.0 * omega, "eccentricity_ratio": 0.7 - 1e-3 * omega},
        "method": "closed form, for tests",
    }
    return CoefficientTable(name=name, **(values | given))


def assert_same(one, other, rtol=0.0, static=True):
    """Equal to the last digit, or to a relative tolerance where a format has fewer digits."""
    assert one.name == other.name
    assert one.method == other.method
    assert one.temperatures == other.temperatures
    assert one.frame.rotation is other.frame.rotation
    for angle in ("load_angle", "x_axis_angle"):
        mine, theirs = getattr(one.frame, angle), getattr(other.frame, angle)
        assert (mine is None) == (theirs is None)
        if mine is not None:
            assert abs(mine - theirs) <= max(rtol, 1e-12)
    np.testing.assert_allclose(one.speeds, other.speeds, rtol=rtol)
    np.testing.assert_allclose(one.stiffness, other.stiffness, rtol=rtol)
    np.testing.assert_allclose(one.damping, other.damping, rtol=rtol)
    assert (one.mass is None) == (other.mass is None)
    if one.mass is not None:
        np.testing.assert_allclose(one.mass, other.mass, rtol=rtol)
    if static:
        assert set(one.static) == set(other.static)
        for name, values in one.static.items():
            np.testing.assert_allclose(values, other.static[name], rtol=rtol)

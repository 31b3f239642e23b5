"""Pictures against closed forms: angles of pads, places of journals, enlarged films, arrows and their forces."""

import itertools
import math

import numpy as np
import pytest
from drawn import changed, drawn

from babbitt.kinds.hydrostatic.geometry import ThrustRing
from babbitt.kinds.hydrostatic.report.picture_journal import PLAY
from babbitt.kinds.hydrostatic.report.picture_section import gap_at
from babbitt.kinds.shaft.report.picture import ARROW
from babbitt.kinds.thrust.report.picture import LENGTH

LEVEL = {"tilt": None, "runout": None}
FIXED = {"pads__pivot": {"kind": "fixed"}, "pads__face": {"kind": "taper", "depth": "40 um", "fraction": 0.7}}


def one(text):
    ((solution, picture),) = drawn(text)
    return solution, picture


def pads_of(picture, number):
    """Outlines of the pads as complex numbers, the leading edge first; the last of all stands in the section."""
    return [shape.points @ (1.0, 1j) for shape in picture.of("bush pad")[:number]]


def test_pads_stand_at_even_angles_about_their_pivots():
    solution, picture = one(changed("thrust"))
    pad, pivots = solution.problem.bearing.pad, picture.of("pivot", "circle")
    for number, (outline, pivot) in enumerate(zip(pads_of(picture, 8), pivots, strict=True)):
        place = complex(*pivot.points[0])
        assert abs(place) == pytest.approx(0.29 / 0.375, rel=1e-4)
        at = np.exp(1j * math.radians(45.0 * number))
        assert place / abs(place) == pytest.approx(at, abs=1e-3)
        edges = np.angle(outline[[0, 24]] / at)  # of 36 deg, 60 % before the pivot
        assert np.degrees(edges) == pytest.approx([-21.6, 14.4], abs=0.02)
        assert np.abs(outline[:25]) == pytest.approx(np.ones(25), rel=1e-4)
        assert np.abs(outline[25:]) == pytest.approx(np.full(25, pad.inner_radius / pad.outer_radius), rel=1e-4)


def test_the_other_sense_gives_the_mirrored_picture():
    """Backward, with the pivot as far from the edge that leads then, pads and section are those of a mirror."""
    _, ahead = one(changed("thrust", **LEVEL))
    _, astern = one(changed("thrust", **LEVEL, speed="-125 rpm", pads__pivot__fraction=0.4))
    mirrored = [pads_of(ahead, 8)[-number].conj() for number in range(8)]
    for here, there in zip(pads_of(astern, 8), mirrored, strict=True):
        assert here == pytest.approx(there, abs=1e-4)
    (film,), (turned,) = ahead.of("film"), astern.of("film")
    assert film.points[:, 0] == pytest.approx(-turned.points[:, 0], abs=1e-4)
    assert film.points[:, 1] == pytest.approx(turned.points[:, 1], abs=1e-3)


@pytest.mark.parametrize("changes", [{}, LEVEL | FIXED | {"load": "300 kN"}], ids=["pivoted", "taper"])
def test_the_section_of_a_pad_has_its_film(changes):
    """At the pivot it is h_p, and at its thinnest on the radius of the pivot no less than h_min of the pad."""
    solution, picture = one(changed("thrust", **changes))
    share = solution.state.share
    state = share.states[int(share.loads.argmax())]
    pad = state.pad
    scale = picture.factor("film") * LENGTH / (pad.extent * pad.pivot_radius)
    (film,) = picture.of("film")
    face, collar = film.points[:-2], film.points[-1, 1]
    drawn_gap = (collar - face[:, 1]) / scale
    at_pivot = np.interp(pad.pivot_fraction, np.linspace(0.0, 1.0, face.shape[0]), drawn_gap)
    of_face = pad.face.offset(pad.pivot_fraction, True)
    assert at_pivot == pytest.approx(state.height + of_face, rel=2e-3)
    assert drawn_gap.min() > (1.0 - 1e-3) * state.minimum_film_thickness


def test_the_housing_can_be_turned_by_its_arrow():
    _, picture = one(changed("thrust", tilt={"offset": "30 um", "direction": "50 deg"}))
    arrow = next(shape for shape in picture.shapes if shape.style == "tilt line handle")
    assert arrow.given["data-field"] == "tilt.direction"
    assert np.degrees(np.arctan2(*(arrow.points[-1] - arrow.points[0])[::-1])) == pytest.approx(50.0, abs=0.1)


@pytest.mark.parametrize("method", ["film", "quick"])
@pytest.mark.parametrize("angle", [-90.0, 30.0])
def test_a_hydrostatic_journal_stands_at_its_eccentricity(method, angle):
    solution, picture = one(changed("hydrostatic_journal", method=method, load_angle=f"{angle:g} deg"))
    x, y = picture.of("journal", "circle")[0].points[0]
    found = solution.result.values
    assert math.hypot(x, y) / PLAY == pytest.approx(found["eccentricity_ratio"], rel=1e-3)
    turned = math.degrees(math.atan2(y, x)) - angle
    assert (turned + 180.0) % 360.0 - 180.0 == pytest.approx(math.degrees(found["attitude_angle"]), abs=0.2)
    assert picture.factor("film") == pytest.approx(PLAY * 50.0 / 0.05, rel=1e-3)
    load = next(shape for shape in picture.shapes if shape.style == "load line handle")
    assert float(load.given["data-angle"]) == pytest.approx(angle)


def test_a_found_load_is_not_to_be_turned():
    """With a given place the load follows: its arrow points where the film pushes back, and no hand holds it."""
    text = changed(
        "hydrostatic_journal", load=None, load_angle=None, eccentricity_ratio=0.5, attitude_angle="0 deg"
    )
    solution, picture = one(text)
    (line,) = picture.of("load line")
    x, y = line.points[-1] - line.points[0]
    force = solution.state.found.response.force
    assert math.atan2(y, x) == pytest.approx(math.atan2(-force[1], -force[0]), abs=1e-3)


def test_an_overloaded_bearing_is_drawn_without_load_and_pressure():
    solution, picture = one(changed("hydrostatic_journal", load="800 kN"))
    assert not solution.result.outcome.solved
    assert not picture.of("pressure")
    assert not [shape for shape in picture.shapes if shape.style.startswith("load")]
    assert len(picture.of("film")) == 4  # recesses


def test_recesses_of_a_ring_stand_where_they_are():
    """Four of 60 deg between radii of 65 and 85 mm of 100 mm, the first at 45 deg."""
    _, picture = one(changed("hydrostatic_thrust_ring"))
    for number, recess in enumerate(picture.of("recess")):
        place = recess.points @ (1.0, 1j) * np.exp(-1j * math.radians(45.0 + 90.0 * number))
        assert np.degrees(np.angle(place)) == pytest.approx(
            np.append(*[np.linspace(-30.0, 30.0, 25)[::s] for s in (1, -1)]), abs=0.02
        )
        assert np.sort(np.unique(np.abs(place).round(3))) == pytest.approx([0.65, 0.85])


@pytest.mark.parametrize("method", ["film", "quick"])
def test_gaps_of_a_ring_that_does_not_turn_are_in_the_order_of_pressures(method):
    """Of like restrictors the thinnest film holds back most: gaps over recesses are in the order of pressures."""
    text = changed("hydrostatic_thrust_ring", method=method, speed="0 rpm", moments=["200 N m", "100 N m"])
    solution, _ = one(text)
    middles = 0.075 * np.exp(1j * np.radians([45.0, 135.0, 225.0, 315.0]))
    thick = gap_at(solution.state.found, middles.real, middles.imag)
    assert thick.argsort().tolist() == (-solution.state.found.network.pressures).argsort().tolist()


@pytest.mark.parametrize("method", ["film", "quick"])
def test_the_gap_of_a_tilted_ring_is_that_of_its_result(method):
    """Smallest over the outer edge; in the section the tilt shows as a wave of its amplitude at the recesses."""
    solution, picture = one(changed("hydrostatic_thrust_ring", method=method))
    found, shape = solution.state.found, solution.problem.shape
    assert isinstance(shape, ThrustRing)
    around = np.linspace(0.0, 2.0 * math.pi, 3601)
    outer = shape.radii.outer_radius
    gap = gap_at(found, outer * np.cos(around), outer * np.sin(around))
    assert gap.min() == pytest.approx(solution.result.values["minimum_film_thickness"], rel=2e-3)
    film = max(picture.of("film"), key=lambda one: one.points.shape[0])
    runner = film.points[:-2, 1] - film.points[-1, 1]
    scale = picture.factor("film") / (math.pi * 0.075)
    assert np.ptp(runner) / scale == pytest.approx(np.ptp(gap) * 0.075 / outer, rel=5e-3)
    assert (runner / scale).mean() == pytest.approx(gap[:-1].mean(), rel=5e-3)


@pytest.mark.parametrize(
    ("pad", "across"),
    [
        ({"kind": "circular", "diameter": "100 mm", "recess_diameter": "50 mm"}, 1.0 / 0.05),
        (
            {
                "kind": "annular", "inner_diameter": "100 mm", "recess_inner_diameter": "130 mm",
                "recess_outer_diameter": "170 mm", "outer_diameter": "200 mm",
            },
            1.0 / 0.1,
        ),
        (
            {
                "kind": "rectangular", "length": "200 mm", "width": "100 mm", "recess_length": "160 mm",
                "recess_width": "60 mm",
            },
            1.0 / 0.1,
        ),
    ],
    ids=["circular", "annular", "rectangular"],
)  # fmt: skip
def test_the_film_of_a_pad_is_as_thick_as_its_gap(pad, across):
    speed = {"speed": None, "sliding_speed": "0.5 m/s"} if pad["kind"] == "rectangular" else {}
    solution, picture = one(changed("hydrostatic_pad", pad=pad, **speed))
    film = max(picture.of("film"), key=lambda one: one.points.shape[0])
    thick = np.ptp(film.points[:, 1]) / across / picture.factor("film")
    assert thick == pytest.approx(solution.result.values["minimum_film_thickness"], rel=2e-3)


def test_a_lifted_shaft_stands_over_its_pockets():
    _, picture = one(changed("jacking_pocket"))
    x, y = picture.of("journal", "circle")[0].points[0]
    assert x == pytest.approx(0.0, abs=1e-6)
    assert -y / PLAY == pytest.approx(1.0 - 40.0 / 150.0, rel=1e-3)


def test_films_and_grooves_of_a_footstep():
    """Both films by one factor; z grooves and lands close around the heel: z (a + b) = 2 pi r sin(phi)."""
    (_, smooth), (solution, grooved) = drawn(changed("screw_heel", clearance={"kind": "radial", "mean": "15 um"}))
    assert not smooth.of("groove")
    factor, radius = grooved.factor("film"), 21.8e-3
    oil = max(grooved.of("film"), key=lambda one: np.ptp(one.points[:, 1]))
    (heel,) = grooved.of("journal")
    assert np.ptp(oil.points[:, 0]) - np.ptp(heel.points[:, 0]) == pytest.approx(
        2.0 * factor * 15e-6 / radius, rel=2e-2
    )
    assert heel.points[:, 1].min() - oil.points[:, 1].min() == pytest.approx(factor * 20e-6 / radius, rel=2e-2)
    middles = sorted(float(one.points[20, 1]) for one in grooved.of("groove"))
    groove = solution.problem.footstep.groove
    within = [b - a for a, b in itertools.pairwise(middles) if b - a > 1e-3]
    pitch = radius * float(np.median(within)) * math.cos(groove.angle)
    misfit = groove.misfit(radius)
    assert pitch == pytest.approx((groove.groove_width + groove.land_width) / (1.0 + misfit), rel=2e-2)


def test_a_tilted_heel_comes_nearer_at_its_rim():
    """Displaced by the factor times (epsilon c + half the length times the slope) at the rim."""
    text = changed("screw_heel", variants="smooth", eccentricity_ratio=0.5, tilt="0.01 deg")
    _, picture = one(text)
    (heel,) = picture.of("journal")
    at_rim = heel.points[heel.points[:, 1] == heel.points[:, 1].min()]
    aside = 0.5 * 20e-6 + 0.5 * 35e-3 * math.radians(0.01)
    assert at_rim[:, 0].mean() == pytest.approx(picture.factor("film") * aside / 21.8e-3, rel=2e-2)


def arrows(picture, style):
    return [(shape.points[1] - shape.points[0]) for shape in picture.of(f"{style} line")]


def test_arrows_on_a_shaft_are_in_equilibrium():
    """Arrows of loads and reactions add up to nothing in both views: lengths are forces, weights fall."""
    _, picture = one(changed("overhung_coupling"))
    mesh, weight, half_coupling, _ = arrows(picture, "load")
    force = 200e3 * math.cos(math.radians(20.0)) / ARROW
    assert mesh == pytest.approx((0.0, ARROW), abs=1e-4)
    assert weight == pytest.approx((0.0, -3000.0 * 9.80665 / force), abs=1e-4)
    assert half_coupling == pytest.approx((0.0, -300.0 * 9.80665 / force), abs=1e-4)
    total = sum(arrows(picture, "load"), np.zeros(2)) + sum(arrows(picture, "reaction"), np.zeros(2))
    assert total == pytest.approx((0.0, 0.0), abs=1e-3)


def test_the_reactions_of_a_coupled_shaft_are_those_of_its_result():
    """Of each bearing the arrows of both views give the size; the mesh force times cos 20 deg is the longest."""
    solution, picture = one(changed("overhung_coupling"))
    scale = 200e3 * math.cos(math.radians(20.0)) / ARROW
    found = arrows(picture, "reaction")
    for number in (0, 1):
        up, right = found[number][1], found[2 + number][1]
        assert scale * math.hypot(up, right) == pytest.approx(
            solution.result.values[f"reaction_{number + 1}"], rel=2e-3
        )


def test_a_shaft_bends_as_far_as_its_result_says():
    solution, picture = drawn(changed("shaft"))[0]
    side, above = (shape.points for shape in picture.of("curve"))
    axes = [shape.points[0, 1] for shape in picture.of("dashed")]
    aside = np.hypot(side[:, 1] - axes[0], above[:, 1] - axes[1]) * 0.17 / picture.factor("deflection")
    assert aside.max() == pytest.approx(solution.result.values["shaft_deflection"], rel=5e-3)
    assert (side[:, 1] - axes[0]).min() == pytest.approx(
        solution.state.curves.deflection[:, 1].min() * picture.factor("deflection") / 0.17, rel=5e-3
    )
    piece = picture.of("journal")[0]
    assert np.ptp(piece.points, axis=0) * 0.17 == pytest.approx((0.2, 0.08), rel=1e-3)
    gears = [np.ptp(gear.points[:, 1]) * 0.17 for gear in picture.of("bush pad")[:2]]
    assert gears == pytest.approx([0.3, 0.11], rel=1e-3)


def test_sizes_of_loads_on_a_shaft_stand_with_the_names_of_what_loads_it():
    """From the side, where short arrows meet: each size once, with its name, and no number alone."""
    (_, picture), *_ = drawn(changed("overhung_coupling"))
    said = picture.words()
    assert {"Gear and shaft: y 29.42 kN", "Mesh: y 187.9 kN"} <= set(said)
    assert not {"29.42 kN", "187.9 kN"} & set(said)
    assert "68.40 kN" in said  # of the mesh from above, where it stands alone


def test_a_shaft_line_is_drawn_to_two_scales():
    """Lengths of the pieces, and diameters of solid rods of their area times the factor."""
    pieces = [
        {"length": "20 m", "diameter": "360 mm", "end_mass": "300 kg"},
        {"length": "10 m", "diameter": "400 mm", "inner_diameter": "240 mm"},
    ]
    solution, picture = one(changed("thrust_line", shaft=pieces))
    first, second = (shape.points for shape in picture.of("journal")[:2])
    assert np.ptp(first[:, 0]) == pytest.approx(2.0 * np.ptp(second[:, 0]), rel=1e-3)
    across = picture.factor("diameters") * np.ptp(first[:, 0]) / 20.0
    assert np.ptp(first[:, 1]) == pytest.approx(0.36 * across, rel=1e-3)
    assert np.ptp(second[:, 1]) == pytest.approx(0.32 * across, rel=1e-3)  # sqrt(0.4^2 - 0.24^2)
    assert "300 kg" in picture.words()
    assert "L = 30 m" in picture.words()  # the factor stands below it, clear of the words of the ring
    amplitude = solution.result.values["axial_amplitude"]
    assert any(f"{1e6 * amplitude:.3g} µm" in one for one in picture.words())


@pytest.mark.parametrize(
    ("kind", "changes", "geometry", "count"),
    [
        ("thrust", {"load": "500 MN"}, "bush pad", 8),
        ("thrust_line", {"load": "500 MN"}, "pivot", 8),
        ("hydrostatic_pad", {"load": "80 kN"}, "recess", 1),
        ("hydrostatic_thrust_ring", {"load": "800 kN"}, "recess", 4),
        ("jacking_pocket", {"lift_gap": None, "pump_flow": "0.000001 L/min"}, "film", 1),
    ],
)
def test_what_finds_no_film_is_drawn_without_one(kind, changes, geometry, count):
    solution, picture = one(changed(kind, **changes))
    assert not solution.result.outcome.solved
    assert len([shape for shape in picture.shapes if shape.style == geometry]) == count
    assert not picture.of("shade")
    assert not picture.of("pressure")


def test_a_heel_without_steady_state_is_drawn_without_flows():
    films = {"face_gap": "12 um", "clearance": {"kind": "radial", "mean": "10 um"}}
    solution, picture = one(changed("screw_heel", method="superposition", wall=None, variants="grooved", **films))
    assert not solution.result.outcome.solved
    assert picture.of("groove")
    assert not picture.of("flow line")


@pytest.mark.parametrize("method", ["iso7902", "film"])
def test_the_clearance_of_a_journal_bearing_is_drawn_by_the_factor_shown(method):
    """Bore less journal over the radius is the relative clearance at work times the factor."""
    changes = {} if method == "iso7902" else {"method": {"kind": "film"}, "supply_element": None}
    solution, picture = one(changed("journal", **changes))
    bore = np.hypot(*picture.of("bore")[0].points.T).max()
    clearance = (bore - picture.of("journal", "circle")[0].size) / picture.factor("film")
    assert clearance == pytest.approx(solution.result.values["operating_relative_clearance"], rel=5e-3)


def test_films_of_tilting_pads_are_drawn_by_the_factor_shown():
    """The journal stands off the middle by its eccentricity times the factor."""
    solution, picture = one(changed("tilting_pad_journal"))
    moved = math.hypot(*picture.of("journal", "circle")[0].points[0]) / picture.factor("film")
    off = float(np.hypot(*solution.state.films.solution.position))
    assert moved * solution.state.films.solution.bearing.radius == pytest.approx(off, rel=5e-3)


@pytest.mark.parametrize(("direction", "is_below"), [("-90 deg", False), ("135 deg", True)])
def test_sizes_make_room_for_the_highest_pressure(direction, is_below):
    """They stand at the upper left, or below where the film presses there and says how hard."""
    changes = {"method": {"kind": "film"}, "supply_element": None, "load_angle": direction}
    _, picture = one(changed("journal", **changes))
    (diameter,) = (one for one in picture.shapes if one.tag == "text" and one.words.startswith("D ="))
    (pressed,) = (one for one in picture.shapes if one.tag == "text" and "MPa" in one.words)
    assert bool(diameter.points[0][1] < 0.0) is is_below
    assert bool(pressed.points[0][1] > 0.0) is is_below

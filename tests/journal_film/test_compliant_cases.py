"""Bores that give way, from the case to the result."""

import math

import numpy as np
import pytest
from film_bearings import answer, case, film, solved

from babbitt.case import CaseError, load_case
from babbitt.kinds.journal.film import isothermal as warm_film
from babbitt.kinds.journal.film.elastic_film import displacement_under, elastic_film
from babbitt.kinds.journal.film.field import journal_gap
from babbitt.kinds.journal.film.isothermal import operating_film
from babbitt.kinds.journal.film.stable_equilibrium import converged_film
from babbitt.numerics.anderson import AndersonOptions
from babbitt.reynolds.deformation.compliance import ColumnLiner
from babbitt.reynolds.deformation.compliance_matrix import ComplianceMatrix
from babbitt.reynolds.deformation.elastic_ring import ElasticRing, RingSupport
from babbitt.reynolds.deformation.half_space import HalfSpace
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.model import JournalFilm, Resolution, grooved_bore

AT = {"effective_temperature": "55 degC", "load": "60 kN", "accuracy": "draft"}
RING = {"kind": "ring", "outer_diameter": "280 mm", "elastic_modulus": "110 GPa", "poisson_ratio": 0.26}
MATRIX = "angle [deg],loaded [deg],compliance [um/MPa]"


def test_every_kind_is_read():
    given = [
        {"kind": "column", "thickness": "2 mm", "elastic_modulus": "50 GPa", "poisson_ratio": 0.35},
        {"kind": "column", "displacement_per_pressure": "0.5 um/MPa"},
        RING | {"support": "clamped"},
        {"kind": "half_space", "elastic_modulus": "110 GPa"},
    ]
    assert film(compliance=given).bearing.compliance == (
        ColumnLiner.of_layer(2e-3, 5e10, 0.35),
        ColumnLiner(5e-13),
        ElasticRing(0.1, 0.14, 1.1e11, 0.26, RingSupport.CLAMPED),
        HalfSpace(1.1e11, 0.3),
    )


def matrix_lines() -> list[str]:
    angles = range(0, 360, 30)
    return [f"{one},{other},{0.4 if one == other else 0.01}" for one in angles for other in angles]


def named(folder, name: str):
    text = folder / "case.yaml"
    text.write_text(
        "kind: journal\nname: Bearing\nmethod: film\ndiameter: 200 mm\nwidth: 120 mm\n"
        "clearance: {kind: relative, mean: 1.5 permille}\nmaterials: {bearing: C10, journal: C45}\n"
        "lubricant: ISO VG 46\nsupply: {temperature: 45 degC, pressure: 0.15 MPa}\nload: 30 kN\nspeed: 3000 rpm\n"
        "grooves: [{angle: 0 deg, extent: 20 deg}, {angle: 180 deg, extent: 20 deg}]\n"
        f"compliance: [{{kind: file, file: {name}}}]\n",
        encoding="utf-8",
    )
    return load_case(text)


def test_matrices_are_read_from_csv_and_npz(tmp_path):
    (tmp_path / "one.csv").write_text("\n".join([MATRIX, *reversed(matrix_lines())]), encoding="utf-8")
    values = np.full((12, 12), 1e-14) + np.eye(12) * 3.9e-13
    np.savez(tmp_path / "one.npz", angles=np.radians(np.arange(0, 360, 30)), compliance=values)
    (csv,), (npz,) = (
        tuple(part.compliance(0.2) for part in named(tmp_path, name).compliance) for name in ("one.csv", "one.npz")
    )
    assert isinstance(csv, ComplianceMatrix)
    assert np.array(csv.compliance) == pytest.approx(values, rel=1e-12)
    assert np.array(npz.compliance) == pytest.approx(values, rel=1e-12)
    assert csv.angles == pytest.approx(npz.angles)
    assert csv.angles[1] == pytest.approx(math.radians(30.0))


@pytest.mark.parametrize(
    ("lines", "says"),
    [
        (matrix_lines()[:-1], "143 values for 12 angles"),
        ([*matrix_lines(), "0,0,1"], "repeats a pair"),
        (["0,0,soft"], "line 2"),
    ],
)
def test_unusable_matrices_are_told(tmp_path, lines, says):
    (tmp_path / "one.csv").write_text("\n".join([MATRIX, *lines]), encoding="utf-8")
    with pytest.raises(CaseError, match=says):
        named(tmp_path, "one.csv")


def test_unusable_arrays_are_told(tmp_path):
    np.savez(tmp_path / "lacks.npz", angles=np.arange(3.0))
    np.savez(tmp_path / "shape.npz", angles=np.arange(3.0), compliance=np.eye(4))
    np.savez(tmp_path / "objects.npz", angles=np.array([{}, {}, {}], dtype=object), compliance=np.eye(3))
    (tmp_path / "broken.npz").write_bytes(b"no archive")
    for name, says in (("lacks", "lacks an array"), ("shape", "shape"), ("objects", "cannot be read"),
                       ("broken", "cannot be read")):  # fmt: skip
        with pytest.raises(CaseError, match=says):
            named(tmp_path, f"{name}.npz")


def test_elastic_bearing_tells_its_displacement_and_what_it_assumes():
    rigid, soft = answer(**AT), answer(**AT, compliance=[RING])
    assert "maximum_displacement" not in rigid.values
    state = operating_film(film(**AT, compliance=[RING])).film
    displaced = displacement_under(film(compliance=[RING]).bearing.compliance, state.solution)
    assert soft.maximum_displacement == pytest.approx(np.abs(displaced).max())
    assert soft.maximum_displacement > 5e-6
    assert soft.maximum_pressure < rigid.maximum_pressure
    assert any("Elastic ring up to 280 mm" in said for said in soft.assumptions)
    assert any("rigid surfaces" in said for said in rigid.assumptions)
    assert not any("rigid surfaces" in said for said in soft.assumptions)


@pytest.mark.thorough
def test_heat_balance_of_an_elastic_bearing_closes():
    found = answer(load="60 kN", accuracy="draft", compliance=[RING])
    assert abs(found.energy_balance_error) < 1e-6
    assert found.mass_balance_error < 1e-8


def test_bearing_too_soft_for_its_load_says_so(monkeypatch):
    few = AndersonOptions(most_evaluations=8)
    monkeypatch.setattr("babbitt.kinds.journal.film.elastic_film.SETTLING", few)
    (found,) = solved(**AT, compliance=[RING | {"outer_diameter": "206 mm"}]).results
    assert not found.outcome.solved
    assert "too soft" in found.message


def test_changing_load_does_not_count_a_soft_bore():
    load = {"kind": "rotating", "magnitude": "1 kN", "moving_mass": "100 kg"}
    with pytest.raises(CaseError, match="gives way"):
        case(dynamic_load=load, compliance=[RING])


def test_columns_open_the_middle_and_pinch_the_sides_of_a_short_bearing():
    """A film of infinite length on columns gains gap at equal load; the least gap of a real one moves outwards.

    100 mm by 70 mm, relative clearance 1.53 permille, 1910 rpm, 6.5 MPa, as in a published study of grooves.
    """
    bearing = JournalFilm(0.1, 0.07, 76.5e-6, 0.03, 200.0, grooved_bore((math.pi / 2,), 0.06))
    theta = np.linspace(0.0, 2.0 * math.pi, 720, endpoint=False)
    middle, least, zone = [], [], []
    for compliance in (0.0, 1e-13, 1e-12):
        found = elastic_film(
            bearing, [ColumnLiner(compliance)], lambda one: solve_journal(one, (0.0, -45.5e3), Resolution(4, 48))
        )
        assert found.outcome.solved
        gap = journal_gap(found.solution, theta, np.array([0.0]))[:, 0]
        middle.append(gap.min())
        least.append(found.solution.minimum_film_thickness)
        zone.append((gap < 1.1 * gap.min()).mean())
    assert middle[0] < middle[1] < middle[2]
    assert least[0] > least[1] > least[2]
    assert zone[2] > 1.2 * zone[0]
    assert least[2] < 0.55 * middle[2]


def test_a_bore_that_gives_way_beside_a_groove_is_solved_from_film_to_film(monkeypatch):
    """A load just before a groove: every film was sought in all the clearance, 50 of them for one temperature."""
    searches = []

    def counted(*given):
        searches.append(given)
        return converged_film(*given)

    monkeypatch.setattr(warm_film, "converged_film", counted)
    bearing = film(
        diameter="374.43 mm", width="180.62 mm", clearance={"kind": "relative", "mean": "1.49 permille"},
        lubricant="ISO VG 68", supply={"temperature": "51.2 degC", "pressure": "0.097 MPa"}, load="138.63 kN",
        speed="732.68 rpm", accuracy="draft", load_angle="-86.16 deg", effective_temperature="53.2 degC",
        grooves=[{"angle": "-71.01 deg", "extent": "27.62 deg"}],
        compliance=[{"kind": "half_space", "elastic_modulus": "200 GPa", "poisson_ratio": 0.3}],
    )  # fmt: skip
    assert operating_film(bearing).outcome.solved
    assert 1 <= len(searches) <= 10


@pytest.mark.parametrize("turned", [0.0, 135.5])
def test_a_soft_ring_is_sought_from_the_bore_that_is_known_too(turned):
    """Neither what films before taught nor the round bore lead to its film at 74 °C in a turned frame (S001)."""
    found = answer(
        diameter="101.18 mm", width="85.645 mm", clearance={"kind": "relative", "mean": "2.756 permille"},
        lubricant="ISO VG 100", supply={"temperature": "42.5 degC", "pressure": "0.184 MPa"}, load="9.0248 kN",
        speed="5736.8 rpm", load_angle=f"{-151.34 + turned} deg", limiting_speeds=False, accuracy="draft",
        grooves=[{"angle": f"{-124.25 + turned} deg", "extent": "14.16 deg"}],
        compliance=[RING | {"outer_diameter": "121.87 mm", "elastic_modulus": "200 GPa", "poisson_ratio": 0.3}],
        materials={"bearing_metal": "SnSb8Cu4", "bearing": "C10", "journal": "C45"},
    )  # fmt: skip
    assert found.minimum_film_thickness == pytest.approx(8.8239e-6, rel=1e-4)

"""Every limit of a kind is a check or is listed as not made; every outcome of an inner solve is read."""

import ast
from pathlib import Path

import pytest
import yaml

import babbitt
from babbitt.case import CaseError, case_from_dict, kinds, template
from babbitt.core.result import Verdict
from babbitt.solving import solve

JOURNAL = {"C101", "C102", "C103", "C104", "C105", "C106", "C107", "C108", "C111"}
LIMITS = {
    "hydrostatic_journal": {"C301", "C302", "C303", "C305"},
    "hydrostatic_pad": {"C301", "C302", "C303", "C305"},
    "hydrostatic_thrust_ring": {"C301", "C302", "C303", "C305"},
    "jacking_pocket": {"C304"},
    "overhung_coupling": set(),
    "shaft": {"C501", "C502", "C503"},
    "screw_heel": {"C130", "C131"},
    "thrust": {"C103", "C104", "C105", "C106", "C107", "C108", "C202"},
    "tilting_pad_journal": JOURNAL | {"C401", "C402"},
    "thrust_line": {"C103", "C104", "C105", "C106", "C107", "C108", "C201", "C202", "C203", "C204", "C205"},
}
"""Limits of the kinds besides journal bearings; a coupling's statics tell loads, and hold them against nothing."""
METHODS = {
    **{kind: ("film", "quick") for kind in LIMITS if kind.startswith("hydrostatic") or kind == "jacking_pocket"},
    "overhung_coupling": ("statics",),
    "shaft": ("beam", "statics"),
    "screw_heel": ("superposition", "narrow_groove", "narrow_groove to metal"),
    "thrust": ("heat_balance", "adiabatic", "temperature", "viscosity"),
    "thrust_line": ("heat_balance", "viscosity"),
    "tilting_pad_journal": ("global", "isothermal", "adiabatic", "full"),
}
"""Ways of computing a kind: methods, or oils of thrust bearings."""
BALANCES = {("tilting_pad_journal", method): {"C403"} for method in ("adiabatic", "full")}
"""Of kinds and ways of computing them."""
OILS = {
    "temperature": {"kind": "temperature", "temperature": "53 degC"},
    "viscosity": {"kind": "viscosity", "viscosity": "45 mPa s"},
}
OPTIONAL = ("limits", "materials", "surfaces", "relief_pressure", "supply_limit", "rotor_mass")
"""Blocks and fields without which a limit has nothing to hold."""

LEFT_OUT = ({}, {"surfaces"}, {"materials"}, {"limits"}, {"surfaces", "materials", "limits"})


def codes(result):
    """Of checks, and of those that could not be made."""
    return {one.code for one in (*result.checks, *result.not_checked)}


JOURNALS = {
    "iso7902": {"span": "360 deg", "supply_element": {"kind": "hole", "diameter": "5 mm", "place": "opposite"}},
    "film": {"grooves": [{"angle": "0 deg", "extent": "20 deg"}]},
    "adiabatic film": {"grooves": [{"angle": "0 deg", "extent": "20 deg"}], "thermal": "adiabatic"},
    "long_film": {
        "width": "130 mm",
        "heat_exchange": {
            "bush": {"outer_diameter": "130 mm", "conductivity": "45 W/(m K)"},
            "ambient": {"temperature": "20 degC", "coefficient": "50 W/(m2 K)"},
        },
    },
    "segments": {"segments": {"groove": {"kind": "through", "angle_from_load": "-20 deg", "width": "5 mm"}}},
}
JOURNAL_FIELDS = {
    "kind": "journal",
    "name": "Bearing",
    "diameter": "100 mm",
    "width": "60 mm",
    "clearance": {"kind": "relative", "mean": "1.2 permille"},
    "materials": {"bearing": "C10", "journal": "C45", "bearing_metal": "SnSb12Cu6Pb"},
    "lubricant": "ISO VG 46",
    "supply": {"temperature": "50 degC", "pressure": "0.1 MPa"},
    "surfaces": {"kind": "direct", "roughness_bearing": "4 um", "roughness_journal": "2 um"},
    "limits": {"minimum_film_thickness": "9 um"},
    "load": "15 kN",
    "speed": "3000 rpm",
}


def journal_fields(method):
    """Fields of a journal bearing by a method."""
    return JOURNAL_FIELDS | {"method": method.split()[-1]} | JOURNALS[method]


@pytest.mark.parametrize("without", LEFT_OUT, ids=lambda one: "+".join(sorted(one)) or "all")
@pytest.mark.parametrize("method", JOURNALS)
def test_every_limit_of_a_journal_bearing_is_held_or_listed(method, without):
    given = {name: value for name, value in journal_fields(method).items() if name not in without}
    if "materials" in without:
        given["materials"] = {"bearing": "C10", "journal": "C45"}
    (result,) = solve(case_from_dict(given)).results
    assert codes(result) >= JOURNAL


WAYS = [(kind, one) for kind, ways in METHODS.items() for one in ways]


def template_of(kind, method):
    """Fields of the template, by a way of computing the kind."""
    given = yaml.safe_load(template(kind))
    if kind == "screw_heel":
        given["method"] = method.split()[0]
        if "metal" not in method:
            del given["wall"]
    elif kind == "overhung_coupling":
        assert "method" not in given
    elif kind == "shaft":
        given["bearings"][1] = {"kind": "radial", "name": "B", "station": "320 mm"}
        if method == "statics":
            del given["shaft"]
    elif kind == "tilting_pad_journal":
        given["method"] = {"kind": "film", "thermal": method, "accuracy": "draft"}
    elif not kind.startswith("thrust"):
        given["method"] = method
    elif method == "adiabatic":
        given["thermal"] = method
        given["pads"]["number"], given["load"] = 2, "125 kN"  # a quarter of the bearing takes less time
    else:
        given["oil"] = OILS.get(method, {"kind": "heat_balance"})
    return given


@pytest.mark.parametrize(("kind", "method"), WAYS)
@pytest.mark.parametrize("without", ["nothing", "all that may be left out"])
def test_every_limit_of_another_kind_is_held_or_listed(kind, method, without):
    given = template_of(kind, method)
    if without != "nothing":
        given = {name: value for name, value in given.items() if name not in OPTIONAL}
    for result in solve(case_from_dict(given)).results:
        assert codes(result) >= LIMITS[kind] | BALANCES.get((kind, method), set())


LOOSE = {
    "minimum_film_thickness": ("1.01 um", 1.01e-6),
    "specific_load": ("101 MPa", 101e6),
    "temperature": ("191 degC", 464.15),
    "transition_film_thickness": ("1.02 um", 1.02e-6),
    "log_decrement": ("0.001", 0.001),
    "probe_alarm": ("192 degC", 465.15),
    "probe_trip": ("193 degC", 466.15),
    "slope": ("11 mrad", 0.011),
    "deflection": ("12 mm", 0.012),
    "axial_amplitude": ("9 mm", 0.009),
}
"""Limits that a case may set, as they are written and in SI, so wide that every bearing keeps them."""


CODES = {
    "minimum_film_thickness": {"C101", "C202"},
    "specific_load": {"C103"},
    "temperature": {"C104", "C108"},
    "transition_film_thickness": {"C111"},
    "log_decrement": {"C401"},
    "probe_alarm": {"C404"},
    "probe_trip": {"C405"},
    "slope": {"C501"},
    "deflection": {"C502"},
    "axial_amplitude": {"C205"},
}
"""Checks of these limits."""


def unheld(given, limit):
    """Results of a case that hold nothing against a limit which it sets, and pass or do not list the check.

    None of a case that is refused.
    """
    written, value = LOOSE[limit]
    try:
        case = case_from_dict(given | {"limits": {limit: written}})
    except CaseError:
        return []
    return [
        one
        for one in solve(case).results
        if not any(check.limit == pytest.approx(value) for check in one.limits)
        and (one.within_limits or not CODES[limit] & {notice.code for notice in one.not_checked})
        # C111 holds the speed at which the film has that thickness
        if not (limit == "transition_film_thickness" and any(check.code == "C111" for check in one.limits))
    ]


SHORT_WAYS = [(kind, one) for kind, one in WAYS if one != "film"]
"""All but recesses by films, whose limits are those of the quick method."""


@pytest.mark.parametrize("limit", LOOSE)
@pytest.mark.parametrize(("kind", "method"), SHORT_WAYS)
def test_no_limit_that_a_case_sets_unheld(kind, method, limit):
    given = template_of(kind, method)
    assert unheld(given, limit) == []
    if given.pop("rotor_mass", None) is not None:
        assert unheld(given, limit) == []


@pytest.mark.parametrize("limit", LOOSE)
@pytest.mark.parametrize("method", JOURNALS)
def test_no_limit_of_a_journal_bearing_unheld(method, limit):
    assert unheld(journal_fields(method), limit) == []


def test_every_kind_is_asked():
    assert {"journal", "machine"} | set(LIMITS) == set(kinds())


def test_a_kind_that_is_held_against_nothing_has_no_verdict():
    """Loads of a shaft pass no bearing."""
    (result,) = solve(case_from_dict(yaml.safe_load(template("overhung_coupling")))).results
    assert result.checks == ()
    assert result.verdict is Verdict.NO_VERDICT


SOLVERS = {
    "solve_journal", "film_at_position", "converged_film", "solve_thermal_journal",
    "thermal_film_at", "elastic_film", "elastic_thermal_film", "feed_film", "closed_film", "tilt_coefficients",
    "operating_film", "thermal_operating_film", "film_within_ducts", "solve_sector", "find_equilibrium",
    "solve_tilting_pads", "tilting_pads_at", "fold_of", "operating_films",
    "find_thermal_tilting_pads", "thermal_tilting_pads_at", "thermal_films", "coarser", "find_root",
}  # fmt: skip
"""What returns an outcome that a caller must read, or hand on."""
OUTCOMES = {"outcome", "solved", "status", "converged"}
SOLUTIONS = {"film", "solution", "thermal", "network"}
"""Attributes that hold an outcome of their own."""
KEEPS = (
    ast.Tuple, ast.List, ast.ListComp, ast.GeneratorExp, ast.Starred, ast.IfExp, ast.BoolOp, ast.NamedExpr,
    ast.Dict, ast.DictComp, ast.Subscript,
)  # fmt: skip
"""Expressions that hold a solution, or are one."""
HANDS_ON = (ast.Return, ast.Yield, ast.YieldFrom, ast.Lambda, ast.Call, ast.keyword, ast.Expr)
"""What takes a solution whole, or nothing of it."""


def functions():
    """Functions of the package, with the file they stand in."""
    for path in sorted(Path(babbitt.__file__).parent.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.FunctionDef):
                yield path, node


def silent_calls(function):
    """Calls of solvers whose outcome a function neither reads nor hands on."""
    for call in ast.walk(function):
        name = getattr(call.func, "id", getattr(call.func, "attr", "")) if isinstance(call, ast.Call) else ""
        if name in SOLVERS and not reads_or_hands_on(function, call):
            yield call


def reads_or_hands_on(function, call):
    """Whether a function reads the outcome of this call, or hands on the solution with it.

    Followed are the names that the solution gets. A part of it that is no solution hands nothing on.
    """
    above = {part: whole for whole in ast.walk(function) for part in ast.iter_child_nodes(whole)}
    names, seen, open_ends = set(), set(), [call]
    while open_ends:
        part = open_ends.pop()
        whole = above[part]
        while (isinstance(whole, KEEPS) and part is not getattr(whole, "test", None)) or (
            isinstance(whole, ast.Attribute) and whole.attr in SOLUTIONS
        ):
            part, whole = whole, above[whole]
        if isinstance(whole, HANDS_ON) or (isinstance(whole, ast.Attribute) and whole.attr in OUTCOMES):
            return True
        targets = getattr(whole, "targets", [getattr(whole, "target", None)])
        names |= {one.id for target in targets if target for one in ast.walk(target) if isinstance(one, ast.Name)}
        if any(isinstance(target, ast.Attribute) for target in targets):
            return True
        loaded = {one for one in ast.walk(function) if isinstance(one, ast.Name) and isinstance(one.ctx, ast.Load)}
        if any(one.id in names & OUTCOMES for one in loaded):
            return True
        new = {one for one in loaded if one.id in names} - seen
        seen |= new
        open_ends.extend(new)
    return False


@pytest.mark.parametrize("body", [
    "found = film_at_position(a, b)\n    g(found.force)",
    "found = film_at_position(a, b)\n    return found.force[0]",
    "found = film_at_position(a, b)\n    return 2.0 * found.force",
    "return film_at_position(a, b).force * 2.0",
    "return position.film_at_position(a, b).force",
    "x = film_at_position(a, b)\n    y = film_at_position(b, a)\n    return y.force if x.outcome.solved else None",
    "status = 3\n    x = film_at_position(a, b)\n    g(status, x.force)",
    "return find_root(a, b).value",
    "found = film_at_position(a, b)\n    return found.force if found else 0.0",
])  # fmt: skip
def test_an_outcome_that_is_not_read_is_seen(body):
    (function,) = ast.parse(f"def f(a, b):\n    {body}\n").body
    (call,) = silent_calls(function)
    assert "a, b" in body
    assert call.lineno == (3 if "y =" in body or "status =" in body else 2)


@pytest.mark.parametrize("body", [
    "return film_at_position(a, b)",
    "return a, film_at_position(a, b)",
    "return State(film_at_position(a, b).film)",
    "found = film_at_position(a, b)\n    return found if found.outcome.solved else None",
    "found = [film_at_position(a, one) for one in b]\n    return all(one.outcome.solved for one in found)",
    "root = find_root(a, b)\n    return root.value if root.converged else None",
    "x, y, status, gap = find_equilibrium(a, b)\n    return x if status == 0 else None",
    "first, *rest = film_at_position(a, b), b\n    return State(first, rest)",
])  # fmt: skip
def test_an_outcome_that_is_read_or_handed_on_is_not_questioned(body):
    (function,) = ast.parse(f"def f(a, b):\n    {body}\n").body
    assert list(silent_calls(function)) == []


def test_every_outcome_of_an_inner_solve_is_read():
    silent = [
        f"{path.name}: {function.name}, line {call.lineno}"
        for path, function in functions()
        for call in silent_calls(function)
    ]
    assert silent == []

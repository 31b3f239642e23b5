"""`babbitt upgrade` writes files as they are written today: they say the same, and comments and order stay."""

import re
from pathlib import Path

import pytest
import yaml

from babbitt.case import KINDS, CaseError, case_from_dict, case_hash, load_case, parse_case, template
from babbitt.case.method_mapping import choices_of, method_models
from babbitt.case.nested import with_value
from babbitt.case.upgrade import former_places, upgraded
from babbitt.cli import main

FORMER = Path(__file__).parent / "former"
FILES = sorted(FORMER.glob("*.yaml"))


def comments(text):
    """Every comment, wherever it stands; no text of these files has a # that begins none."""
    return sorted(re.findall(r"(?<!\S)#.*", text))


def upgrade_of(text, folder):
    file = folder / "case.yaml"
    file.write_text(text, encoding="utf-8", newline="")
    return upgraded(file).text


def old_forms():
    """Every template with every choice of each of its methods at its former place, as a file and as JSON."""
    for kind, model in KINDS.items():
        for method in method_models(model):
            for name, path in choices_of(model, method).items():
                yield pytest.param(kind, method, name, path, id=f"{kind}-{method}-{name}")


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_a_file_of_before_says_the_same_as_it_is_written_today(file, tmp_path):
    old, made = load_case(file), upgraded(file)
    new = parse_case(made.text)
    assert made.moved
    assert former_places(old) == made.moved
    assert not former_places(new)
    assert case_hash(new) == case_hash(old)
    assert repr(new.calculations()) == repr(old.calculations())
    assert comments(made.text) == comments(old.text)
    again = tmp_path / "again.yaml"
    again.write_text(made.text, encoding="utf-8")
    assert upgraded(again).text == made.text


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_lines_that_are_not_moved_keep_every_letter_and_their_order(file):
    old, made = file.read_text(encoding="utf-8").splitlines(), upgraded(file)
    taken = {place.line - 1 for place in made.moved} | {
        i for i, line in enumerate(old) if line.startswith("method:")
    }
    new = iter(made.text.splitlines())
    assert all(line in new for number, line in enumerate(old) if number not in taken)


@pytest.mark.parametrize("file", [*FILES], ids=lambda file: file.stem)
def test_examples_and_templates_are_what_upgrade_makes_of_those_of_before(file, request):
    example = request.config.rootpath / "examples" / file.name
    new = example.read_text(encoding="utf-8") if example.exists() else template(file.stem)
    if file.stem == "journal":
        new = template("journal").replace("journal: d8", "journal: e7")  # its fit is a wider one today
    assert case_hash(parse_case(new)) == case_hash(load_case(file))
    assert not former_places(parse_case(new))


def test_no_template_and_no_example_is_of_before(request):
    for file in (request.config.rootpath / "examples").glob("*.yaml"):
        assert not former_places(load_case(file)), file
    for kind in KINDS:
        assert not former_places(parse_case(template(kind))), kind


VALUES = {
    "thermal": "adiabatic", "axial_temperature": "mean", "carry_over": "80 %",
    "temperature_coefficients": "frozen", "cavitation": "reynolds", "film_start": "groove", "turbulence": "ng_pan",
    "accuracy": "draft",
    "error_estimate": True, "limiting_speeds": False, "equilibria": "all", "tilt_coefficients": True,
    "characteristics": "closed_form",
    "nusselt": {"coefficient": 7.5, "exponent": 0}, "discretisation": "published_mean", "exchange_zone": "film",
    "friction_viscosity": "mixed", "face_outlet": "printed", "backflow_viscosity": "groove",
    "local_loss_coefficient": 1, "speed_reduction": 0.5, "radial_temperature": "mean",
    "deformation": ["bending"], "pad_bending": "plate", "assumption_sensitivity": True,
}  # fmt: skip


@pytest.mark.parametrize("flow", [False, True], ids=["block", "braces"])
@pytest.mark.parametrize(("kind", "method", "name", "path"), list(old_forms()))
def test_every_choice_moves(kind, method, name, path, flow, tmp_path):
    given = yaml.safe_load(template(kind))
    if kind == "screw_heel":
        given.pop("wall")
    if method == "long_film":
        given |= {"width": "240 mm", "span": "360 deg"}
        given.pop("friction")
        given.pop("supply_element")
    given.pop("method", None)
    if name in ("axial_temperature", "carry_over", "temperature_coefficients", "radial_temperature"):
        given["thermal"] = "adiabatic"
    if name in ("deformation", "pad_bending", "assumption_sensitivity"):
        given |= {"thermal": "full", "walls": {"pads": {}}, "materials": {"pads": "C45"}}
    if name == "pad_bending":
        given["deformation"] = ["bending"]
    given = with_value({**given, "method": method}, path, VALUES[name])
    old = yaml.safe_dump(given, sort_keys=False, default_flow_style=flow)
    made = upgrade_of(old, tmp_path)
    assert yaml.safe_load(made)["method"][name] == VALUES[name]
    assert parse_case(made) == parse_case(old)
    assert not former_places(parse_case(made))
    assert upgrade_of(made, tmp_path) == made


JOURNAL = """\
kind: journal
name: B
{first}diameter: 100 mm
width: 50 mm
clearance: H7/e7
span: 360 deg
lubricant: ISO VG 46
supply: {{temperature: 50 degC, pressure: 0.2 MPa}}
materials: {{bearing_metal: SnSb8Cu4, bearing: C10, journal: C45}}
load: 5 kN
speed: 1500 rpm
{last}"""


@pytest.mark.parametrize(
    ("first", "last", "says"),
    [
        (
            "method: film   # in two dimensions\n               # of one temperature\n",
            "# Why draft:\naccuracy: draft      # quick\n\n# Heading ------\n# thermal: full\n"
            "cavitation: reynolds",
            "method:\n  kind: film   # in two dimensions\n               # of one temperature\n"
            "  # Why draft:\n  accuracy: draft    # quick\n  cavitation: reynolds\n",
        ),
        (
            "characteristics: closed_form   # of the standard\n",
            "",
            "method:\n  kind: iso7902\n  characteristics: closed_form   # of the standard\n",
        ),
        ("method: {kind: film}\n", "accuracy: draft   # quick\n", "method: {kind: film, accuracy: draft}\n"),
        (
            "method:\n  kind: film\n  # cavitation: reynolds\n",
            "accuracy: draft\n",
            "method:\n  kind: film\n  accuracy: draft\n  # cavitation: reynolds\n",
        ),
        (
            "method: {kind: film, accuracy: draft}\n",
            "accuracy: draft\n",
            "method: {kind: film, accuracy: draft}\n",
        ),
    ],
)
def test_comments_go_with_what_they_are_of(first, last, says, tmp_path):
    old = JOURNAL.format(first=first, last=last)
    made = upgrade_of(old, tmp_path)
    assert says in made
    assert comments(made) == comments(old)
    assert parse_case(made) == parse_case(old)
    assert upgrade_of(old.replace("\n", "\r\n"), tmp_path) == made.replace("\n", "\r\n")


def test_json_stays_json(tmp_path):
    import json

    given = yaml.safe_load(JOURNAL.format(first="method: film\n", last="accuracy: draft\nthermal: adiabatic\n"))
    for indent in (None, 2):
        made = json.loads(upgrade_of(json.dumps(given, indent=indent), tmp_path))
        assert made["method"] == {"kind": "film", "accuracy": "draft", "thermal": "adiabatic"}
        assert case_from_dict(made) == case_from_dict(given)


MACHINE = """\
kind: machine
name: M
lubricant: ISO VG 46
supply: {temperature: 50 degC, pressure: 0.2 MPa}
materials: {bearing_metal: B83, bearing: C10, journal: 42CrMo4}
bearings:
  - &first
    accuracy: draft   # of the grid
    name: A
    kind: journal
    method: film
    diameter: 100 mm
    width: 200 mm
    clearance: H7/e7
    span: 180 deg
    load: 5 kN
    speed: 1500 rpm
  - <<: *first
    name: B
  - characteristics: computed
    # of the second stage
    name: C
    kind: journal
    diameter: 100 mm
    width: 50 mm
    clearance: H7/e7
    span: 180 deg
    load: 5 kN
    speed: 1500 rpm
  - <<: *first
    name: D
    span: 360 deg
    method: long_film
    accuracy: engineering
    heat_exchange:   # of the bush
      nusselt:   # a constant
        coefficient: 7.5
        exponent: 0
"""


def test_anchors_and_lists_of_bearings(tmp_path):
    made = upgrade_of(MACHINE, tmp_path)
    assert parse_case(made) == parse_case(MACHINE)
    assert comments(made) == comments(MACHINE)
    assert "  - method:\n      kind: iso7902\n      characteristics: computed\n    # of the second stage\n" in made
    assert "      nusselt:   # a constant\n        coefficient: 7.5\n" in made
    assert "    # of the bush\n" in made


def test_what_cannot_be_moved_is_told_with_its_line(tmp_path):
    joined = MACHINE.replace("    name: A\n", "    name: A\n    thermal: adiabatic\n")
    joined = joined.replace("    name: B\n", "    name: B\n    accuracy: reference\n")
    with pytest.raises(CaseError, match="by hand"):  # a mapping of its own would lose what it has by the anchor
        upgrade_of(joined.partition("  - <<: *first\n    name: D")[0], tmp_path)
    aliased = JOURNAL.format(first="notes: &grid draft\nmethod: film\n", last="accuracy: *grid\n")
    with pytest.raises(CaseError, match=r":14: accuracy: it comes from an anchor"):
        upgrade_of(aliased, tmp_path)


def test_former_words_move_too(tmp_path):
    old = template("hydrostatic_journal").replace("clearance: {kind: radial, mean:", "radial_clearance: {mean:")
    old = re.sub(r"radial_clearance: \{mean: ([^}]*)\}", r"radial_clearance: \1", old)
    old = re.sub(r"limits: \{minimum_film_thickness: ([^}]*)\}", r"least_gap: \1", old)
    made = upgrade_of(old, tmp_path)
    assert made != old
    assert parse_case(made) == parse_case(template("hydrostatic_journal"))
    heel = template("screw_heel").replace("  diameter: 43.6 mm", "  radius: 21.8 mm   # r1")
    assert "  diameter: 43.6 mm   # r1\n" in upgrade_of(heel, tmp_path)
    thrust = template("thrust").replace("load: 500 kN", "thrust: 500 kN").replace("lubricant: ISO VG 100\n", "")
    thrust = thrust.replace("supply: {temperature: 45 degC}      # of the fresh oil\n", "")
    thrust = thrust.replace(
        "oil: {kind: heat_balance,",
        "oil: {lubricant: ISO VG 100, supply_temperature: 45 degC, kind: heat_balance,",
    )
    assert parse_case(upgrade_of(thrust, tmp_path)) == parse_case(template("thrust"))


def run(monkeypatch, capsys, *words):
    monkeypatch.setattr("sys.argv", ["babbitt", *map(str, words)])
    with pytest.raises(SystemExit) as ended:
        main()
    told = capsys.readouterr()
    return ended.value.code, told.out, told.err


def test_the_command_writes_a_new_file_and_tells_what_it_moved(monkeypatch, capsys, tmp_path):
    old, new = FORMER / "turbulent_turbine_heat.yaml", tmp_path / "new.yaml"
    status, out, err = run(monkeypatch, capsys, "upgrade", old, "-o", new)
    assert (status, out) == (0, "")
    assert "line 6: thermal stands in method.thermal now" in err
    assert new.read_text(encoding="utf-8") == upgraded(old).text
    for words in ((), ("-o", "-")):
        assert run(monkeypatch, capsys, "upgrade", old, *words)[:2] == (0, new.read_text(encoding="utf-8"))
    status, _, err = run(monkeypatch, capsys, "upgrade", old, "-o", new)
    assert status == 2
    assert "exists" in err


def test_a_file_of_today_is_left_as_it_is(monkeypatch, capsys, tmp_path):
    file = tmp_path / "new.yaml"
    file.write_text(template("journal"), encoding="utf-8")
    status, out, err = run(monkeypatch, capsys, "upgrade", file)
    assert (status, out) == (0, template("journal"))
    assert "nothing is changed" in err
    status, out, err = run(monkeypatch, capsys, "upgrade", file, "-o", tmp_path / "other.yaml")
    assert (status, out, (tmp_path / "other.yaml").exists()) == (0, "", False)
    assert "nothing is changed" in err


def test_check_names_every_former_place_and_solve_says_that_there_are(monkeypatch, capsys):
    old = FORMER / "turbulent_turbine_heat.yaml"
    _, out, err = run(monkeypatch, capsys, "check", old)
    assert "line 6: thermal stands in method.thermal now" in out
    assert "line 14: turbulence stands in method.turbulence now" in out
    assert err == ""


def test_solve_says_so_in_one_line_on_standard_error(monkeypatch, capsys):
    status, out, err = run(monkeypatch, capsys, "solve", FORMER / "journal.yaml")
    assert status == 0
    assert "stands in" not in out
    assert "characteristics stands in method.characteristics now; `babbitt upgrade" in err
    assert err.count("\n") == 1

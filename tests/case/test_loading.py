"""From files to cases: all problems at once, nothing but `CaseError`, in time."""

import copy
import os
import random
from collections import Counter

import pytest
import yaml

from babbitt.case import (
    CaseError,
    case_from_dict,
    kinds,
    load_case,
    load_cases,
    parse_case,
    part,
    template,
)
from babbitt.case.part import Part
from babbitt.case.problems import MOST_SHOWN
from babbitt.core.units import reading
from babbitt.kinds.journal.case.files import JournalCase, Machine

MACHINE = yaml.safe_load(template("machine"))


def refused(path):
    with pytest.raises(CaseError) as caught:
        load_case(path)
    (problem,) = caught.value.problems
    assert (
        str(problem) == f"{path}{':' * bool(problem.line)}{problem.line or ''}: {problem.message} [{problem.code}]"
    )
    return problem


def test_missing_file(tmp_path):
    problem = refused(tmp_path / "none.yaml")
    assert (problem.code, problem.says) == ("E001", "there is no such file")


def test_folder(tmp_path):
    assert refused(tmp_path).code == "E001"


def test_ten_megabytes(tmp_path):
    path = tmp_path / "huge.yaml"
    path.write_text("kind: journal\n" + "# filler\n" * 1_200_000)
    problem = refused(path)
    assert (problem.code, problem.allowed) == ("E001", "1 MB")


def test_an_endless_file_is_not_read():
    if not os.path.exists("/dev/zero"):
        pytest.skip("no endless file here")
    assert refused("/dev/zero").code == "E001"


@pytest.mark.parametrize(
    "content", [bytes(range(256)), b"\x7fELF\x02\x01\x01\x00", b"kind: journal\x00", b"\x89PNG\r\n"]
)
def test_binary(tmp_path, content):
    path = tmp_path / "binary.yaml"
    path.write_bytes(content)
    assert refused(path).code == "E001"


def test_an_unreadable_file(tmp_path, monkeypatch):
    from pathlib import Path

    path = tmp_path / "locked.yaml"
    path.write_text("kind: journal")

    def denied(*args, **kwargs):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "open", denied)
    assert "permission denied" in refused(path).says


def test_byte_order_mark_and_json(tmp_path):
    import json

    path = tmp_path / "case.json"
    path.write_text("\ufeff" + json.dumps(MACHINE), encoding="utf-8")
    assert load_case(path) == parse_case(template("machine"))


@pytest.mark.parametrize("kind", kinds())
def test_the_text_stays_with_the_case(tmp_path, kind):
    text = template(kind) + "# my own remark: Ø\n"
    path = tmp_path / "case.yaml"
    path.write_text("\ufeff" + text, encoding="utf-8")
    assert load_case(path).text == parse_case(text).text == text
    assert [case.text for case in load_cases([path])] == [text]
    from_dict = case_from_dict(yaml.safe_load(text))
    assert from_dict.text == ""
    assert from_dict == parse_case(text)
    assert hash(from_dict) == hash(parse_case(text))
    assert "text" not in parse_case(text).model_dump()


def test_cases_of_other_content_differ():
    text = template("journal")
    assert parse_case(text) != parse_case(text.replace("12 kN", "13 kN"))
    assert parse_case(text) != "a case"


def test_degree_sign_and_other_scripts():
    text = template("journal").replace("50 degC", "50 °C").replace("Example bearing", "Lager Nr. 1, Ø 120, Опора")
    assert parse_case(text).name == "Lager Nr. 1, Ø 120, Опора"


def test_all_problems_of_a_file_at_once():
    text = """\
kind: machine
name: Many flaws
lubricant: ISO VG 46
supply: {temperature: 50 degC, pressure: 0.2 MPa}
materials: {bearing: C10, journal: C45}
bearings:
  - name: One
    kind: journal
    diameter: 250 kg
    width: 150 mm
    width_ratio: 0.6
    clearance: {kind: limits, bore: [250 mm, 250.1 mm], journal: [250.2 mm, 250.1 mm]}
    span: 180 deg
    load: 40 kN
    speed: 3000 rpm
  - name: Two
    kind: journal
    diamter: 250 mm
    width: 150 mm
    clearance: {kind: fit, bore: H7, journal: d8}
    span: 200 deg
    supply_element: {kind: pocket, width: 150 mm, place: above}
    load: 40 kN
    specific_load: 1 MPa
  - name: One
    kind: journal
    diameter: 250 mm
    width: 150 mm
    clearance: {kind: fit, bore: H7, journal: d8}
    span: 180 deg
    supply: {temperature: 130 degC}
    load: 40 kN
    speed: 3000 rpm
"""
    with pytest.raises(CaseError) as caught:
        parse_case(text, "m.yaml")
    found = [(problem.line, problem.field) for problem in caught.value.problems]
    assert found == [
        (9, "bearings[0 'One'].diameter"),
        (11, "bearings[0 'One'].width_ratio"),
        (12, "bearings[0 'One'].clearance.journal"),
        (16, "bearings[1 'Two']"),
        (18, "bearings[1 'Two'].diamter"),
        (21, "bearings[1 'Two'].span"),
        (22, "bearings[1 'Two'].supply_element.place"),
        (24, "bearings[1 'Two'].specific_load"),
        (25, "bearings[2 'One'].name"),
        (31, "bearings[2 'One'].supply.temperature"),
    ]
    assert str(caught.value).count("\n") == len(found) - 1


def test_problems_of_several_files_stand_file_by_file(tmp_path):
    good, first, second = (tmp_path / f"{name}.yaml" for name in ("good", "first", "second"))
    good.write_text(template("journal"))
    first.write_text(template("journal").replace("diameter: 120 mm", "diameter: 120 kg"))
    second.write_text("kind: x")
    with pytest.raises(CaseError) as refused:
        load_cases([first, good, second])
    assert [problem.file for problem in refused.value.problems] == [str(first), str(second)]
    assert len(load_cases([good, good])) == 2


def test_one_mistake_made_a_thousand_times_does_not_flood():
    text = template("journal") + "".join(f"\nfoo{i}: 1" for i in range(1000))
    with pytest.raises(CaseError) as caught:
        parse_case(text, "a.yaml")
    assert len(caught.value.problems) == 1000
    assert str(caught.value).count("\n") == MOST_SHOWN
    assert str(caught.value).endswith("a.yaml: and 950 more problems")


def test_what_was_given_is_kept():
    with pytest.raises(CaseError) as caught:
        case_from_dict({**yaml.safe_load(template("journal")), "load": "3 kg"})
    (problem,) = caught.value.problems
    assert (problem.line, problem.field, problem.given) == (0, "load", "'3 kg'")
    assert (problem.says, problem.allowed) == ("'3 kg' is a mass", "a force such as '36 kN'")


def test_messages_are_harmless_on_a_terminal():
    with pytest.raises(CaseError) as caught:
        parse_case('kind: journal\n"\\e[31m": 1\nname: "\\e[31m"\ndiameter: "\\e]0;x\\a"')
    assert str(caught.value).replace("\n", "").isprintable()


def test_a_list_whose_items_are_unusable_is_not_called_too_short():
    given = copy.deepcopy(MACHINE)
    given["bearings"] = given["bearings"][:1]
    given["bearings"][0]["diameter"] = "3 kg"
    with pytest.raises(CaseError) as caught:
        case_from_dict(given)
    assert [problem.field for problem in caught.value.problems] == ["bearings[0 'Pinion'].diameter"]


def parts_of(value):
    """Every piece of a case."""
    if isinstance(value, Part):
        yield value
        value = tuple(vars(value).values())
    for inner in value if isinstance(value, tuple) else ():
        yield from parts_of(inner)


def test_every_piece_of_an_eleven_bearing_file_is_checked_once_and_without_pint(request, monkeypatch):
    checked = Counter()

    def counted(piece, given):
        checked[type(piece)] += 1
        return lines(piece, given)

    lines = part._lines
    monkeypatch.setattr(part, "_lines", counted)
    monkeypatch.setattr(reading, "_with_pint", None)
    case = load_case(request.config.rootpath / "examples" / "marine_reverse_gear.yaml")
    assert isinstance(case, Machine)
    assert len(case.bearings) == 11
    assert checked[Machine] == 1
    assert checked <= Counter(type(piece) for piece in parts_of(case))


JUNK = [
    *(
        None,
        True,
        0,
        -1,
        1e400,
        float("nan"),
        "",
        "x",
        "250 mm",
        "1 kg",
        [],
        {},
        [1, 2],
        {"kind": "x"},
        {"kind": []},
    ),
    *(
        "\x1b[31m",
        "{says}",
        "2**9",
        10**400,
        "a" * 5000,
        [None],
        [{}],
        {1: 2},
        "50 degC",
        "180 deg",
        [{"name": "a"}],
    ),
]


def places(value, path=()):
    yield path
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in items:
        yield from places(inner, (*path, key))


def damaged(case, random_number):
    """A copy of a case with a few entries removed, added or replaced by junk."""
    case = copy.deepcopy(case)
    for _ in range(random_number.randint(1, 4)):
        *way, last = random_number.choice(list(places(case))[1:])
        parent = case
        for step in way:
            parent = parent[step]
        junk = copy.deepcopy(random_number.choice(JUNK))
        match random_number.randint(0, 3):
            case 0:
                del parent[last]
            case 1 if isinstance(parent, dict):
                parent[random_number.choice(["foo", "kind", "span", "name", "points"])] = junk
            case _:
                parent[last] = junk
        if len(list(places(case))) == 1:
            break
    return case


@pytest.mark.parametrize("seed", range(8))
def test_damaged_cases_are_refused_in_plain_words(seed):
    random_number = random.Random(seed)
    whole = [yaml.safe_load(template(kind)) for kind in kinds()]
    for _ in range(150):
        try:
            case_from_dict(damaged(random_number.choice(whole), random_number))
        except CaseError as error:
            message = str(error)
            assert message.replace("\n", "").isprintable()
            assert "pydantic" not in message
            assert "is not usable" not in message


def test_the_kind_decides_the_type():
    assert isinstance(parse_case(template("journal")), JournalCase)
    assert isinstance(parse_case(template("machine")), Machine)

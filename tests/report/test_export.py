"""JSON for other programs: the public contract, and no number that is none."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import jsonschema
import pytest

from babbitt.core.notices import Notice
from babbitt.core.result import Bound, Check
from babbitt.report.export import to_json, write_json

CONTRACT = {
    "type": "object",
    "required": ["babbitt", "case", "bearings"],
    "properties": {
        "babbitt": {"type": "string"},
        "case": {"type": "string"},
        "bearings": {
            "type": "array",
            "items": {
                "type": "object",
                "required": ["name", "kind", "method", "results", "checks", "warnings"],
                "properties": {
                    "name": {"type": "string"},
                    "kind": {"type": "string"},
                    "method": {"type": "string"},
                    "results": {"type": "object", "additionalProperties": {"type": "number"}},
                    "checks": {
                        "type": "array",
                        "items": {
                            "type": "object",
                            "required": ["code", "quantity", "value", "limit", "ok", "source"],
                            "properties": {
                                "code": {"type": "string"},
                                "quantity": {"type": "string"},
                                "value": {"type": ["number", "null"]},
                                "limit": {"type": ["number", "null"]},
                                "ok": {"type": "boolean"},
                                "source": {"type": "string"},
                            },
                        },
                    },
                    "warnings": {
                        "type": "array",
                        "items": {
                            "type": "object",
                            "required": ["code", "message", "values"],
                            "properties": {
                                "code": {"type": "string"},
                                "message": {"type": "string"},
                                "values": {"type": "object"},
                            },
                        },
                    },
                },
            },
        },
    },
}


def strict_parse(text):
    def refuse(constant):
        raise AssertionError(f"{constant} is not JSON")

    return json.loads(text, parse_constant=refuse)


def test_the_contract_is_kept(reverse_gear, violated, unsolved):
    machine = replace(reverse_gear, results=(*reverse_gear.results, violated, unsolved))
    record = strict_parse(write_json(machine))
    jsonschema.validate(record, CONTRACT)
    assert [bearing["name"] for bearing in record["bearings"]] == [r.name for r in machine.results]
    assert record["case_hash"] == machine.case_hash


def test_values_are_si_and_unrounded(reverse_gear):
    first = to_json(reverse_gear)["bearings"][0]
    assert first["results"]["minimum_film_thickness"] == 89e-6
    assert first["results"]["side_flow"] == 26.2 / 6e4
    assert first["results"]["outlet_temperature"] == pytest.approx(350.15)


def test_an_unsolved_bearing_has_no_results_and_keeps_its_message(reverse_gear, unsolved):
    record = to_json(replace(reverse_gear, results=(unsolved,)))["bearings"][0]
    assert record["results"] == {}
    assert record["checks"] == []
    assert record["status"] == "overloaded"
    assert record["last_state"] == {"minimum_film_thickness": 31.4e-6}
    assert "wider or larger bearing" in record["message"]


@pytest.mark.parametrize("number", [math.nan, math.inf, -math.inf])
def test_numbers_that_do_not_exist_are_absent_or_null(reverse_gear, good, number):
    check = Check("C101", "specific_load", number, 1e6, Bound.AT_MOST, "test")
    odd = replace(good, values={**good.values, "attitude_angle": number}, checks=(check,))
    record = strict_parse(write_json(replace(reverse_gear, results=(odd,))))["bearings"][0]
    assert "attitude_angle" not in record["results"]
    assert record["checks"][0]["value"] is None
    jsonschema.validate(record, CONTRACT["properties"]["bearings"]["items"])


def test_numbers_of_numpy_become_plain_numbers(reverse_gear, good):
    numpy = pytest.importorskip("numpy")
    typed = replace(good, values={"load": numpy.float64(3.0), "iterations": numpy.int64(7)})
    record = strict_parse(write_json(replace(reverse_gear, results=(typed,))))["bearings"][0]
    assert record["results"] == {"load": 3.0, "iterations": 7.0}


@pytest.mark.parametrize("name", ["Вал 轴", 'quote " and \\ and \n', "half \ud800 pair", "\x00"])
def test_any_name_survives_the_way_through_a_file(reverse_gear, good, name):
    text = write_json(replace(reverse_gear, results=(replace(good, name=name),)))
    assert strict_parse(text.encode().decode())["bearings"][0]["name"] == name


def test_common_letters_are_not_escaped(reverse_gear, good):
    assert "Вал" in write_json(replace(reverse_gear, results=(replace(good, name="Вал"),)))


def test_the_verdict_is_that_of_the_table(reverse_gear, good, violated, unsolved):
    advice = Check("C109", "outlet_temperature", 350.0, 343.15, Bound.AT_MOST, "advice", advisory=True)
    advised = replace(good, checks=(*good.checks, advice))
    record = to_json(replace(reverse_gear, results=(good, advised, violated, unsolved)))
    assert [bearing["verdict"] for bearing in record["bearings"]] == ["pass", "pass", "fail", "no_solution"]


def test_checks_not_made_are_told_with_what_is_missing(reverse_gear, good):
    lacking = replace(good, not_checked=(Notice("C105", "no_public_limit", {"metal": "Own"}),))
    first, second = to_json(replace(reverse_gear, results=(lacking, good)))["bearings"]
    assert first["not_checked"] == [
        {"code": "C105", "message": "no public limit of Own is included", "values": {"metal": "Own"}}
    ]
    assert second["not_checked"] == []


def test_totals_are_in_si_and_absent_for_one_bearing(reverse_gear, good):
    assert to_json(reverse_gear)["totals"] == {"friction_power": pytest.approx(11 * 28.3e3)}
    assert "totals" not in to_json(replace(reverse_gear, results=(good,)))

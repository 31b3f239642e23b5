"""Every notice that the program makes has its sentence, and every sentence a place that makes it."""

from __future__ import annotations

import ast
import math
import pickle
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

import babbitt
from babbitt.core.language import written_in
from babbitt.core.notices import Notice
from babbitt.core.notices import words as loader
from babbitt.core.notices.notice import TITLED, quantity_shown, retold
from babbitt.core.notices.words import PLACEHOLDER, REMEDY, SHARED, explanations, words
from babbitt.core.result import Outcome, Result

SOURCE = Path(babbitt.__file__).parent
MESSAGES = words().messages


@dataclass(frozen=True)
class Site:
    """One place that makes a notice; None where a name stands for the code or the variant."""

    place: str
    codes: tuple[str, ...] | None
    variants: tuple[str, ...] | None
    values: frozenset[str]

    def messages(self) -> dict[tuple[str, str], str]:
        """The messages that it can mean, with exactly its values."""
        codes = (*(self.codes or explanations()), SHARED)
        return {
            (code, variant): text
            for (code, variant), text in MESSAGES.items()
            if code in codes
            and (self.variants is None or variant in self.variants)
            and placeholders(text) == self.values
        }


def placeholders(text: str) -> set[str]:
    return {name for name, _ in PLACEHOLDER.findall(text.replace(REMEDY, ""))}


def constants(node: ast.expr) -> tuple[str, ...] | None:
    """The texts that an expression can be; None where it cannot be read."""
    if isinstance(node, ast.Constant):
        return (node.value,)
    if isinstance(node, ast.IfExp):
        first, other = constants(node.body), constants(node.orelse)
        return None if first is None or other is None else first + other
    return None


def sites() -> Iterator[Site]:
    for path in sorted(SOURCE.rglob("*.py")):
        text = path.read_text(encoding="utf-8")
        if not any(f"{maker}(" in text for maker in MAKERS):
            continue
        for node in ast.walk(ast.parse(text)):
            name = getattr(node.func, "id", "") if isinstance(node, ast.Call) else ""
            if name in MAKERS:
                yield MAKERS[name](f"{path.relative_to(SOURCE)}:{node.lineno}", node)


def of_notice(place: str, node: ast.Call) -> Site:
    given = dict(zip(("code", "variant", "values"), node.args, strict=False)) | {
        one.arg: one.value for one in node.keywords
    }
    values = given.get("values", ast.Dict([], []))
    assert isinstance(values, ast.Dict), f"{place}: values are written out where the notice is made"
    assert all(isinstance(key, ast.Constant) for key in values.keys), f"{place}: values are named by texts"
    variants = constants(given.get("variant", ast.Constant("")))
    return Site(place, constants(given["code"]), variants, frozenset(key.value for key in values.keys))


def of_not_read(place: str, node: ast.Call) -> Site:
    return Site(place, ("W183",), constants(node.args[1]), frozenset({"fields"}))


MAKERS = {"Notice": of_notice, "not_read": of_not_read}
SITES = tuple(sites())


@pytest.mark.parametrize("site", SITES, ids=lambda site: site.place)
def test_a_notice_has_its_sentence_with_exactly_its_values(site):
    meant = site.messages()
    assert meant, f"no message of {site.codes} {site.variants} has the placeholders {sorted(site.values)}"
    if site.variants is not None:
        assert {variant for _, variant in meant} == set(site.variants)
    if site.codes is not None and site.variants is not None:
        for code in site.codes:
            assert all((code, one) in meant or (SHARED, one) in meant for one in site.variants)


def test_no_message_is_without_a_place_that_makes_it():
    made = {key for site in SITES for key in site.messages()}
    assert not MESSAGES.keys() - made


@pytest.mark.parametrize("key", MESSAGES, ids=" ".join)
def test_a_placeholder_is_shown_as_a_quantity_or_unit_that_there_is(key):
    for name, measure in PLACEHOLDER.findall(MESSAGES[key]):
        assert not measure or measure == TITLED or quantity_shown(measure), f"{name} is shown as {measure}"
        assert measure != name
    assert "{" not in PLACEHOLDER.sub("", MESSAGES[key])


def test_numbers_are_written_as_in_tables_and_names_as_they_are():
    heat = Notice("W171", values={"heat": 1500.0, "rise": 12.34})
    assert heat.message.startswith("1500 W of friction and lost pressure")
    assert heat.message.endswith("would be warmed by 12.3 K")
    assert Notice("W169", values={"starts": 5, "least": 20}).message == "5 starts < 20"
    assert Notice("W170", values={"eccentricities": (0.1234567, 0.5)}).message.endswith("end 0.1235, 0.5")


def test_what_is_beyond_a_limit_reads_so():
    """Numbers that tables would write alike have the digits that show the difference; others stay as in tables."""
    said = Notice("W405", values={"given": 45.0e-3 / 60, "wanted": 45.0123e-3 / 60, "carry_over": 0.7}).message
    assert said.startswith("supply.flow is 45.000 L/min < 45.012 L/min that the films draw in")
    assert Notice("W169", values={"starts": 5, "least": 20}).message == "5 starts < 20"
    values = {
        "film_reynolds_number": 753.4, "critical_reynolds_number": 753.1, "machined": 188e-6, "assembled": 122e-6,
        "preload": 0.35, "at_assembled": 489.0, "critical_assembled": 935.0,
    }  # fmt: skip
    assert Notice("W407", values=values).message.startswith("Re = 753.40 > 753.10 = 41.3 sqrt")
    assert Notice("W407", values=values | {"film_reynolds_number": 760.0}).message.startswith("Re = 760 > 753 = ")


def test_clauses_become_part_of_the_sentence_and_of_the_values():
    how = Notice("W160", "gain", {"thermal_loop_gain": 1.5})
    left = Notice("W160", "left", {"how": how})
    assert left.message.startswith("thermal loop gain 1.500 > 1: cooler")
    assert left.plain_values() == {"how": {"thermal_loop_gain": 1.5}}
    assert Notice("W177", values={"error": math.inf}).plain_values() == {"error": None}


def test_a_failure_ends_with_the_remedy_of_its_code():
    failed = Notice("S002", "tried", {"far": Notice("S002", "far", {"reached": 373.15})})
    remedy = explanations()["S002"].remedy
    said = f"at 100.0 °C the friction power still exceeds the heat carried away. Try: m{remedy[1:]}"
    assert failed.message == said
    result = Result("A", "journal", "film", Outcome.of(failed), {}, failure=failed)
    assert (result.outcome, result.message) == (Outcome.THERMAL_RUNAWAY, said)
    assert pickle.loads(pickle.dumps(result)) == result
    assert Outcome.of(None) is Outcome.CONVERGED


@pytest.mark.parametrize(
    ("code", "variant", "values", "said"),
    [
        ("W109", "", {"surface_speed": 20.0004, "limit": 20.0}, "surface speed 20.0004 m/s > 20 m/s"),
        ("W109", "", {"surface_speed": 25.0, "limit": 20.0}, "surface speed 25.00 m/s > 20 m/s"),
        (
            "W200",
            "load",
            {"orbit_specific_load": 1.0001e7, "limit": 1e7, "metal": "tin"},
            "10.001 MPa > 10.000 MPa of tin",
        ),
    ],
)
def test_a_value_beyond_its_limit_never_reads_as_the_limit(code, variant, values, said):
    """One of them may be a number before a unit of the sentence: the other still shows the digits that tell so."""
    assert said in Notice(code, variant, values).message


def test_notices_are_compared_hashed_and_pickled():
    one, same = (Notice("W169", values={"starts": 5, "least": 20}) for _ in range(2))
    assert one == same == pickle.loads(pickle.dumps(one))
    assert len({one, same, Notice("W169", values={"starts": 6, "least": 20})}) == 2


def test_a_value_too_many_or_too_few_and_a_code_or_variant_that_is_not_there_are_refused():
    for code, variant, values in (
        ("W169", "", {"starts": 5}),
        ("W168", "", {"starts": 5}),
        ("W168", "other", {}),
        ("W999", "", {}),
    ):
        with pytest.raises(KeyError, match=code):
            Notice(code, variant, values)


def test_another_language_gives_what_it_has_and_english_the_rest(tmp_path, monkeypatch):
    code = '[{}]\ntitle = "Few {}"\nmeaning = "There are few."\nremedy = "Take more."\nmessage = "{{n}} {} < 20"\n'
    english = "".join(code.format(name, what, what) for name, what in (("W990", "grooves"), ("W991", "lands")))
    german = '[W990]\ntitle = "Wenige Nuten"\nmessage = "{n} Nuten < 20"\n'
    for language, said in (("en", english), ("de", german)):
        (tmp_path / f"words.{language}.toml").write_text(said, encoding="utf-8")
    folders = (*loader.folders(), tmp_path)
    monkeypatch.setattr(loader, "folders", lambda: folders)
    words.cache_clear()
    try:
        assert Notice("W990", values={"n": 5}).sentence("de") == "5 Nuten < 20"
        found = explanations("de")["W990"]
        assert (found.title, found.meaning) == ("Wenige Nuten", "There are few.")
        assert Notice("W991", values={"n": 5}).sentence("de") == "5 lands < 20"
    finally:
        words.cache_clear()


def test_a_text_stands_once():
    """Two files that explain one code, or give one message, would hide each other."""
    found: list[object] = []
    for folder in loader.folders():
        entries, messages = loader._read(folder, "en")
        found += [*entries, *messages]
    assert len(found) == len(set(found))
    assert {code for code, _ in MESSAGES} <= {*explanations(), SHARED}


@pytest.mark.parametrize("language", ["de", "ru"])
def test_a_sentence_that_was_kept_in_english_is_told_in_another_language(language):
    """As a row of a study keeps why it has no answer: the same as the notice itself says."""
    other = []
    for code, variant in MESSAGES:
        if code not in explanations() or code[0] == "E":
            continue
        notice = Notice(code, variant, dict.fromkeys(words().placeholders(code, variant), 0.25))
        with written_in(language):
            told = retold(code, notice.sentence())
            if told is not None and _rounded(told) != _rounded(notice.message):
                other.append((code, variant))
            if told is None and re.search("[a-z]{2}", PLACEHOLDER.sub("", MESSAGES[code, variant])):
                other.append((code, variant))
    assert other == []


def _rounded(said):
    """The value of this test with as many digits everywhere: a comparison may show more."""
    return said.replace("0,250", "0,25")


def test_a_sentence_of_no_known_form_is_not_told():
    with written_in("de"):
        assert retold("S001", "another sentence") is None

"""Former words of the case language say what those of today say, and messages name what the file has."""

from typing import Annotated, Any, ClassVar, Literal

import pytest
from pydantic import Discriminator, Field, ValidationError

from babbitt.case.aliases import FormerWords, Moved, in_former_words, in_todays_words, read_former, todays_path
from babbitt.case.part import Issue, Part, rule
from babbitt.core.units import si

Length = Annotated[float, si("m", "1 um", "1 m")]


class Inlet(Part):
    temperature: Annotated[float, si("K", "0 degC", "200 degC")] = Field(description="Of the oil.")
    pressure: Annotated[float, si("Pa", "1 Pa", "1 MPa")] | None = Field(None, description="Of the oil.")


class Radial(Part):
    kind: Literal["radial"] = Field(description="On the radius.")
    mean: Length = Field(description="Mean.")


class Diametral(Part):
    kind: Literal["diametral"] = Field(description="On the diameter.")
    mean: Length = Field(description="Mean.")


class Piece(Part):
    former_words: ClassVar[FormerWords] = {"bore": "inner_diameter"}
    inner_diameter: Length = Field(description="Bore.")


class Bearing(Part):
    former_words: ClassVar[FormerWords] = {
        "thrust": "load",
        "oil.supply_temperature": "supply.temperature",
        "radial_clearance": Moved("clearance.mean", kind="radial"),
    }
    load: Annotated[float, si("N", "1 N", "1 MN")] = Field(description="Load.")
    oil: dict[str, Any] | None = Field(None, description="Oil.")
    supply: Inlet | None = Field(None, description="Supply.")
    clearance: Annotated[Radial | Diametral, Discriminator("kind")] = Field(description="Clearance.")
    pieces: tuple[Piece, ...] = Field((), description="Pieces.")

    @rule
    def _light(self):
        if self.load > 1000.0:
            yield Issue(("load",), "too heavy")


FORMER = {
    "thrust": "500 N",
    "oil": {"supply_temperature": "40 degC"},
    "radial_clearance": "30 um",
    "pieces": [{"bore": "10 mm"}],
}
TODAY = {
    "load": "500 N",
    "supply": {"temperature": "40 degC"},
    "clearance": {"kind": "radial", "mean": "30 um"},
    "pieces": [{"inner_diameter": "10 mm"}],
}


def findings(given):
    with pytest.raises(ValidationError) as caught:
        Bearing.model_validate(given)
    return {".".join(map(str, one["loc"])): one["ctx"]["says"] for one in caught.value.errors()}


def test_both_words_make_one_part():
    assert Bearing.model_validate(FORMER) == Bearing.model_validate(TODAY)
    assert in_todays_words(Bearing, FORMER) == in_todays_words(Bearing, TODAY) == TODAY


def test_what_stands_beside_a_former_word_stays():
    oil = {"supply_temperature": "40 degC", "name": "oil"}
    part = Bearing.model_validate(FORMER | {"oil": oil, "supply": {"temperature": None, "pressure": "1 kPa"}})
    assert part.oil == {"name": "oil"}
    assert (part.supply.temperature, part.supply.pressure) == (313.15, 1000.0)
    assert oil == {"supply_temperature": "40 degC", "name": "oil"}  # what was given is not changed


@pytest.mark.parametrize(
    ("change", "path"),
    [
        ({"thrust": "500 rpm"}, "thrust"),
        ({"thrust": "5 kN"}, "thrust"),  # by a rule
        ({"thrust": None}, "thrust"),
        ({"oil": {"supply_temperature": "40 mm"}}, "oil.supply_temperature"),
        ({"radial_clearance": "30 m"}, "radial_clearance"),
        ({"pieces": [{"bore": "10 mm"}, {"bore": "10 kN"}]}, "pieces.1.bore"),
    ],
)
def test_a_fault_is_told_at_the_word_of_the_file(change, path):
    assert list(findings(FORMER | change)) == [path]


@pytest.mark.parametrize(
    ("beside", "former", "today"),
    [
        ({"load": "500 N"}, "thrust", "load"),
        ({"supply": {"temperature": "40 degC"}}, "oil.supply_temperature", "supply.temperature"),
        ({"clearance": {"kind": "radial", "mean": "30 um"}}, "radial_clearance", "clearance"),
    ],
)
def test_both_words_at_once_are_refused(beside, former, today):
    told = findings(FORMER | beside)
    assert list(told) == [former]
    assert today in told[former]


def test_all_faults_are_told_beside_a_word_given_twice():
    assert set(findings(FORMER | {"load": "5 mm", "pieces": 3})) == {"thrust", "load", "pieces"}


def test_paths_in_either_word():
    def path(text):
        return ".".join(todays_path(Bearing, text.split(".")))

    assert path("thrust") == path("load") == "load"
    assert path("oil.supply_temperature") == "supply.temperature"
    assert path("radial_clearance") == "clearance.mean"
    assert path("pieces.1.bore") == "pieces.1.inner_diameter"
    assert path("supply.pressure") == "supply.pressure"
    assert path("oil") == "oil"


def test_content_in_former_words_has_them_where_they_say_it_all():
    assert in_former_words(Bearing, TODAY) == FORMER | {"pieces": TODAY["pieces"]}  # of one part, not those within
    diametral = TODAY | {"clearance": {"kind": "diametral", "mean": "60 um"}}
    assert in_former_words(Bearing, diametral)["clearance"] == diametral["clearance"]
    limited = TODAY | {"clearance": {"kind": "radial", "mean": 1.0, "maximum": 2.0}}
    assert in_former_words(Bearing, limited)["clearance"] == limited["clearance"]


def test_one_word_of_two_forms():
    words = {"clearance": Moved("clearance.mean", kind="radial", where=lambda value: isinstance(value, str))}
    today = {"clearance": {"kind": "radial", "mean": "20 um"}}
    assert read_former(words, {"clearance": "20 um"}).given == today
    assert read_former(words, today).given == today
    assert read_former(words, {"clearance": "20 um"}).as_written(("clearance", "mean")) == ("clearance",)

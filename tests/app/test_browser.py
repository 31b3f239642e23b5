"""The page in a real browser: what a designer does, by mouse and by keyboard alone."""

import json
import re
import subprocess
import sys
from urllib.request import Request, urlopen
from xml.etree import ElementTree

import pytest
from browsing import IN_BROWSER, film_thickness, section, text_of, until

from babbitt.app.answer import answer
from babbitt.app.link import case_of
from babbitt.core.kind import kinds

pytestmark = IN_BROWSER


def solved_by_command(text, tmp_path):
    """The same case by `babbitt solve`."""
    (tmp_path / "case.yaml").write_text(text)
    subprocess.run(
        [sys.executable, "-m", "babbitt", "solve", "case.yaml", "--json", "out.json"], cwd=tmp_path, check=True,
        capture_output=True,
    )  # fmt: skip
    return json.loads((tmp_path / "out.json").read_text())


def test_a_slider_thins_the_film(page):
    before = film_thickness(page)
    handle = page.locator(".slider", has_text="load").first.locator(".q-slider")
    box = handle.bounding_box()
    y = box["y"] + 0.5 * box["height"]
    page.mouse.move(box["x"] + 0.34 * box["width"], y)
    page.mouse.down()
    page.mouse.move(box["x"] + 0.9 * box["width"], y, steps=5)
    page.mouse.up()
    until(page, lambda: film_thickness(page) < 0.9 * before)

    def went_back():  # a hand that pauses on a busy machine leaves several steps to go back
        page.get_by_label("Undo").click()
        return film_thickness(page) == before

    until(page, went_back)


def test_a_wrong_unit_is_told_at_its_field(page):
    page.get_by_label("Diameter", exact=True).fill("12 kg")
    page.wait_for_selector(".fault")
    assert "is a mass" in page.locator(".fault").first.inner_text()
    until(page, lambda: any("is a mass" in one for one in page.locator(".q-field__messages").all_inner_texts()))
    page.get_by_label("Diameter", exact=True).fill("120")
    page.wait_for_selector(".verdict")


def test_the_method_is_changed_and_compared_and_turned(page):
    """From the standard to a film, then the load is turned by hand: the case follows."""
    section(page, "Method and limits")
    page.get_by_label("Method", exact=True).click()
    page.get_by_role("option", name="film", exact=True).click()
    page.wait_for_selector(".picture .load.handle.line", state="attached")
    assert page.locator(".answer", has_text="Film in two dimensions").count()
    handle = page.locator(".picture .load.line.handle").bounding_box()
    x, y = handle["x"] + 0.5 * handle["width"], handle["y"] + 4.0
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 90.0, y + 25.0, steps=4)
    page.mouse.up()
    until(page, lambda: page.locator(".picture .load.line.handle").get_attribute("data-angle") != "-90")
    angle = float(page.locator(".picture .load.line.handle").get_attribute("data-angle"))
    assert f"load_angle: {angle:.1f} deg" in text_of(page)
    page.get_by_role("tab", name="Figures").click()
    page.get_by_role("button", name="Draw the figures").click()
    page.wait_for_selector(".figure svg")


def picture(page):
    """What the drawing says that it shows, and how wide it is; None where there is none."""
    return page.evaluate(
        "(one => one && [one.getAttribute('aria-label'), one.getBoundingClientRect().width > 200])"
        "(document.querySelector('svg.picture'))"
    )


@pytest.mark.parametrize("kind", kinds())
def test_every_template_opens_draws_and_comes_back_from_its_link(page, kind):
    template = kinds()[kind].read_template()
    found = answer(template)
    shown = [ElementTree.fromstring(found.bearings[found.worst].picture).get("aria-label"), True]
    page.get_by_role("button", name="New").click()
    page.get_by_role("menuitem", name=kinds()[kind].description, exact=True).click()
    until(page, lambda: picture(page) == shown)
    page.get_by_label("Copy a link to this case").click()
    until(page, lambda: "#case=" in page.evaluate("location.href"))
    link = page.evaluate("location.href")
    assert case_of(link.partition("#")[2]) == template
    page.evaluate("sessionStorage.clear()")  # no draft: the link alone brings the case back
    page.goto("about:blank")
    page.goto(link)
    until(page, lambda: picture(page) == shown)
    page.wait_for_selector(".verdict")
    title = re.search(r"(?m)^name: (.*?)\s*(#.*)?$", template).group(1)
    until(page, lambda: title[:12] in text_of(page))


def test_the_report_and_the_numbers_are_those_of_the_command(page, tmp_path):
    with page.expect_download() as began:
        page.get_by_role("button", name="Report").click()
        page.get_by_role("menuitem", name="PDF").click()
    assert began.value.path().read_bytes().startswith(b"%PDF-")
    with page.expect_download() as began:
        page.get_by_role("button", name="Report").click()
        page.get_by_role("menuitem", name="Results (JSON)").click()
    shown = json.loads(began.value.path().read_text())
    found = solved_by_command(kinds()["journal"].read_template(), tmp_path)
    for one in (*shown["bearings"], *found["bearings"]):
        one["results"].pop("wall_time", None)
    assert shown["bearings"] == found["bearings"]


def test_a_case_file_is_opened(page, tmp_path):
    text = kinds()["journal"].read_template().replace("name: Example bearing", "name: <b>Opened</b>")
    (tmp_path / "own.yaml").write_text(text)
    page.locator("input[type=file]").set_input_files(tmp_path / "own.yaml")
    until(page, lambda: "<b>Opened</b>" in text_of(page))
    assert page.locator("b", has_text="Opened").count() == 0
    (tmp_path / "large.yaml").write_text("#" * 2_000_000)
    page.locator("input[type=file]").set_input_files(tmp_path / "large.yaml")
    page.get_by_text("larger than 1 MB").wait_for()


def test_by_keyboard_alone(page):
    """Reach the diameter by tabs, read what it is for, and change it."""
    before = film_thickness(page)
    for _ in range(60):
        page.keyboard.press("Tab")
        if page.evaluate("document.activeElement.getAttribute('aria-label')") == "Diameter":
            break
    else:
        raise AssertionError("the diameter is out of reach")
    page.locator(".q-tooltip", has_text="inside diameter").wait_for()
    page.keyboard.press("Control+A")
    page.keyboard.type("140")
    until(page, lambda: film_thickness(page) != before)


@pytest.mark.parametrize(
    ("headers", "status"), [({"Host": "evil.example"}, 403), ({"Origin": "http://evil.example"}, 403)]
)
def test_foreign_pages_are_refused(server, headers, status):
    from urllib.error import HTTPError

    with pytest.raises(HTTPError) as refused:
        urlopen(Request(server, headers=headers), timeout=30)
    refused.value.close()
    assert refused.value.code == status

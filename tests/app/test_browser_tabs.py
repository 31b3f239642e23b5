"""The tabs, the draft and what is taken along, in a real browser."""

import re

import pytest
from browsing import IN_BROWSER, film_thickness, opened, tab, text_of, until

from babbitt.app.document import CaseDocument
from babbitt.core.kind import kinds

pytestmark = IN_BROWSER


def film(**changes):
    document = CaseDocument(kinds()["journal"].read_template())
    document.change(("method",), {"kind": "film", "accuracy": "draft"})
    document.change(("supply_element",), None)
    document.change(("grooves",), [{"angle": f"{angle} deg", "extent": "20 deg"} for angle in (0, 180)])
    for name, value in changes.items():
        document.change((name,), value)
    return document.text


def choose(page, label, option):
    page.get_by_label(label).click()
    page.get_by_role("option", name=option).first.click()


def test_a_sweep_runs_and_is_taken_along(page):
    tab(page, "Studies")
    page.get_by_label("load from").fill("8 kN")
    page.get_by_role("button", name="Run the study").click()
    page.wait_for_selector(".more .figure svg")
    assert page.get_by_text("Study of kind sweep: 11 rows; 0 without a solution.").count()
    loads = page.locator(".more .q-table").first.locator("tbody tr td:first-child").all_inner_texts()
    assert (loads[0], loads[-1], len(loads)) == ("8", "24", 11)
    with page.expect_download() as began:
        page.get_by_role("button", name="CSV").click()
    rows = began.value.path().read_text().splitlines()
    assert len(rows) == 12
    page.get_by_role("button", name="Put this study into the case").click()
    until(page, lambda: "kind: sweep" in text_of(page))


def begin_a_long_study(page):
    opened(page, film())
    tab(page, "Studies")
    choose(page, "What is asked", "tolerance")
    page.get_by_label("Samples").fill("100000")
    page.get_by_role("button", name="Run the study").click()


def test_a_study_is_cancelled_and_the_page_goes_on(page):
    begin_a_long_study(page)
    page.get_by_role("button", name="Cancel").click()
    page.get_by_text("Cancelled.").wait_for()
    choose(page, "What is asked", "corners")
    page.get_by_role("button", name="Run the study").click()
    page.get_by_text("Study of kind corners").wait_for()


def test_another_case_ends_the_study_of_the_one_before(page):
    begin_a_long_study(page)
    cancel = page.get_by_role("button", name="Cancel").first
    cancel.wait_for()
    opened(page, film(load="9 kN"))
    cancel.wait_for(state="hidden")
    said = page.locator(".more [role=status]")
    until(page, lambda: not "".join(said.all_inner_texts()).strip())
    assert page.locator(".more .q-table").count() == 0


def test_a_study_that_is_impossible_says_why(page):
    tab(page, "Studies")
    page.get_by_label("load from").fill("8 kg")
    page.get_by_role("button", name="Run the study").click()
    page.locator(".more .fault").wait_for()
    assert "study.vary.load" in page.locator(".more .fault").inner_text()


def test_the_draft_survives_a_reload_and_a_link_replaces_it(page):
    page.get_by_label("Diameter", exact=True).fill("131")
    until(page, lambda: page.evaluate("Object.values(sessionStorage).join()").count("131 mm"))
    page.reload()
    page.wait_for_selector(".verdict")
    until(page, lambda: page.get_by_label("Diameter", exact=True).input_value() == "131")
    page.get_by_label("Copy a link to this case").click()
    until(page, lambda: "#case=" in page.evaluate("location.href"))
    link = page.evaluate("location.hash")
    page.get_by_label("Diameter", exact=True).fill("125")
    until(page, lambda: page.evaluate("Object.values(sessionStorage).join()").count("125 mm"))
    page.reload()
    until(page, lambda: page.get_by_label("Diameter", exact=True).input_value() == "125")
    page.evaluate("location.hash = ''")
    page.evaluate(f"location.hash = '{link}'")
    until(page, lambda: page.get_by_label("Diameter", exact=True).input_value() == "131")


def test_copies_as_yaml_and_as_python(page):
    page.get_by_role("button", name="Copy", exact=True).click()
    page.get_by_role("menuitem", name="As Python").click()
    until(page, lambda: "babbitt.JournalBearing(" in page.locator(".offered textarea").input_value())
    page.get_by_role("button", name="Close").click()
    until(page, lambda: page.locator(".offered").count() == 0)
    page.get_by_role("button", name="Copy", exact=True).click()
    page.get_by_role("menuitem", name="As YAML").click()
    until(page, lambda: page.locator(".offered textarea").input_value() == kinds()["journal"].read_template())


def test_an_oil_of_the_catalogue_is_taken(page):
    before = film_thickness(page)
    tab(page, "Oils and metals")
    page.wait_for_selector(".chart svg")
    page.get_by_label("Oil for the case").fill("VG 100")
    page.get_by_role("option", name="ISO VG 100", exact=True).click()
    page.get_by_role("button", name="Take the chosen oil").click()
    until(page, lambda: film_thickness(page) > before)
    assert "lubricant: ISO VG 100" in text_of(page)


def test_two_designs_stand_side_by_side(page):
    tab(page, "Two designs")
    page.get_by_role("button", name="Keep this design as A").click()
    page.get_by_label("Diameter", exact=True).fill("140")
    until(page, lambda: page.locator(".card .kept", has_text="A: ").count() > 3)
    page.get_by_role("button", name="Compare the page with A").click()
    page.get_by_text("Changed inputs").wait_for()
    cells = page.locator(".more tr", has_text="diameter").first.locator("td").all_inner_texts()
    assert cells == ["diameter", "120 mm", "140 mm"]
    page.get_by_role("button", name="Go back to A").click()
    until(page, lambda: page.get_by_label("Diameter", exact=True).input_value() == "120")


def test_a_groove_is_dragged(page):
    opened(page, film())
    groove = page.locator('.picture .handle[data-field="grooves.0.angle"]').last
    groove.wait_for(state="attached")
    before = groove.get_attribute("data-angle")
    box = groove.bounding_box()
    x, y = box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"]
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x - 10.0, y - 60.0, steps=4)
    page.mouse.up()
    until(page, lambda: groove.get_attribute("data-angle") != before)
    angle = float(groove.get_attribute("data-angle"))
    assert 5.0 < angle < 60.0
    assert f"angle: {angle:.1f} deg" in text_of(page)


def test_fields_of_the_film_are_drawn(page):
    opened(page, film())
    tab(page, "Fields")
    page.get_by_role("button", name="Draw the fields").click()
    page.wait_for_selector(".chart canvas, .chart .gl-container", state="attached")
    page.get_by_role("switch", name="as a surface").click()
    page.wait_for_selector(".chart .heatmaplayer", state="attached")


def test_figures_and_published_cases_run_when_asked(page):
    tab(page, "Figures")
    page.get_by_role("button", name="Draw all figures").click()
    page.wait_for_selector(".figure svg")
    tab(page, "Validation")
    choose(page, "Cases to run", "butenschoen_1976")
    page.keyboard.press("Escape")
    page.get_by_role("button", name="Run the chosen cases").click()
    page.get_by_text(re.compile("all agree")).first.wait_for()


def test_us_units_show_and_the_case_keeps_its_own(page):
    tab(page, "Two designs")
    page.get_by_role("button", name="Keep this design as A").click()
    page.locator(".kept", has_text="µm").first.wait_for()
    page.get_by_role("button", name="US units").click()
    page.locator(".card", has_text="mil").first.wait_for()
    page.locator(".kept", has_text="mil").first.wait_for()
    assert not page.locator(".card", has_text=re.compile("µm|°C|L/min")).count()
    until(page, lambda: page.get_by_label("Diameter", exact=True).input_value() == "4.72441")
    assert "diameter: 120 mm" in text_of(page)
    tab(page, "Form")
    page.get_by_label("Diameter", exact=True).fill("5")
    until(page, lambda: "diameter: 5 in" in text_of(page))


def test_what_is_printed_is_the_bearing_and_its_answer(page):
    page.emulate_media(media="print", color_scheme="dark")
    assert not page.locator("header").is_visible()
    assert not page.locator(".case").is_visible()
    assert page.locator(".verdict").is_visible()
    assert page.locator(".drawing svg").is_visible()
    assert page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"


def test_a_name_that_is_markup_stays_text_on_every_tab(page):
    opened(page, film(name="<img src=x onerror='window.hacked = 1'>"))
    until(page, lambda: "onerror" in text_of(page))
    tab(page, "Two designs")
    page.get_by_role("button", name="Keep this design as A").click()
    page.get_by_role("button", name="Compare the page with A").click()
    page.get_by_text("No input differs").or_(page.get_by_text("left out:")).first.wait_for()
    tab(page, "Fields")
    page.get_by_role("button", name="Draw the fields").click()
    page.wait_for_selector(".chart", state="attached")
    tab(page, "Figures")
    page.get_by_role("button", name="Draw the figures").click()
    page.wait_for_selector(".figure svg")
    tab(page, "Studies")
    choose(page, "What is asked", "corners")
    page.get_by_role("button", name="Run the study").click()
    page.get_by_text("Study of kind corners").wait_for()
    assert page.locator("img[src=x]").count() == 0
    assert page.evaluate("window.hacked") is None


SERIOUS = ("serious", "critical")


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_accessibility(page, scheme):
    """No serious finding of axe-core on any tab."""
    scanner = pytest.importorskip("axe_playwright_python.sync_playwright", reason="axe-core is not installed")
    page.emulate_media(color_scheme=scheme)
    page.wait_for_timeout(1000)  # colours change by and by
    found = {}
    for name in (
        "Vary a value", "Results", "Fields", "Figures", "Methods side by side", "Two designs", "Studies",
        "Oils and metals", "Validation",
    ):  # fmt: skip
        tab(page, name)
        page.wait_for_timeout(400)  # the tab slides in
        for one in scanner.Axe().run(page).response["violations"]:
            if one["impact"] in SERIOUS:
                found.setdefault(one["id"], set()).update(node["html"][:160] for node in one["nodes"])
    assert found == {}

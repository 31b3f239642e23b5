"""A designer without a terminal: a template, another oil, the largest clearance within the limits, the report.

Once with the mouse, once on the keyboard alone.
"""

import pytest
from browsing import IN_BROWSER, NAME, film_thickness, option, press_until, reach, tab, text_of, until

from babbitt.app.answer import read, solved

pytestmark = IN_BROWSER

SCAN_ENDS = "a wider one may find more"
"""What the page says of values that are the largest of the scan alone."""

PASSED = ("pass", "pass with remarks")


def type_in(page, name, text):
    reach(page, name)
    page.keyboard.press("Control+A")
    page.keyboard.type(text)


def menu(page, name, entry):
    reach(page, name)
    page.keyboard.press("Enter")
    page.wait_for_selector("[role=menuitem]")
    press_until(page, "ArrowDown", lambda: page.evaluate(NAME) == entry)


def drafts(page):
    """What the browser keeps of the case."""
    return page.evaluate("Object.values(sessionStorage).join()")


def diameter_is(page, value):
    until(page, lambda: page.get_by_label("Diameter", exact=True).input_value() == value)


def mean_is(page, clearance):
    number, unit = clearance.split()
    until(page, lambda: page.get_by_label("Mean", exact=True).input_value() == number)
    assert page.get_by_label("Unit: Mean", exact=True).input_value() == unit


def largest_offered(page):
    """What the last button says: a value, and behind it in brackets what that is."""
    return page.locator(".more button", has_text="permille").last.inner_text()


def check(page, oil, clearance, report):
    """The case has what was chosen, it keeps its limits, and the report is one."""
    assert page.locator(".verdict .word").inner_text() in PASSED
    text = text_of(page)
    assert f"lubricant: {oil}" in text
    assert f"mean: {clearance}" in text
    (result,) = solved(text).results
    assert result.within_limits
    assert read(text).clearance.mean == pytest.approx(1e-3 * float(clearance.split()[0]))
    assert report.startswith(b"%PDF-")


def test_with_the_mouse(page):
    page.get_by_label("Diameter", exact=True).fill("125")
    until(page, lambda: "125 mm" in drafts(page))
    page.get_by_role("button", name="New").click()
    page.get_by_role("menuitem", name="one journal bearing").click()
    diameter_is(page, "120")
    page.get_by_label('Expand "Oil"').click()
    before = film_thickness(page)
    page.get_by_label("Lubricant", exact=True).fill("ISO VG 100")
    until(page, lambda: film_thickness(page) > before)
    tab(page, "Studies")
    page.get_by_label("What is asked").click()
    page.get_by_role("option", name="size").click()
    page.get_by_label("Field that varies").click()
    page.get_by_role("option", name="clearance mean").click()
    page.keyboard.press("Escape")
    page.get_by_label("clearance.mean to").fill("4 permille")
    page.get_by_role("button", name="Run the study").click()
    page.get_by_text(SCAN_ENDS).wait_for()
    page.get_by_label("clearance.mean to").fill("15 permille")
    page.get_by_role("button", name="Run the study").click()
    page.get_by_text(SCAN_ENDS).wait_for(state="detached")
    page.get_by_text("Take into the case:").wait_for()
    assert not page.get_by_text(SCAN_ENDS).count()
    clearance, _, _ = largest_offered(page).partition(" (")
    page.get_by_role("button", name=clearance).click()
    mean_is(page, clearance)
    page.get_by_role("button", name="Report").click()
    with page.expect_download() as began:
        page.get_by_role("menuitem", name="PDF").click()
    check(page, "ISO VG 100", clearance, began.value.path().read_bytes())


def test_a_value_that_was_found_for_another_case_is_not_taken(page):
    """It went into whatever case stood on the page, its load and its limits being others."""
    tab(page, "Studies")
    option(page, "What is asked", "size")
    page.get_by_role("button", name="Run the study").click()
    page.get_by_text("Take into the case:").wait_for()
    page.get_by_label("Diameter", exact=True).fill("90")
    until(page, lambda: "90 mm" in drafts(page))
    before = text_of(page)
    tab(page, "Studies")
    page.locator(".more button", has_text="kN").last.click()
    page.locator(".q-notification", has_text="The case has changed since").wait_for()
    assert text_of(page) == before


def test_another_case_takes_away_what_was_found_for_the_one_before(page):
    tab(page, "Studies")
    option(page, "What is asked", "size")
    page.get_by_role("button", name="Run the study").click()
    page.get_by_text("Take into the case:").wait_for()
    page.get_by_role("button", name="New").click()
    page.get_by_role("menuitem", name="one journal bearing").click()
    page.get_by_text("Take into the case:").wait_for(state="detached")


def test_on_the_keyboard_alone(page):
    type_in(page, "Diameter", "125")
    until(page, lambda: "125 mm" in drafts(page))
    menu(page, "New", "one journal bearing, by ISO 7902 or its film")
    page.keyboard.press("Enter")
    diameter_is(page, "120")
    before = film_thickness(page)
    reach(page, 'Expand "Oil"')
    page.keyboard.press("Enter")
    page.wait_for_selector("input[aria-label=Lubricant]")
    type_in(page, "Lubricant", "ISO VG 100")
    until(page, lambda: film_thickness(page) > before)
    reach(page, "Vary a value")
    press_until(page, "ArrowRight", lambda: page.evaluate(NAME) == "Studies")
    page.keyboard.press("Enter")
    option(page, "What is asked", "size")
    option(page, "Field that varies", "clearance mean")
    page.get_by_label("clearance.mean to").wait_for()
    page.keyboard.press("Escape")
    type_in(page, "clearance.mean to", "15 permille")
    reach(page, "Run the study")
    page.keyboard.press("Enter")
    page.get_by_text("Take into the case:").wait_for()
    offered = largest_offered(page)
    clearance, _, _ = offered.partition(" (")
    reach(page, offered)
    page.keyboard.press("Enter")
    mean_is(page, clearance)
    menu(page, "Report", "PDF")
    with page.expect_download() as began:
        page.keyboard.press("Enter")
    check(page, "ISO VG 100", clearance, began.value.path().read_bytes())


def test_a_slider_that_keys_move_comes_to_a_settled_answer(page):
    """While it moves a draft answers, then the grid of the case."""
    before = film_thickness(page)
    page.locator(".slider .q-slider__track-container").first.focus()
    for _ in range(10):
        page.keyboard.press("ArrowRight")
    until(page, lambda: film_thickness(page) < before and page.locator(".quick").count() == 0)

"""What stands on the page is of the case on the page, or says that it is not."""

import re

from browsing import IN_BROWSER, opened, section, tab, text_of, until
from page_cases import FILM, JOURNAL, changed

pytestmark = IN_BROWSER

WATCH_PENDING = """() => {
  window.seen = [];
  const answer = document.querySelector('.answer');
  const look = () => window.seen.push(document.querySelector('.answer.pending .computing')?.innerText ?? '');
  new MutationObserver(look).observe(answer, {attributes: true, childList: true, subtree: true});
}"""
"""Keep what the page says while an answer is computed."""

REMARK = "The case has changed since this was computed."


def load_of_slider(page):
    return page.locator(".slider", has_text="load").first.locator(".number").inner_text()


def test_form_and_slider_show_the_same_load(page):
    section(page, "Operation")
    load = page.get_by_label("Load", exact=True)
    load.fill("20")
    until(page, lambda: load_of_slider(page) == "20 kN")
    page.locator(".slider", has_text="load").first.locator(".q-slider__track-container").focus()
    for _ in range(5):
        page.keyboard.press("ArrowRight")
    until(page, lambda: load_of_slider(page) != "20 kN" and f"{load.input_value()} kN" == load_of_slider(page))


def test_a_slider_that_stops_moves_its_own_field_alone(page):
    """In US units it moves a load in pounds; no other control is drawn anew."""
    load, diameter = page.get_by_label("Load", exact=True), page.get_by_label("Diameter", exact=True)
    page.get_by_role("button", name="US units").click()
    until(page, lambda: diameter.input_value() == "4.72441")
    section(page, "Operation")
    before = load.input_value()
    diameter.evaluate("control => { control.dataset.drawn = 'once' }")
    page.locator(".slider", has_text="load").first.locator(".q-slider__track-container").focus()
    for _ in range(5):
        page.keyboard.press("ArrowRight")
    until(page, lambda: load.input_value() != before)
    assert diameter.get_attribute("data-drawn") == "once"
    moved, unit = load_of_slider(page).split()
    assert unit == "lbf"
    assert abs(float(load.input_value()) / float(moved.replace(",", "")) - 1.0) < 1e-3


def test_numbers_of_a_case_that_was_wrong_are_faint_until_it_is_mended(page):
    tab(page, "Results")
    until(page, lambda: page.locator(".results tbody tr").count() > 20)
    assert not page.locator(".results.stale").count()
    page.get_by_label("Diameter", exact=True).fill("12 kg")
    until(page, lambda: page.locator(".results.stale").count() == 1)
    page.get_by_label("Diameter", exact=True).fill("120")
    until(page, lambda: not page.locator(".results.stale").count())


def test_an_answer_that_is_being_computed_is_faint_until_it_is_there(page):
    """A load of 900 kN stood beside "pass" for 14 s."""
    opened(page, changed(FILM, method={"kind": "film", "thermal": "full"}))
    pending = page.locator(".answer.pending")
    until(page, lambda: not pending.count())
    page.evaluate(WATCH_PENDING)
    page.get_by_label("Diameter", exact=True).fill("121")
    until(page, lambda: page.evaluate("window.seen.includes('Working ...')"))
    until(page, lambda: not pending.count())


def test_comments_of_a_field_that_is_filled_anew_remain(page):
    """It was taken out as soon as it was empty, and came back at the end of the text."""
    opened(page, JOURNAL.replace("diameter: 120 mm", "diameter: 120 mm  # of the drawing"))
    diameter = page.get_by_label("Diameter", exact=True)
    diameter.fill("")
    page.wait_for_timeout(1000)
    diameter.fill("130")
    until(page, lambda: "diameter: 130 mm  # of the drawing" in text_of(page))


def test_a_text_that_is_no_case_has_a_form_that_says_so(page):
    opened(page, "kind: [journal")
    page.get_by_text("The text is no case that can be read.").wait_for()


def test_a_field_that_the_method_does_not_read_says_so(page):
    opened(page, changed(FILM, span="180 deg"))
    hint = page.get_by_text("Not used by this method")
    until(page, lambda: page.locator("label", has_text="Span").filter(has=hint).count() == 1)
    opened(page, JOURNAL)
    until(page, lambda: not hint.count())


def test_what_was_computed_of_another_case_says_so(page):
    tab(page, "Methods side by side")
    compare = page.get_by_role("button", name="Compare the methods")
    compare.click()
    until(page, lambda: page.locator(".more table").count() >= 1)
    remark = page.get_by_text(REMARK)
    assert not remark.is_visible()
    page.get_by_label("Diameter", exact=True).fill("130")
    remark.wait_for(state="visible")
    assert page.locator(".more table").count() >= 1
    compare.click()
    remark.wait_for(state="hidden")


def test_a_study_that_is_put_into_the_case_stays_its_own(page):
    """The block that asks for a study does not make another case; another load does."""
    tab(page, "Studies")
    page.get_by_label("What is asked").click()
    page.get_by_role("option", name=re.compile("^corners")).click()
    page.get_by_role("button", name="Run the study").click()
    until(page, lambda: page.locator(".more table").count() >= 1)
    page.get_by_role("button", name="Put this study into the case").click()
    until(page, lambda: "kind: corners" in page.evaluate("Object.values(sessionStorage).join()"))
    assert not page.get_by_text(REMARK).is_visible()
    page.get_by_label("Diameter", exact=True).fill("130")
    page.get_by_text(REMARK).wait_for(state="visible")


def test_the_page_speaks_german_and_keeps_case_and_units_in_russian(page, server):
    page.goto(f"{server}/?language=de")
    page.locator(".verdict .word", has_text="bestanden").wait_for()
    assert page.evaluate("document.documentElement.lang") == "de"
    page.get_by_role("button", name="Neu").click()
    page.get_by_role("menuitem", name=re.compile("^ein Axiallager")).click()
    page.locator(".small", has_text="Maßgebender Nachweis").wait_for()
    page.get_by_role("button", name="US-Einheiten").click()
    page.locator(".card .number", has_text=" psi").first.wait_for()
    until(page, lambda: '"units":"us"' in page.evaluate("Object.values(sessionStorage).join()"))
    page.get_by_role("combobox", name="Sprache").click()
    page.get_by_role("option", name="Русский").click()
    page.locator(".small", has_text="Определяющая проверка").wait_for()
    assert page.evaluate("document.documentElement.lang") == "ru"
    page.locator(".card .number", has_text=" psi").first.wait_for()
    page.get_by_role("tab", name="Текст").click()
    page.locator(".cm-line", has_text="kind: thrust").first.wait_for()

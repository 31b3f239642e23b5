"""The page by keys and for screen readers: what has the focus, its name, how it is seen, and where it goes."""

import pytest
from browsing import IN_BROWSER, NAME, film_thickness, reach, section, tab, take, text_of, until

from babbitt.properties.lubricants import catalogue
from babbitt.properties.materials import bearing_metals

pytestmark = IN_BROWSER

RINGED = """() => {
  const here = document.activeElement;
  const lined = [here, here.closest(".q-field")?.querySelector(".q-field__control"), here.closest(".cm-editor")];
  const line = (style) => [style.outlineStyle, style.outlineWidth].join(" ") === "solid 2px";
  return lined.some((one) => one && line(getComputedStyle(one)))
    || getComputedStyle(here, "::after").borderTopWidth === "2px";
}"""
"""Whether what is focused has a line around it."""

SETTLED = "() => !document.getAnimations().some((one) => one instanceof CSSTransition)"
"""Colours have changed, and what fades in is there."""

SCHEMES = ("light", "dark")


def focused(page):
    return page.evaluate(NAME)


def keeps_focus(page, act):
    """What is focused is drawn anew when one acts, and the new one is focused."""
    name, before = focused(page), page.evaluate_handle("document.activeElement")
    act()
    until(page, lambda: not before.evaluate("control => control.isConnected"))
    until(page, lambda: focused(page) == name)


def serious(page):
    scanner = pytest.importorskip("axe_playwright_python.sync_playwright", reason="axe-core is not installed")
    page.wait_for_function(SETTLED)
    return {
        one["id"]: [node["html"][:160] for node in one["nodes"]]
        for one in scanner.Axe().run(page).response["violations"]
        if one["impact"] in ("serious", "critical")
    }


def test_tab_leaves_the_text_of_the_case(page):
    before = text_of(page)
    typed = page.get_by_role("textbox", name="Case as text")
    for key in ("Tab", "Shift+Tab"):
        typed.focus()
        page.keyboard.press(key)
        assert not typed.evaluate("one => one.contains(document.activeElement)")
    assert text_of(page) == before


def test_the_focus_stays_at_what_is_drawn_anew(page):
    reach(page, "Clearance is given")
    keeps_focus(page, lambda: take(page, "limits"))
    reach(page, 'Expand "Method and limits"')
    page.keyboard.press("Enter")
    reach(page, "Method")
    keeps_focus(page, lambda: take(page, "film"))
    reach(page, "Value to vary")
    keeps_focus(page, lambda: page.keyboard.press("Backspace"))
    keeps_focus(page, lambda: page.locator(".more .q-chip__icon--remove").first.click())
    tab(page, "Studies")
    reach(page, "What is asked")
    keeps_focus(page, lambda: take(page, "size"))
    reach(page, "Field that varies")
    keeps_focus(page, lambda: take(page, "speed"))


def test_the_focus_comes_back_to_a_button_when_its_work_is_done(page):
    tab(page, "Studies")
    reach(page, "Run the study")
    page.keyboard.press("Enter")
    page.get_by_text("Study of kind sweep").wait_for()
    until(page, lambda: focused(page) == "Run the study")


def test_the_focus_does_not_come_back_to_whoever_left(page):
    tab(page, "Studies")
    run = page.get_by_role("button", name="Run the study")
    run.click()
    page.get_by_role("heading", name="Babbitt").click()
    page.get_by_text("Study of kind sweep").wait_for()
    until(page, run.is_enabled)
    assert focused(page) != "Run the study"


@pytest.mark.parametrize("scheme", SCHEMES)
def test_what_has_the_focus_has_a_line_around_it(page, scheme):
    page.emulate_media(color_scheme=scheme)
    bare, names = [], []
    for _ in range(100):
        page.keyboard.press("Tab")
        if page.evaluate("document.activeElement === document.body"):
            break
        names.append(focused(page))
        if not page.evaluate(RINGED):
            bare.append(names[-1])
    assert {"New", "SI units", "Form", "Diameter", "Vary a value", "load"} <= set(names)
    assert bare == []


def test_a_slider_has_its_name_where_keys_move_it_and_goes_to_its_ends(page):
    before = film_thickness(page)
    slider = page.get_by_role("slider", name="load")
    slider.focus()
    assert slider.get_attribute("aria-valuetext") == "12 kN"
    for key, end in (("Home", "6"), ("End", "24")):
        page.keyboard.press(key)
        until(page, lambda end=end: slider.get_attribute("aria-valuetext") == f"{end} kN")
        until(page, lambda end=end: slider.get_attribute("aria-valuenow") == end)
    until(page, lambda: film_thickness(page) < before)


def test_a_wrong_field_says_so_and_its_help_does_not_hide_why(page):
    reach(page, "Diameter")
    diameter = page.get_by_label("Diameter", exact=True)
    diameter.fill("12 kg")
    until(page, lambda: diameter.get_attribute("aria-invalid") == "true")
    said = page.locator(f"id={diameter.get_attribute('aria-describedby')}")
    assert "is a mass" in said.inner_text()
    page.locator(".q-tooltip").wait_for()
    page.wait_for_function(SETTLED)
    help_box, field = page.locator(".q-tooltip").bounding_box(), diameter.bounding_box()
    assert help_box["y"] + help_box["height"] <= field["y"]
    diameter.fill("120")
    until(page, lambda: diameter.get_attribute("aria-invalid") is None)


@pytest.mark.parametrize("scheme", SCHEMES)
def test_the_text_messages_and_help_can_be_read(page, scheme):
    """No serious finding of axe-core, contrast among them."""
    page.emulate_media(color_scheme=scheme)
    diameter = page.get_by_label("Diameter", exact=True)
    reach(page, "Diameter")
    diameter.fill("12 kg")
    until(page, lambda: diameter.get_attribute("aria-invalid") == "true")
    page.locator(".q-tooltip").wait_for()
    assert serious(page) == {}
    text_of(page)
    page.locator(".cm-line span").first.wait_for()
    assert serious(page) == {}


@pytest.mark.parametrize(
    ("link", "wanted"),
    [("the form", "form"), ("the answer", "results"), ("the tabs below", "more"), ("the tool bar", "tools")],
)
def test_links_that_skip_leave_the_address_alone(page, link, wanted):
    page.get_by_label("Diameter", exact=True).fill("12 kg")  # there as well
    page.locator(".answer .fault").wait_for()
    page.get_by_label("Copy a link to this case").click()
    until(page, lambda: "#case=" in page.evaluate("location.href"))
    address = page.evaluate("location.href")
    page.locator("a.skip", has_text=link).first.focus()
    page.keyboard.press("Enter")
    assert page.evaluate("document.activeElement.id") == wanted
    assert page.evaluate("location.href") == address


def test_the_form_stands_before_the_tabs_on_a_telephone(page):
    page.set_viewport_size({"width": 390, "height": 844})
    tops = [page.locator(f"section.{one}").bounding_box()["y"] for one in ("answer", "bearing", "case", "more")]
    assert tops == sorted(tops)


def test_a_wide_table_is_moved_within_the_window(page):
    tab(page, "Methods side by side")
    page.get_by_role("button", name="Compare the methods").click()
    box = page.locator(".more .results .q-table__middle").first
    box.wait_for()
    assert box.bounding_box()["height"] < 900  # of the window
    head, name = box.locator("th").first, box.locator("tbody td").first
    before, left = head.bounding_box(), name.bounding_box()["x"]
    box.evaluate("one => { one.scrollTop = 200; one.scrollLeft = 150; }")
    assert box.evaluate("one => [one.scrollTop, one.scrollLeft]") == [200, 150]
    assert head.bounding_box() == before
    assert name.bounding_box()["x"] == left


def test_fields_of_oils_and_metals_offer_names(page):
    section(page, "Oil")
    section(page, "Materials and surfaces")
    for label, names in (("Lubricant", catalogue()), ("Bearing metal", bearing_metals())):
        field = page.get_by_label(label, exact=True)
        offered = field.evaluate("one => [...one.list.options].map((name) => name.value)")
        assert offered == [one.name for one in names]
    page.get_by_label("Lubricant", exact=True).hover()
    page.locator(".q-tooltip", has_text="ISO VG 46").wait_for()

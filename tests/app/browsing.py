"""What tests of the page in a browser share."""

import re
import shutil

import pytest

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
LONG = 120_000
"""Milliseconds: a loaded machine is slow, and no test depends on the clock."""

IN_BROWSER = [
    pytest.mark.slow,
    pytest.mark.thorough,
    pytest.mark.skipif(BROWSER is None, reason="no Chromium among the programs of the system"),
]
"""Marks of these tests."""


MOST_STEPS = 200
"""Presses of a key within which everything is to be reached."""

NAME = """() => {
  const here = document.activeElement, copy = here.cloneNode(true);
  copy.querySelectorAll("i").forEach((icon) => icon.remove());
  return (here.getAttribute("aria-label") || here.labels?.[0]?.innerText || copy.textContent).trim();
}"""
"""What is focused, by its name."""

MARKED = "() => document.querySelector('.q-menu .q-manual-focusable--focused')?.innerText ?? ''"
"""The option that the arrow keys have come to."""


def film_thickness(page):
    """Of the card, in µm."""
    said = page.locator(".card", has_text="Minimum film thickness").first.inner_text()
    return float(re.search(r"= ([\d.]+) µm", said).group(1))


def until(page, condition):
    """Wait until something holds on the page."""
    for _ in range(600):
        if condition():
            return
        page.wait_for_timeout(100)
    raise AssertionError("did not come about")


def section(page, heading):
    page.locator(".section", has_text=heading).locator(".q-expansion-item__container > .q-item").first.click()


def text_of(page):
    page.get_by_role("tab", name="Text").click()
    page.wait_for_selector(".cm-line")  # the lines that are seen; the editor knows all
    return page.evaluate("document.querySelector('.cm-content').cmView.view.state.doc.toString()")


def tab(page, name):
    page.get_by_role("tab", name=name, exact=True).click()


def opened(page, text):
    """Put a case on the page through its file button."""
    page.locator("input[type=file]").set_input_files(
        {"name": "case.yaml", "mimeType": "text/yaml", "buffer": text.encode()}
    )
    page.wait_for_selector(".verdict")


def press_until(page, key, reached):
    for _ in range(MOST_STEPS):
        page.keyboard.press(key)
        if reached():
            return
        page.wait_for_timeout(50)
    raise AssertionError(f"{key} does not lead there")


def reach(page, name):
    press_until(page, "Tab", lambda: page.evaluate(NAME) == name)


def option(page, name, wanted):
    reach(page, name)
    take(page, wanted)


def take(page, wanted):
    """An option of the list that is focused."""
    page.keyboard.press("Enter")
    page.wait_for_selector(".q-menu [role=option]")
    press_until(page, "ArrowDown", lambda: page.evaluate(MARKED).startswith(wanted))
    page.keyboard.press("Enter")

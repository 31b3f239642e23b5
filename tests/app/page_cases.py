"""Cases for the tests of the page."""

from babbitt.app.document import CaseDocument
from babbitt.core.kind import kinds

TEMPLATES = {name: kind.read_template() for name, kind in kinds().items()}
JOURNAL = TEMPLATES["journal"]


def changed(text, **fields):
    document = CaseDocument(text)
    for name, value in fields.items():
        document.change((name,), value)
    return document.text


FILM = changed(
    JOURNAL,
    method={"kind": "film", "accuracy": "draft"},
    supply_element=None,
    grooves=[{"angle": f"{angle} deg", "extent": "20 deg"} for angle in (0, 180)],
)

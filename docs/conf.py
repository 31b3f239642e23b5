"""Sphinx configuration. `make docs` builds docs/_build/html; no step needs the network."""

import os
import sys
from pathlib import Path

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE / "_ext"))
# the tutorials call `babbitt` of this environment
os.environ["PATH"] = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"

from babbitt_pages.facts import facts  # noqa: E402 - the folder must be on the path first

import babbitt  # noqa: E402

project = "Babbitt"
author = copyright = "The Babbitt developers"
version = release = babbitt.__version__

extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "numpydoc",
    "babbitt_pages",
]
source_suffix = {".md": "myst-nb"}
# pages of _generated that other pages include; the validation pages there stand for themselves
exclude_patterns = ["_build", "_generated/parts"]
default_role = "py:obj"

myst_enable_extensions = ["dollarmath", "deflist", "colon_fence", "substitution", "attrs_inline"]
myst_substitutions = facts()
myst_heading_anchors = 3

autosummary_generate = False  # numpydoc brings the extension; no page uses it
toc_object_entries_show_parents = "hide"
autodoc_member_order = "bysource"
autodoc_typehints = "none"  # the docstrings say types and units
autodoc_default_options = {"members": True, "exclude-members": "model_config"}
numpydoc_show_class_members = False
numpydoc_xref_param_type = False

# tutorials are run when their code changed; what they print is kept below _build
nb_execution_mode = "cache"
nb_execution_in_temp = True
nb_execution_raise_on_error = True
nb_execution_timeout = 120
nb_merge_streams = True

html_math_renderer = "mathml"
html_theme = "pydata_sphinx_theme"
html_title = f"Babbitt {release}"
html_static_path = ["_static"]
html_css_files = ["babbitt.css"]
html_show_sourcelink = False
html_copy_source = False
html_theme_options = {
    "logo": {"text": "Babbitt"},
    "navigation_depth": 2,
    "show_toc_level": 2,
    "show_nav_level": 1,
    "header_links_before_dropdown": 6,
    "navbar_align": "left",
    "navbar_end": ["theme-switcher"],
    "footer_start": ["copyright"],
    "footer_end": [],
}
# pages without neighbours in their section need no section navigation
html_sidebars = {page: [] for page in ("index", "start", "choose", "conventions", "changelog", "developing")}

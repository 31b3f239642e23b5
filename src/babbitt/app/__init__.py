"""The workbench in the browser: a case as a form and as text, its drawing and its answer while it is changed."""

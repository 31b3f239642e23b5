"""Statics of a gear shaft with an overhung coupling: what its bearings have to carry."""

from babbitt.core.kind import Kind

KINDS = (
    Kind(
        name="overhung_coupling",
        description="load share of two bearings with an overhung coupling",
        model="babbitt.kinds.coupling.case.overhung_coupling:OverhungCouplingCase",
        template="babbitt.kinds.coupling:overhung_coupling.yaml",
        views={"statics": "babbitt.kinds.coupling.view:STATICS"},
    ),
)

"""Plane slider bearing of infinite width: the smallest kind, one folder and one registration."""

from babbitt.core.kind import Kind

KIND = Kind(
    name="plane_slider",
    description="plane slider bearing of infinite width",
    model="plane_slider.case:PlaneSliderCase",
    template="plane_slider:plane_slider.yaml",
    views={"closed_form": "plane_slider.view:CLOSED_FORM", "quadrature": "plane_slider.view:QUADRATURE"},
    quantities="plane_slider.view:QUANTITIES",
    words="plane_slider",
)

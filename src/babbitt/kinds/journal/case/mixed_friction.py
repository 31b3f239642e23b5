"""Asperities that touch where the film is thin: what a case gives of them, and what is assumed."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated, ClassVar

from pydantic import Field

from babbitt.case.error_messages import Path
from babbitt.case.part import Issue, Part
from babbitt.case.parts.materials import Materials, Structure
from babbitt.case.parts.surfaces import SurfacesInput
from babbitt.core.units import si
from babbitt.design.asperity_contact import AsperityContact, composite_modulus, composite_roughness
from babbitt.properties.materials import structural_material
from babbitt.properties.materials.elasticity import assumed_elasticity

__all__ = ["Asperities", "MixedFrictionInput", "asperities_of", "issues_of"]


class MixedFrictionInput(Part):
    """Contact of asperities after Greenwood and Tripp, for the Stribeck curve with its mixed branch."""

    example: ClassVar[str] = "{boundary_friction: 0.1}"

    boundary_friction: Annotated[float, si("1", "0.001", "1")] = Field(
        0.1, description="Friction coefficient where asperities touch. 0.1 is an assumption."
    )
    composite_roughness: Annotated[float, si("m", "0.01 um", "100 um")] | None = Field(
        None,
        description="Rms roughness of both surfaces together, sigma. sqrt(Rz_B^2 + Rz_J^2)/5 of surfaces if not "
        "given; Rz/Rq = 5 is an assumption.",
    )
    asperity_density: Annotated[float, si("1", "0.001", "1")] = Field(
        0.04, description="Asperities per area times radius of their tips times sigma. 0.04 is an assumption."
    )
    asperity_sharpness: Annotated[float, si("1", "1e-6", "1")] = Field(
        0.001, description="Sigma over the radius of the tips. 0.001 is an assumption."
    )
    contact_modulus: Annotated[float, si("Pa", "0.1 GPa", "1000 GPa")] | None = Field(
        None,
        description="1/((1 - nu1^2)/E1 + (1 - nu2^2)/E2) of both surfaces. Of journal and bearing metal (without "
        "one, of the shell) if not given.",
    )


@dataclass(frozen=True)
class Asperities:
    """Contact of a case, and what was assumed for it."""

    contact: AsperityContact
    assumptions: tuple[str, ...]


def issues_of(
    given: MixedFrictionInput, surfaces: SurfacesInput | None, materials: Materials | None, path: Path
) -> Iterator[Issue]:
    """Complain where roughness or modulus are neither given nor follow."""
    at: Path = (*path, "mixed_friction")
    if given.composite_roughness is None:
        if surfaces is None:
            yield Issue((*at, "composite_roughness"), "is missing", "a length, or surfaces with their roughness",
                        code="E003")  # fmt: skip
        elif surfaces.roughness_bearing + surfaces.roughness_journal <= 0.0:
            yield Issue((*at, "composite_roughness"), "both surfaces are without roughness", "a length above zero")
    if given.contact_modulus is None and (_of_journal(materials) is None or _of_bearing(materials) is None):
        allowed = "a modulus such as '45 GPa', or names of the catalogue for materials.journal and bearing_metal"
        yield Issue((*at, "contact_modulus"), "is missing", allowed, code="E003")


def asperities_of(given: MixedFrictionInput, surfaces: SurfacesInput | None, materials: Materials) -> Asperities:
    """Make the contact of a validated case."""
    roughness, modulus, assumed = given.composite_roughness, given.contact_modulus, []
    if roughness is None and surfaces is not None:
        roughness = composite_roughness(surfaces.roughness_bearing, surfaces.roughness_journal)
        assumed.append(
            f"Composite rms roughness of {1e6 * roughness:.3g} µm from the heights Rz of both surfaces by Rz/Rq = "
            "5 (assumption: turned and ground surfaces have about 4 to 6)."
        )
    journal, bearing = _of_journal(materials), _of_bearing(materials)
    if modulus is None and journal is not None and bearing is not None:
        modulus = composite_modulus(journal[0], bearing[0])
        assumed.append(f"Moduli of the asperities: journal {journal[1]}, bearing {bearing[1]}.")
    if roughness is None or modulus is None:
        raise ValueError("a case that was not validated: asperities without roughness or modulus")
    contact = AsperityContact(
        roughness, modulus, given.asperity_density, given.asperity_sharpness, given.boundary_friction
    )
    by_name = ", ".join(
        f"{name.replace('_', ' ')} {getattr(given, name):g}"
        for name in ("asperity_density", "asperity_sharpness", "boundary_friction")
        if name not in given.model_fields_set
    )
    if by_name:
        assumed.append(f"Asperities with {by_name} (assumptions).")
    return Asperities(contact, tuple(assumed))


Elasticity = tuple[tuple[float, float], str]
"""Modulus in Pa and Poisson's ratio, and where they come from."""


def _of_journal(materials: Materials | None) -> Elasticity | None:
    return None if materials is None else _of_structure(materials.journal)


def _of_bearing(materials: Materials | None) -> Elasticity | None:
    """Of the bearing metal; of the shell where none is given."""
    if materials is None:
        return None
    metal = materials.metal()
    if metal is None:
        return _of_structure(materials.bearing)
    known = assumed_elasticity(metal.family)
    if known is None:
        return None
    return known, f"{1e-9 * known[0]:.3g} GPa as of a metal of the {metal.family.value} family (assumption)"


def _of_structure(structure: Structure | None) -> Elasticity | None:
    if structure is None or structure.name is None:
        return None
    known = structural_material(structure.name)
    return (known.elastic_modulus, known.poisson_ratio), f"{1e-9 * known.elastic_modulus:.4g} GPa of {known.name}"

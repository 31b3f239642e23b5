"""The claims of the study behind pump_footstep.yaml, beside what its equations give for both steady states."""

from babbitt.validation.published.screw_heel_claims import claims_table

print(claims_table())

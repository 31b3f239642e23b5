"""Axial dynamics of a shaft line on its thrust bearing: propeller, elastic shaft, collar, pads, ring, seating."""

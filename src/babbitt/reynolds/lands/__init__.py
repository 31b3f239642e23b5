"""Films of lands between grooves, alike along the width: kernels, equilibrium, batches."""

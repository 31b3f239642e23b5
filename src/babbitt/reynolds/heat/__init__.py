"""Films with their own temperatures: energy equation, walls, continuation."""

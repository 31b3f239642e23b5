"""The oil of a machine: pump, header and a line to each bearing, in balance with what the films take."""

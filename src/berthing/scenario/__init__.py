"""What the user asks for: vehicles, structures, limits, goals, and the files that hold them."""

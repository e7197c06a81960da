"""Blocks of the file to the domain: what needs a second key, a dimension or a name elsewhere."""

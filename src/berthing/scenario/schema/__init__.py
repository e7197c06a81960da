"""The scenario file as pydantic sees it: types and ranges, nothing that needs a second key."""

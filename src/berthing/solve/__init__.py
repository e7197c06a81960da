"""The one call of the NLP solver."""

"""Controls as flight computers fly them: constant or linear from sample to sample."""

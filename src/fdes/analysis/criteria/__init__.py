"""Criteria of flying qualities: each file judges one mode, from what was measured on a linear model."""

"""Integrators: Butcher tableaux, one file each, each with its order and its reference."""

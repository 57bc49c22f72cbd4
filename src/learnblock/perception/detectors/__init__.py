"""Detectors, which search images."""

"""Grading a class: every program in every variant of a step's world, on one computer or on many.

Fixed rules count which checks a program meets. The teacher decides what that is worth.
"""

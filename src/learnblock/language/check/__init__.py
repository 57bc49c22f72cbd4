"""Check a program for errors and likely mistakes."""

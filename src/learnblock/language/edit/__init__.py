"""Edit programs: rename, add imports, extract functions."""

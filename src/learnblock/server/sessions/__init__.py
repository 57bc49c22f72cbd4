"""Open projects, each shared by every page that shows it."""

"""Projects that are open, each shared by every page that shows it."""

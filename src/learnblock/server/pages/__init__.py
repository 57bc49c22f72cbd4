"""A connected page, and the handlers of its messages: one module per subject."""

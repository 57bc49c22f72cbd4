"""A connected page, and the handlers of its messages: one module for each subject."""

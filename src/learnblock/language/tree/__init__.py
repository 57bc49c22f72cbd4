"""The syntax tree that the three notations share, and what they need to read and write it."""

"""Read and write Python, with ast and tokenize of the standard library."""

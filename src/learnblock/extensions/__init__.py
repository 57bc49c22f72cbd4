"""Custom blocks and libraries: made, checked, saved and installed; none of their code is run."""

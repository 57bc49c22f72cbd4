"""What is known of a run: what happened in it, and by how much it missed its goals."""

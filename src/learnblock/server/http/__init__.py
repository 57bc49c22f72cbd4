"""What the server answers to plain requests, and who may send them."""

"""A page that is connected: what it says and is told, and a module for each sort of request."""

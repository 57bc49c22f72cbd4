"""Plain HTTP requests: the responses, and who may send requests."""

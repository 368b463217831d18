"""A calculation as an engineer writes it."""

"""The formats a result is printed in."""

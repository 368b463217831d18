"""From a wanted quantity back to one parameter."""

"""From requirements to the Pareto front of everything that meets them."""

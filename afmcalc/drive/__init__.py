"""Simulation of the drive over time: one stick-slip law for a single event and for thousands of drives at once."""

"""The torque when making and service scatter."""

"""What the torque law neglects."""

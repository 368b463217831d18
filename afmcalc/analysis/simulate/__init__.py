"""The drive in time: what happens when the clutch trips."""

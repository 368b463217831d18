"""The clutch in time: one law of what sticks and slips, asked by one event and by ten thousand drives at once."""

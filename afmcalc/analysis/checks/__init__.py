"""Every limit a design is held against."""

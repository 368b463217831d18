"""Heat and wear of a trip."""

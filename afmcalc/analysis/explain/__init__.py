"""Explanations: a calculation as steps with formulas; errors and warnings with the changes that clear them."""

"""Springs one can buy: which give the forces and stiffnesses of a clutch."""

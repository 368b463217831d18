"""What is asked of a clutch: each analysis a function ``(clutch, …) → Result``."""

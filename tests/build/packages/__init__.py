"""How each package is used: one module for each."""

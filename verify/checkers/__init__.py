"""What judges a theorem: certificates by two checkers, samples at 50 digits, mutants, and the grade."""

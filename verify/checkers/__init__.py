"""What judges a theorem: certificates, samples at 50 digits, mutants, and the grade."""

"""What a release says of itself, and what moved since the one before."""

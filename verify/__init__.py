"""What is checked: the proofs, 50-digit references, the printed kernels; accuracy, stability and time."""

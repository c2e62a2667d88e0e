"""How accurate the float64 programs are: certified bounds, exact errors against 50 digits, and where they come from."""

"""Evidence: the records of long runs, the code that each was made by, and its age."""

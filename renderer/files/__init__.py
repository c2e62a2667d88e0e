"""What is drawn, in files: pictures and tables, and pictures larger than memory."""

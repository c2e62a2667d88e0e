"""Files of pictures, also of pictures larger than memory, and the record of how each was drawn."""

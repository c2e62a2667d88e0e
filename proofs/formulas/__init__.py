"""What is true of the picture: every formula of the chapter, as straight-line programs."""

"""The chapter's figures: one file a figure or family, drawn by `python -m book figures`."""

"""What a picture's file shows."""

import numpy as np
from PIL import Image

from renderer.picture import views


def shows(path, frame):
    """Return whether a file shows a frame: its numbers, or its bytes for the eye."""
    if path.suffix.lower() in (".npy", ".npz"):
        kept = np.load(path)
        return np.array_equal(kept["rgb"] if path.suffix == ".npz" else kept, frame.rgb)
    return np.array_equal(np.asarray(Image.open(path)), views.image_view(frame))

"""Contents of a folder."""


def contents(folder):
    """Return {name: bytes} of a folder's files."""
    return {path.name: path.read_bytes() for path in folder.iterdir()}

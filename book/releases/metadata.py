"""Metadata for a package index: README as it stands, but for links, which lead to the repository that has the files."""

import re
from pathlib import Path

import yaml
from hatchling.metadata.plugin.interface import MetadataHookInterface

TO_A_FILE = re.compile(r"(!?)\[([^]]*)]\(([^):#]+)\)")


def shown(readme: str, url: str) -> str:
    """Return README with absolute links; without a repository, a link is its words, and a picture is left out."""

    def absolute(link):
        picture, words, path = link.groups()
        if not url:
            return "" if picture else words
        return f"{picture}[{words}]({url}/{'raw' if picture else 'blob'}/HEAD/{path})"

    return TO_A_FILE.sub(absolute, readme)


class RepositoryMetadata(MetadataHookInterface):
    """Hatch's hook: the fields that depend on `repository.url` of `book/_config.yml`."""

    def update(self, metadata: dict) -> None:
        root = Path(self.root)
        config = yaml.safe_load((root / "book" / "_config.yml").read_text(encoding="utf-8"))
        url = config["repository"]["url"].removesuffix("/").removesuffix(".git")
        readme = (root / "README.md").read_text(encoding="utf-8")
        metadata["readme"] = {"content-type": "text/markdown", "text": shown(readme, url)}
        if url:
            metadata["urls"] = {"Repository": url, "Changelog": f"{url}/blob/HEAD/CHANGELOG.md"}

"""The whole chapter in one HTML file that can be mailed: joined from the built site's pages, nothing fetched.

`python -m book single` writes it. Names inside it are those of the site; where several pages use one id, each is
called PAGE:ID (`s3:notes`). A page without a section of its own, such as a source's listing, is called by its
address without `.html` (`source/proofs/engine/kernel.py`), and its line 12 is `source/proofs/engine/kernel.py:L-12`.
"""

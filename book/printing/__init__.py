"""The chapter for paper: the site's pages in their order, unfolded, printed to PDF by the installed Chromium.

`python -m book pdf` writes it. The simulator gives way to the figures of its page; the listings of sources and the
reference of the interface stay where they can be searched, in the site and in the single file.
"""

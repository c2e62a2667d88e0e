"""The book: the chapter's pages, figures and the machinery that builds them into a site."""

"""Claims, their translation, certificates, the kernel that checks these, and the search that finds them."""

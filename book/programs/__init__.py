"""Programs of the pages' interactives, as WebAssembly with the renderer's kernels: simulator, loupe, ideas."""

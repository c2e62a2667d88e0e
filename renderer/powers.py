"""Whole powers of a row of unit complex numbers, by repeated squaring: the algebraic form's only work."""

from renderer.kernels import compiled, complex_product_row, complex_square_row, complex_square_twice_row, pixels


@compiled
def powers_of_angles(cosine, sine, orientation, exponent, real, imaginary, other_real, other_imaginary, count):
    """Write (orientation · (cosine + i sine))^exponent; a negative exponent conjugates. The other rows are used up."""
    reflection = orientation if exponent >= 0 else -orientation
    remaining = abs(exponent)
    if remaining == 0:
        for i in pixels(0, count):
            real[i], imaginary[i] = 1.0, 0.0
        return
    for i in pixels(0, count):
        real[i], imaginary[i] = orientation * cosine[i], reflection * sine[i]
    while not remaining & 3:
        complex_square_twice_row(real, imaginary, 0, count)
        remaining >>= 2
    while not remaining & 1:
        complex_square_row(real, imaginary, 0, count)
        remaining >>= 1
    if remaining == 1:
        return
    for i in pixels(0, count):
        other_real[i], other_imaginary[i] = real[i], imaginary[i]
    remaining >>= 1
    while remaining:
        complex_square_row(other_real, other_imaginary, 0, count)
        if remaining & 1:
            complex_product_row(real, imaginary, other_real, other_imaginary, 0, count)
        remaining >>= 1

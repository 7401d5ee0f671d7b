"""Chebyshev series: the polynomials at given places, the sum of a series, and the series of its slope."""

import numpy as np


def chebvander(z, degree):
    """Chebyshev's polynomials at places, as NumPy's, without its care for every kind of argument."""
    z = np.asarray(z, dtype=float)
    found = np.empty((degree + 1, *z.shape))
    found[0] = 1.0
    if degree > 0:
        found[1] = z
        twice = 2.0 * z
        for k in range(2, degree + 1):
            np.multiply(twice, found[k - 1], out=found[k])
            found[k] -= found[k - 2]
    return np.moveaxis(found, 0, -1) if z.ndim != 1 else found.T


def chebval(z, coefficients):
    """A series of them, by Clenshaw's sum."""
    z = np.asarray(z, dtype=float)
    twice, first, second = 2.0 * z, np.zeros_like(z), np.zeros_like(z)
    for coefficient in coefficients[:0:-1]:
        first, second = twice * first - second + coefficient, first
    return z * first - second + coefficients[0]


def chebder(coefficients):
    """The series of its slope."""
    count = len(coefficients)
    slope = np.zeros(max(count - 1, 1))
    for k in range(count - 1, 0, -1):
        slope[k - 1] = 2.0 * k * coefficients[k] + (slope[k + 1] if k + 1 < count - 1 else 0.0)
    slope[0] *= 0.5
    return slope

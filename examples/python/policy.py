"""The network of cca::policy in numpy."""
import numpy


def tangent(x):
    """The activation `tanh` of cca::policy (cca/mapping/network/feed_forward.hpp): a fraction within 7e-6 of the tangent."""
    x = numpy.clip(x, -6.2972, 6.2972)
    s = x * x
    return x * ((((s + 990) * s + 135135) * s + 4729725) * s + 34459425) / ((((45 * s + 13860) * s + 945945) * s + 16216200) * s + 34459425)


def answer(layers, observations):
    """One row of numbers for each row of observations. `layers`: [(matrix, bias), ...]; with a matrix for each row, each has weights of its own."""
    x = observations
    for i, (matrix, bias) in enumerate(layers):
        x = (matrix @ x[:, :, None])[:, :, 0] + bias
        if i + 1 < len(layers):
            x = tangent(x)
    return x

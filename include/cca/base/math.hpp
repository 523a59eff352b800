// The elementary functions, cca::math: code that a beat inlines, with the same bits from every compiler, at
// every level of optimisation and on every machine with IEEE 754 doubles. docs/math.md has the figures.
#pragma once

#include <cca/base/math/angles.hpp>
#include <cca/base/math/arcs.hpp>
#include <cca/base/math/exponentials.hpp>
#include <cca/base/math/floats.hpp>
#include <cca/base/math/logarithms.hpp>
#include <cca/base/math/roots.hpp>
#ifdef CCA_SAME_BITS  // by CMake's target cca::same_bits
#include <cca/base/math/same_bits.hpp>
#endif

// The former path of cca/base/math/positive_matrix.hpp, symmetric positive matrices, which says what NaN
// does.
#pragma once

#include <cca/base/math/positive_matrix.hpp>

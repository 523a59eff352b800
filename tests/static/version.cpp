// The header's version equals the one that CMake reads from it.
#include <cca/version.hpp>

static_assert(cca::version_major == EXPECTED_MAJOR);
static_assert(cca::version_minor == EXPECTED_MINOR);
static_assert(cca::version_patch == EXPECTED_PATCH);

// CMake reads the version from the header.
#include <cca/version.hpp>

static_assert(cca::version_major == EXPECTED_MAJOR);
static_assert(cca::version_minor == EXPECTED_MINOR);
static_assert(cca::version_patch == EXPECTED_PATCH);

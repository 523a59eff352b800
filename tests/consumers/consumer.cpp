// A user's program in one file: two axes, a sample, read by axis.
#include <cca/space/sample.hpp>
#include <cca/version.hpp>

int main() { return cca::version_major == 0 ? 0 : 1; }

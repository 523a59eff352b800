// Parameters from a TOML file and back: with this header a controller's `load("trot.toml")` and
// `save("trot.toml")` work. It is apart from <cca/cca.hpp> because it needs toml++, which takes about a
// second to compile: the CMake target cca::config compiles it once for a project. Example:
// docs/parameters.md.
#pragma once

#include <cca/config/files.hpp>

// Parameters from a TOML file and back: with this header a controller's `load("trot.toml")` and
// `save("trot.toml")` work. It is apart from <cca/cca.hpp> because it includes toml++, which takes about a
// second to compile. Example: docs/parameters.md.
#pragma once

#include <cca/config/files.hpp>

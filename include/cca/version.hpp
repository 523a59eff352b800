// The library's version, the only place where it is written: CMakeLists.txt reads it from here, and what
// programs, packages and cca-new say follows. CHANGELOG.md has a section for it (tests/scripts/version.py).
#pragma once

namespace cca {

inline constexpr int version_major = 0;
inline constexpr int version_minor = 2;
inline constexpr int version_patch = 0;

}  // namespace cca

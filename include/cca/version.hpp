// The library's version, the only place where it is written: CMakeLists.txt reads it from here.
#pragma once

namespace cca {

inline constexpr int version_major = 0;
inline constexpr int version_minor = 1;
inline constexpr int version_patch = 0;

}  // namespace cca

// EXPECT: compiler\.too_old: cca needs (clang 17 or later, since clang 16 crashes on it; clang 19 is tested|g\+\+ 12 or later; g\+\+ 12 is tested)
// FLAGS: -w
// ERRORS: 2
// Here the mistake is an older compiler, as its version says.
#if CCA_REJECT
#if defined(__clang__)
#undef __clang_major__
#define __clang_major__ 16
#else
#undef __GNUC__
#define __GNUC__ 11
#endif
#endif
#include <cca/base/compiler.hpp>

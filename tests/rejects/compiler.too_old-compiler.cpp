// EXPECT: compiler\.too_old: cca needs (clang 17 or later, since clang 16 crashes on it; clang 19 is tested|g\+\+ 12 or later; g\+\+ 12 is tested)
// FLAGS: -U__GNUC__ -D__GNUC__=11 -U__clang_major__ -D__clang_major__=16
// ERRORS: 2
// Here the mistake is an older compiler, as its version says.
#include <cca/base/compiler.hpp>

#if CCA_REJECT
// compiled with g++ 11, or with clang 16
#else
// compiled with g++ 12, or with clang 19
#endif

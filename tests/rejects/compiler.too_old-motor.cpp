// EXPECT: compiler\.too_old: cca is written in C\+\+20: compile with -std=c\+\+20 or later
// FLAGS: -std=c++17
// ERRORS: 2
// The same if another header of cca comes first.
#include <cca/robot/body.hpp>

#if CCA_REJECT
// compiled with -std=c++17
#else
// compiled with -std=c++20
#endif

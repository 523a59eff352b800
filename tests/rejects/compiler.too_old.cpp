// EXPECT: compiler\.too_old: cca is written in C\+\+20: compile with -std=c\+\+20 or later
// FLAGS: -std=c++17
// ERRORS: 2
// Here the mistake is in the command line: -std=c++17.
#include <cca/cca.hpp>

#if CCA_REJECT
// compiled with -std=c++17
#else
// compiled with -std=c++20
#endif

// EXPECT: drive\.bad_number: the number of RS04 is 5, and it answers to host 5: a RobStride has a number from 1 to 127, and its host another one
// One id would be both its command and its answer.
#include <cca/hardware/robstride.hpp>

#if CCA_REJECT
using hip = cca::hardware::robstride<cca::hardware::rs04, 5, 5>;
#else
using hip = cca::hardware::robstride<cca::hardware::rs04, 127, 5>;
#endif

auto off = hip::disable();

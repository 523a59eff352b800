// EXPECT: drive\.bad_number: the number of AK60-6 is 16, and that of a Damiao is at most 15, since it stands in the first byte of its replies
// A Damiao has four bits for its number, because the others of that byte are its state.
#include <cca/hardware/mit.hpp>

#if CCA_REJECT
using hip = cca::hardware::mit_drive<cca::hardware::ak60_6, 16, 0, cca::hardware::mit_firmware::damiao>;
#else
using hip = cca::hardware::mit_drive<cca::hardware::ak60_6, 16>;
#endif

auto off = hip::disable();

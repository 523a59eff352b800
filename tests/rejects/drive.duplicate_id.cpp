// EXPECT: drive\.duplicate_id: on the bus `left` the drives 1 \(AK80-9\) and 3 \(AK60-6\) both use the id 0x001
// Each drive of a bus has its own id: two drives that share one would both follow the commands for one of
// them.
#include <cca/hardware/bus_plan.hpp>
#include <cca/hardware/mit.hpp>

using hip = cca::hardware::mit_drive<cca::hardware::ak80_9, 1>;
using knee = cca::hardware::mit_drive<cca::hardware::ak80_9, 2>;
#if CCA_REJECT
using ankle = cca::hardware::mit_drive<cca::hardware::ak60_6, 1>;
#else
using ankle = cca::hardware::mit_drive<cca::hardware::ak60_6, 3>;
#endif

struct left
    : cca::hardware::
          can_bus_plan<"left", cca::hardware::bit_rates{1'000'000}, cca::rate<1000>, hip, knee, ankle> {};

double used = left::load;

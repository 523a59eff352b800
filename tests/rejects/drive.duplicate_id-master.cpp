// EXPECT: drive\.duplicate_id: on the bus `left` the drives 1 \(AK80-9\) and 2 \(DM4310\) both use the id 0x000: what one answers would be taken for an answer of the other; give
// Drives may answer under one id if their first byte tells them apart. The number of a Damiao is in half of
// that byte: 15h, the number of the AK here, is also the Damiao 5 that reports that it is enabled.
#include <cca/hardware/bus_plan.hpp>
#include <cca/hardware/mit.hpp>

struct dm4310 {
  static constexpr std::string_view name = "DM4310";
  static constexpr auto limits = cca::hardware::detail::mit_ranges(30, 10);
};
#if CCA_REJECT
using hip = cca::hardware::mit_drive<cca::hardware::ak80_9, 0x15>;
#else
using hip = cca::hardware::mit_drive<cca::hardware::ak80_9, 0x16>;
#endif
using knee = cca::hardware::mit_drive<dm4310, 5, 0, cca::hardware::mit_firmware::damiao>;

struct left
    : cca::hardware::can_bus_plan<"left", cca::hardware::bit_rates{1'000'000}, cca::rate<400>, hip, knee> {};

double used = left::load;

// Drives, virtual drives and CAN buses.
#include <cstring>

#include <cca/hardware/mit.hpp>
#include <cca/hardware/virtual_mit.hpp>

#include "../laws/can_bus_laws.hpp"
#include "../laws/drive_laws.hpp"
#include "../laws/virtual_drive_laws.hpp"
#include "trials.hpp"

using namespace useless;
using namespace cca::hardware;

namespace {

using real = mit_drive<ak60_6, 9>;

// What a useless codec states of itself is that of a real one.
struct silent_codec {
  static constexpr std::string_view name = "useless";
  static constexpr auto uses = real::uses;
  static constexpr auto limits = real::limits;
  static constexpr drive_watchdog watchdog = real::watchdog;
  static constexpr auto requests = real::requests;
  static constexpr auto replies = real::replies;
  static constexpr auto traffic = real::traffic;
  static set_point_frames set_point(const drive_command&) noexcept { return {}; }
  static bool decode(const can_frame&, drive_report&) noexcept { return false; }
  static drive_frames disable() noexcept { return {}; }
  struct enabling {
    enable_step next(const drive_report&) noexcept { return {}; }
  };
};
struct refusing_codec : silent_codec {
  static set_point_frames set_point(const drive_command&) noexcept { return {{}, false, 0}; }
  static drive_frames disable() noexcept { return real::disable(); }
  struct enabling {
    enable_step next(const drive_report&) noexcept { return {real::disable(), enable_progress::failed}; }
  };
};
// Only its encoder for the cuts is a real one.
struct repeating_codec : silent_codec {
  static set_point_frames set_point(const drive_command& c) noexcept {
    auto asked = real::set_point(c);
    if (!asked.frames.empty()) asked.frames = real::set_point({}).frames;
    return asked;
  }
  static bool decode(const can_frame& f, drive_report& r) noexcept {
    drive_report as_before = r;
    if (!real::decode(f, as_before)) return false;
    r.frames = as_before.frames;
    r.told = as_before.told;
    return true;
  }
  static drive_frames disable() noexcept { return real::disable(); }
  using enabling = real::enabling;
};

// One that only its codec hears.
struct dead : virtual_mit<real> {
  bool hear(const can_frame&, std::int64_t) { return false; }
  drive_command law(std::int64_t) { return {}; }
  drive_frames answer(const drive_motion&) { return {}; }
  bool enabled() const { return false; }
};
struct broken : virtual_mit<real> {
  broken() { fail(2); }
  void clear() { fail(2); }
};
struct stubborn : virtual_mit<real> {  // its first set point for ever
  drive_command law(std::int64_t now) {
    const drive_command wanted = virtual_mit<real>::law(now);
    if (first.stiffness == 0) first = wanted;
    return first;
  }
  drive_command first{};
};
template <class Virtual>
struct rig {
  using drive = Virtual;
  static constexpr std::uint32_t code = 2;
  static constexpr drive_fault fault = drive_fault::over_current, unfed = drive_fault::watchdog;
  static drive_frames no_number() { return {}; }
};

struct bus_end {
  enum class kind { silent, refusing, repeating };
  kind what;
  can_frame* last;
  send_result send(std::span<const can_frame> out) noexcept {
    if (what == kind::refusing) return {0, send_outcome::away};
    if (!out.empty()) *last = out.back();
    return {out.size(), send_outcome::sent};
  }
  std::size_t receive(std::span<received_frame> in) noexcept {
    if (what != kind::repeating || in.empty() || --left < 0) return 0;
    in[0] = {*last, 0};
    return 1;
  }
  bus_state state() const noexcept { return what == kind::refusing ? bus_state::down : bus_state::active; }
  bus_counters counters() const noexcept { return {}; }
  std::uint64_t in_flight() const noexcept { return 0; }
  int left = 100;
};
template <bus_end::kind What>
struct wire {
  static constexpr bool has_fd = true;
  static constexpr std::size_t most_waiting = 16;
  can_frame last{};
  bus_end ends[2]{{What, &last}, {What, &last}};
  bus_end& end(std::size_t i) { return ends[i]; }
  void settle() {}
  void away(std::size_t) {}
  void back(std::size_t) {}
  void blocked(std::size_t) {}
  void unblocked(std::size_t) {}
};

template <class Codec>
void codec() {
  laws::drive<Codec, virtual_mit<real>>();
}

}  // namespace

TEST_CASE("drive") {
  try_model("drive", does_nothing, 3, codec<silent_codec>);
  try_model("drive", refuses, 3, codec<refusing_codec>);
  try_model("drive", repeats, 3, codec<repeating_codec>);
}
TEST_CASE("virtual drive") {
  try_model("virtual drive", does_nothing, 7, laws::virtual_drive<rig<dead>>);
  try_model("virtual drive", refuses, 7, laws::virtual_drive<rig<broken>>);
  try_model("virtual drive", repeats, 4, laws::virtual_drive<rig<stubborn>>);
}
TEST_CASE("bus") {
  try_model("CAN bus", does_nothing, 5, laws::can_bus<wire<bus_end::kind::silent>>);
  try_model("CAN bus", refuses, 5, laws::can_bus<wire<bus_end::kind::refusing>>);
  try_model("CAN bus", repeats, 5, laws::can_bus<wire<bus_end::kind::repeating>>);
}

// A CANopen drive by CiA 402, cyclic synchronous position or torque: its state machine and process data. It
// is no CANopen master.
//
//   struct knee_motor {
//     static constexpr std::string_view name = "EPOS4";
//     static constexpr double counts = 4096, torque = 0.8;
//   };
//   using knee = cca::hardware::cia402<knee_motor, 5, cca::hardware::cia402_mode::torque>;  // node 5
//
// The motor's type states the counts of one turn of its shaft, and its rated torque (object 6076h) in N m; a
// frame has torques in thousandths of that. Configure the drive with another tool, and store it there: mode
// of operation (6060h: 8 or 10), interpolation period (60C2h), reaction to a lost heartbeat (6007h), and this
// mapping, each PDO on SYNC:
//   RPDO1 (200h + node)   6040h:16 control word, 607Ah:32 target position, 6071h:16 target torque
//   TPDO1 (180h + node)   6041h:16 status word, 6064h:32 position, 6077h:16 torque
//   TPDO2 (280h + node)   606Ch:32 velocity, counts/s
// The bus sends canopen_sync() once a cycle, after the set points (`cycle_frames`). A drive boots
// pre-operational; enabling starts it.
//   set_point   NaN and infinity in a number that the mode uses refuse the command. Beyond 32 or 16 bits the
//               number is the end, and `cut` says so
//   decode      process data, emergencies (080h + node), heartbeats (700h + node); a boot-up heartbeat means
//               that the drive is off. A position goes on from 2^31 - 1 to -2^31 and is reported so: where a
//               joint turns that far, use position_unwrap.hpp, 2^32 counts wide
//   enabling    goes by the status word to operation enabled, from the measured position, without torque. A
//               rising edge resets a fault, eight times at most
//   watchdog    the drive's own, of heartbeat (1016h) or SYNC. Set it: without one the drive keeps its last
//               target
// Source: CiA 402-2 as in IEC 61800-7-201; state masks as in drive manuals (see docs/drives.md); classes of
// emergencies: CiA 301, and 82xxh, 86xxh, 8Axxh (switches and ends of the range) as in maxon's EPOS4.
// Not verified: what no manual of a drive says about the standards, since these are not public.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <string_view>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/hardware/drives/cia402_states.hpp>
#include <cca/hardware/drives/drive.hpp>
#include <cca/hardware/drives/wire_number.hpp>
#include <cca/space/quantity.hpp>

namespace cca::hardware {

template <class Type> concept Cia402Motor = requires {
  { Type::name } -> std::convertible_to<std::string_view>;
  requires Type::counts > 0 && Type::torque > 0;
};

namespace detail {
template <class Motor, int Node>
struct no_canopen_node {
  static constexpr void tell(auto& m) {
    m << "drive.bad_number: the node of " << Motor::name << " is " << Node
      << ", and a node of CANopen is 1 to 127";
  }
};
}  // namespace detail

template <Cia402Motor Motor, std::uint8_t Node, cia402_mode Mode>
struct cia402 {
  static_assert(
      cca::detail::holds_or_tells<(Node >= 1 && Node <= 127), detail::no_canopen_node<Motor, Node>>::value);
  static constexpr std::uint8_t node = Node;
  static constexpr bool by_position = Mode == cia402_mode::position;
  static constexpr double counts_a_radian = Motor::counts / detail::radians_in_turn,
                          least_torque = Motor::torque / 1000;

  static constexpr std::string_view name = Motor::name;
  static constexpr auto limits =
      cca::limits{cca::angle{-2147483647 / counts_a_radian, 2147483647 / counts_a_radian},
                  cca::torque{-32767 * least_torque, 32767 * least_torque}};
  static constexpr std::uint8_t uses = by_position ? of_position : of_torque;
  static constexpr can_id receives = standard(0x200 + Node), sends = standard(0x180 + Node),
                          sends_velocity = standard(0x280 + Node), emergency = standard(0x080 + Node),
                          heartbeat = standard(0x700 + Node);
  static constexpr std::array<can_filter, 1> requests{{{receives}}};
  static constexpr std::array<can_filter, 2> broadcasts{{{standard(0)}, {standard(0x080)}}};  // NMT, SYNC
  static constexpr std::array<can_frame, 1> cycle_frames{canopen_sync()};
  static constexpr std::array<can_filter, 4> replies{{{sends}, {sends_velocity}, {emergency}, {heartbeat}}};
  // Its other process data and its SDO, in and out: ids that CiA 301 gives to this node.
  static constexpr std::array<can_filter, 7> occupies{{{standard(0x300 + Node)},
                                                       {standard(0x400 + Node)},
                                                       {standard(0x500 + Node)},
                                                       {standard(0x380 + Node)},
                                                       {standard(0x480 + Node)},
                                                       {standard(0x580 + Node)},
                                                       {standard(0x600 + Node)}}};
  static constexpr std::array<frame_traffic, 4> traffic{{{.shape = {.length = 8}},
                                                         {.shape = {.length = 8}},
                                                         {.shape = {.length = 4}},
                                                         {.shape = {.length = 1}, .period = 100'000'000}}};
  static constexpr drive_watchdog watchdog{
      0, "by object 6007h, when it loses the heartbeat that it listens to (1016h); off unless set"};

  static constexpr set_point_frames set_point(const drive_command& c) noexcept {
    set_point_frames s;
    s.finite = detail::is_finite(by_position ? c.position : c.torque);
    if (s.finite)
      s.frames.add(process_data(0x000F, by_position ? c.position : 0, by_position ? 0 : c.torque, s.cut));
    return s;
  }

  static constexpr bool decode(const can_frame& f, drive_report& r) noexcept {
    if (f.fd || f.remote) return false;
    const auto p = f.payload();
    if (f.id == sends && f.length == 8) {
      r.state = detail::got<std::uint16_t>(p, 0);
      r.position = static_cast<std::int32_t>(detail::got<std::uint32_t>(p, 2)) / counts_a_radian;
      r.torque = static_cast<std::int16_t>(detail::got<std::uint16_t>(p, 6)) * least_torque;
      const auto s = cia402_state_of(static_cast<std::uint16_t>(r.state));
      if (s == cia402_state::fault || s == cia402_state::fault_reaction) {
        r.activity = drive_activity::faulted;
        if (r.fault == drive_fault::none) r.fault = drive_fault::other;  // until the emergency says which
      } else {
        r.activity = s == cia402_state::enabled                                   ? drive_activity::enabled
                     : s == cia402_state::ready || s == cia402_state::switched_on ? drive_activity::enabling
                     : s == cia402_state::unknown                                 ? drive_activity::unknown
                                                                                  : drive_activity::disabled;
        r.fault = drive_fault::none;
      }
      r.told = of_position | of_torque | of_activity;
    } else if (f.id == sends_velocity && f.length == 4) {
      r.velocity = static_cast<std::int32_t>(detail::got<std::uint32_t>(p, 0)) / counts_a_radian;
      r.told = of_velocity;
    } else if (f.id == emergency && f.length == 8) {
      r.code = detail::got<std::uint16_t>(p, 0);
      r.fault = detail::cia402_fault_of(r.code);
      if (r.fault != drive_fault::none) r.activity = drive_activity::faulted;
      r.told = of_activity;
    } else if (f.id == heartbeat && f.length == 1) {
      if (p[0] != 5) {  // 5: operational. In any other state the drive holds nothing
        r.activity = drive_activity::disabled;
        r.state = 0;
      }
      r.told = of_activity;
    } else {
      return false;
    }
    r.states += (r.told & of_activity) != 0;
    ++r.frames;
    return true;
  }

  static constexpr can_frame control(std::uint16_t word) noexcept {
    std::uint8_t cut = 0;
    return process_data(word, 0, 0, cut);
  }
  // Disable voltage: the drive is free.
  static constexpr drive_frames disable() noexcept { return {control(0x0000)}; }
  // Stops by its ramp, then goes on by object 605Ah.
  static constexpr drive_frames quick_stop() noexcept { return {control(0x0002)}; }

  // A quick stop and the reaction to a fault still brake.
  static constexpr bool is_off(const drive_report& r) noexcept {
    const auto s = cia402_state_of(static_cast<std::uint16_t>(r.state));
    return s != cia402_state::enabled && s != cia402_state::quick_stop && s != cia402_state::fault_reaction &&
           s != cia402_state::unknown;
  }

  class enabling {
  public:
    constexpr enable_step next(const drive_report& r) noexcept {
      const auto s =
          r.states == 0 ? cia402_state::unknown : cia402_state_of(static_cast<std::uint16_t>(r.state));
      const bool measured = detail::is_finite(r.position);
      if (s == cia402_state::fault && ++resets > 16) return {disable(), enable_progress::failed};
      std::uint8_t cut = 0;
      const bool may = measured || s == cia402_state::fault;
      const std::uint16_t word = may ? cia402_towards_enabled(s, resets % 2 == 0) : 0x0006;
      drive_frames frames;
      if (!started) frames.add(canopen_start(Node));
      started = true;
      frames.add(process_data(word, measured ? r.position : 0, 0, cut));
      return {frames, s == cia402_state::enabled && r.activity == drive_activity::enabled && measured
                          ? enable_progress::done
                          : enable_progress::going};
    }

  private:
    bool started = false;
    int resets = 0;
  };

  // The drive's side, for virtual drives.
  static constexpr bool hear(const can_frame& f, std::uint16_t& word, drive_command& c) noexcept {
    if (f.id != receives || f.fd || f.remote || f.length != 8) return false;
    const auto p = f.payload();
    word = detail::got<std::uint16_t>(p, 0);
    c = {.position = static_cast<std::int32_t>(detail::got<std::uint32_t>(p, 2)) / counts_a_radian,
         .torque = static_cast<std::int16_t>(detail::got<std::uint16_t>(p, 6)) * least_torque};
    return true;
  }
  static constexpr can_frame reply(std::uint16_t status, double position, double torque) noexcept {
    std::uint8_t cut = 0;
    can_frame f = process_data(status, position, torque, cut);
    f.id = sends;
    return f;
  }
  static constexpr can_frame velocity_frame(double velocity) noexcept {
    bool cut = false;
    can_frame f{.id = sends_velocity, .length = 4};
    detail::put(f.data, 0,
                static_cast<std::uint32_t>(detail::nearest_integer(velocity * counts_a_radian, 32, cut)));
    return f;
  }
  static constexpr can_frame emergency_frame(std::uint16_t code) noexcept {
    can_frame f{.id = emergency, .length = 8};
    detail::put(f.data, 0, code);
    f.data[2] = code != 0;
    return f;
  }
  static constexpr can_frame heartbeat_frame(std::uint8_t state) noexcept {
    return {.id = heartbeat, .length = 1, .data = {state}};
  }

private:
  // Both directions have the same layout: a word, a position, a torque.
  static constexpr can_frame process_data(std::uint16_t word,
                                          double position,
                                          double torque,
                                          std::uint8_t& cut) {
    can_frame f{.id = receives, .length = 8};
    bool far = false, strong = false;
    detail::put(f.data, 0, word);
    detail::put(f.data, 2,
                static_cast<std::uint32_t>(detail::nearest_integer(position * counts_a_radian, 32, far)));
    detail::put(f.data, 6,
                static_cast<std::uint16_t>(detail::nearest_integer(torque / least_torque, 16, strong)));
    cut = static_cast<std::uint8_t>(cut | (far ? of_position : 0) | (strong ? of_torque : 0));
    return f;
  }
};

}  // namespace cca::hardware

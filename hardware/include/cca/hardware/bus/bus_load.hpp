// The figures behind a bus plan: how much of its time the bus is in use, and which ids two drives share; and
// the message that refuses a plan.
//
// Used by drives/bus_plan.hpp and robot/robot_buses.hpp. Errors: bus.overloaded, drive.duplicate_id. Cost:
// constants.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/hardware/bus/bus_traffic.hpp>

namespace cca::hardware::detail {

inline constexpr std::int64_t most_percent = 90;

struct drive_facts {
  std::string_view name;
  std::span<const can_filter> requests, replies, broadcasts, occupies;
  std::span<const frame_traffic> traffic;
  std::span<const can_frame> cycle_frames;
  drive_mark mark{};
};
template <class D>
constexpr drive_facts facts_of(std::string_view name = D::name) {
  return {name,           D::requests, D::replies,         broadcasts_of<D>,
          occupied_by<D>, D::traffic,  cycle_frames_of<D>, reply_mark_of<D>};
}

struct bus_use {
  std::int64_t frames_a_cycle = 0, cycle = 0;  // ns
  double periodic = 0;                         // ns in a second
  constexpr double nanoseconds(double hz) const { return static_cast<double>(cycle) * hz + periodic; }
};
constexpr bus_use use_of(std::span<const drive_facts> drives, bit_rates rates) {
  bus_use use;
  for (std::size_t i = 0; i < drives.size(); ++i)
    for (const can_frame& f : drives[i].cycle_frames) {
      bool before = false;
      for (const drive_facts& d : drives.first(i))
        for (const can_frame& g : d.cycle_frames) before = before || f == g;
      if (before) continue;
      use.frames_a_cycle += 1;
      use.cycle += rates.nanoseconds(worst_case(shape_of(f)));
    }
  for (const drive_facts& d : drives)
    for (const frame_traffic& t : d.traffic) {
      const std::int64_t one = rates.nanoseconds(worst_case(t.shape));
      if (t.period > 0) {
        use.periodic += static_cast<double>(one) * 1e9 / static_cast<double>(t.period);
      } else {
        use.frames_a_cycle += t.a_cycle;
        use.cycle += t.a_cycle * one;
      }
    }
  return use;
}

struct same_id {
  int a = -1, b = -1;
  can_id id{};
  bool answers = false;  // both reply under it, and can't be told apart
};
constexpr bool share_one(std::span<const can_filter> a, std::span<const can_filter> b, can_id& id) {
  for (const can_filter& f : a)
    for (const can_filter& g : b)
      if (overlap(f, g)) {
        id = {(f.id.number & f.mask) | (g.id.number & g.mask), f.id.extended};
        return true;
      }
  return false;
}
// No id that one drive sends, hears or occupies may move the other one.
constexpr bool meets(const drive_facts& a, const drive_facts& b, can_id& id) {
  for (const auto& those : {a.requests, a.replies, a.broadcasts, a.occupies})
    if (share_one(those, b.occupies, id)) return true;
  return share_one(a.requests, b.requests, id) || share_one(a.requests, b.replies, id) ||
         share_one(a.broadcasts, b.requests, id) || share_one(a.broadcasts, b.replies, id);
}
constexpr same_id find_same_id(std::span<const drive_facts> drives) {
  same_id found;
  for (std::size_t i = 0; i < drives.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const drive_facts &a = drives[j], &b = drives[i];
      const bool one_moves_both = meets(a, b, found.id) || meets(b, a, found.id);
      found.answers = !one_moves_both && !apart(a.mark, b.mark) && share_one(a.replies, b.replies, found.id);
      if (one_moves_both || found.answers) {
        found.a = static_cast<int>(j);
        found.b = static_cast<int>(i);
        return found;
      }
    }
  return found;
}

constexpr void add_id(cca::detail::text& t, can_id id) {
  t << "0x";
  for (int shift = id.extended ? 28 : 8; shift >= 0; shift -= 4)
    t << std::string_view("0123456789ABCDEF").substr(id.number >> shift & 0xF, 1);
}

// The figures of a bus, and whether they are sound.
struct bus_figures {
  bit_rates rates{};
  double hz = 0;
  bus_use use{};
  same_id twice{};

  constexpr bus_figures(std::span<const drive_facts> drives, bit_rates r, double rate)
      : rates(r), hz(rate), use(use_of(drives, r)), twice(find_same_id(drives)) {}
  constexpr double load() const { return use.nanoseconds(hz) / 1e9; }
  constexpr bool overloaded() const { return load() * 100 > most_percent; }
  constexpr bool sound() const { return twice.a < 0 && !overloaded(); }
};

constexpr void tell_of_bus(cca::detail::text& t,
                           std::string_view name,
                           std::span<const drive_facts> drives,
                           const bus_figures& bus) {
  if (bus.twice.a >= 0) {
    const auto drive = [&](int i) { t << i + 1 << " (" << drives[static_cast<std::size_t>(i)].name << ")"; };
    t << "drive.duplicate_id: on the bus `" << name << "` the drives ";
    drive(bus.twice.a);
    t << " and ";
    drive(bus.twice.b);
    t << " both use the id ";
    add_id(t, bus.twice.id);
    t << (bus.twice.answers ? ": what one answers would be taken for an answer of the other"
                            : ": what is meant for one would move the other as well")
      << "; give each of them an id of its own, in its firmware and in its type";
    return;
  }
  const double left = static_cast<double>(most_percent) * 1e7 - bus.use.periodic;
  t << "bus.overloaded: the bus `" << name << "` at " << bus.rates.nominal << " bit/s would be in use for "
    << static_cast<std::int64_t>(bus.load() * 100 + 0.5)
    << " % of the time: " << static_cast<std::int64_t>(drives.size()) << " drives send "
    << bus.use.frames_a_cycle << " frames a cycle, which take up to " << bus.use.cycle / 1000 << " us, at "
    << bus.hz << " Hz";
  if (bus.use.periodic > 0)
    t << ", and " << bus.use.periodic / 1e7 << " % are frames that come by themselves";
  t << "; at most " << most_percent << " % may be planned. ";
  if (left > static_cast<double>(bus.use.cycle))
    t << "Lower the rate to " << static_cast<std::int64_t>(left / static_cast<double>(bus.use.cycle))
      << " Hz, put ";
  else t << "Put ";
  t << "drives on a second bus, or use faster bit rates or CAN FD";
}

template <class Check>
constexpr auto check_plan() {
  static_assert(cca::detail::holds_or_tells<Check::sound, Check>::value);
  return std::bool_constant<Check::sound>();
}

// Filters in order, each once.
template <std::size_t Most>
struct filter_list {
  std::array<can_filter, Most> filters{};
  std::size_t count = 0;

  constexpr void add(const can_filter& f) {
    for (std::size_t i = 0; i < count; ++i)
      if (filters[i] == f) return;
    filters[count++] = f;
  }
  constexpr operator std::span<const can_filter>() const { return {filters.data(), count}; }
};

}  // namespace cca::hardware::detail

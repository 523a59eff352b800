// What a component hears by an `observe` in its signature: the samples of all ports that a pattern names.
//
//   void process(cca::observe<"dmp.**"> all) {
//     for (const auto& one : all)
//       if (const auto* angles = one.as<leg_angles>(); angles && one.fresh) ...
//
// Cost: of each observation a few words in memory; its values stay where they are stored. `as` copies them.
// Errors: observe.nothing. Example: tests/runtime/core/observing.cpp; docs/graphs.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <string_view>

#include <cca/base/fixed_string.hpp>
#include <cca/space/info.hpp>
#include <cca/space/sample.hpp>

namespace cca {

namespace detail {

// Room for a sample of so many coordinates, whatever its space.
inline constexpr std::size_t alignment_of_room = 64;
constexpr std::size_t room_of_sample(int coordinates) {
  const auto needed = static_cast<std::size_t>(coordinates) * sizeof(double) + 2 * sizeof(double);
  return (needed / alignment_of_room + 2) * alignment_of_room;
}

}  // namespace detail

struct one_output;  // a policy without effect, for older programs

// One of the samples that an `observe` hears.
struct observation {
  std::string_view path;           // "dmp.status.component", from the outermost graph on
  std::span<const double> values;  // coordinates in the order of the axes
  std::int64_t origin;             // `never`: nothing has been published yet
  bool fresh;
  const detail::space_info* space = nullptr;
  unsigned char* room = nullptr;  // where `as` puts the sample

  // The names of its axes, and the unit of its numbers; empty where it has none.
  constexpr std::span<const std::string_view> axes() const {
    return space ? std::span(space->labels, static_cast<std::size_t>(space->axis_count))
                 : std::span<const std::string_view>();
  }
  constexpr std::string_view unit() const { return space ? space->unit : std::string_view(); }

  // The sample, with the methods of its domain type; null if it is of another space. It lives as long as the
  // observation.
  template <class Space>
  const sample<Space>* as() const {
    static_assert(sizeof(sample<Space>) <= detail::room_of_sample(Space::size) &&
                  alignof(sample<Space>) <= detail::alignment_of_room);
    if (!space || !room || !matches(*space, detail::space_of<Space>)) return nullptr;
    typename Space::vector_type copy = Eigen::Map<const typename Space::vector_type>(values.data());
    return ::new (static_cast<void*>(room)) sample<Space>(copy, origin);
  }
};

// What a component looks up by `observe::find`: it says so by a member `static constexpr` array
// `asked_paths`, and a path that it does not hear is refused (plan.unknown_path). `axis`: the number of its
// values that it reads.
struct asked_path {
  std::string_view path{};
  int axis = 0;
};

// An input that hears all outputs which a pattern names, whatever their spaces: `observe<"dmp.status.*">`.
// `*` is any one name and `**` any number of names; `**` at the end also names the wired inputs, with what
// they show. A pattern is looked up in the graph of the component, then in the graphs around it; with a `/`
// in front in the outermost one. Policies are those of a wire, and hold for each output:
// `observe<"dmp.status.*", cca::delayed<1>>` where the component feeds them itself. Errors: observe.nothing.
template <fixed_string Pattern, class... Policies>
class observe {
public:
  static constexpr std::string_view name = Pattern.view();

  // `stands_in`: the path of the graph in which the component stands; empty: the outermost one.
  constexpr observe(const observation* all, std::size_t all_count, std::string_view stands_in = {})
      : first(all), count(all_count), within(stands_in) {}

  constexpr const observation* begin() const { return first; }
  constexpr const observation* end() const { return first + count; }
  constexpr std::size_t size() const { return count; }
  constexpr std::string_view stands_in() const { return within; }

  // The observation with a path, which is looked up as a pattern is; null if it is not heard.
  constexpr const observation* find(std::string_view path) const {
    const bool from_outermost = path.starts_with('/');
    if (from_outermost) path.remove_prefix(1);
    for (std::string_view graph = from_outermost ? std::string_view() : within;;) {
      for (const auto& one : *this)
        if (graph.empty()
                ? one.path == path
                : one.path.size() == graph.size() + 1 + path.size() && one.path.starts_with(graph) &&
                      one.path[graph.size()] == '.' && one.path.ends_with(path))
          return &one;
      if (graph.empty()) return nullptr;
      const auto dot = graph.rfind('.');
      graph = dot == graph.npos ? std::string_view() : graph.substr(0, dot);
    }
  }
  constexpr bool fresh() const {
    for (const auto& one : *this)
      if (one.fresh) return true;
    return false;
  }

private:
  const observation* first;
  std::size_t count;
  std::string_view within;
};

}  // namespace cca

// What the messages of ROS 2 say of spaces that they can't hold. `Words` is of one message: `name`, and
// `holds` with what fits. The sentences are compiled only where one is told.
#pragma once

#include <cstddef>
#include <string_view>
#include <type_traits>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/text.hpp>
#include <cca/base/type_name.hpp>
#include <cca/space/messages/space_in_words.hpp>

namespace cca::ros2::detail {

template <class Space>
inline constexpr cca::detail::text text_of_sent = [] {
  cca::detail::text one;
  if constexpr (requires { typename Space::element_space; })
    one << cca::detail::type_name<Space>() << " (" << Space::size / Space::element_space::size << " of "
        << cca::detail::space_in_words<typename Space::element_space>() << ")";
  else one << cca::detail::space_in_words<Space>();
  return one;
}();
// "leg_angles (joint_angles over hip, knee)", and of an array "way (20 of leg_angles (...))": it has too many
// axes.
template <class Space>
constexpr std::string_view sent_in_words() {
  return text_of_sent<Space>.view();
}

template <class Words, class Space>
struct other_space {
  static constexpr void tell(auto& m) {
    m << "space.mismatch: " << sent_in_words<Space>() << " does not fit into cca::ros2::" << Words::name
      << ", which holds " << Words::holds;
  }
};

// Of a message of several spaces, each a field of it. `Words::field<Space>` is the field's name, empty if it
// has none.
template <class Words, class... Spaces>
constexpr bool are_fields() {
  constexpr std::string_view fields[] = {Words::template field<Spaces>..., {}};
  for (std::size_t i = 0; i < sizeof...(Spaces); ++i) {
    if (fields[i].empty()) return false;
    for (std::size_t k = 0; k < i; ++k)
      if (fields[k] == fields[i]) return false;
  }
  return true;
}
template <class Words, class... Spaces>
struct other_fields {
  static constexpr void tell(auto& m) {
    constexpr std::string_view fields[] = {Words::template field<Spaces>..., {}};
    constexpr std::string_view spaces[] = {sent_in_words<Spaces>()..., {}};
    m << "space.mismatch: ";
    for (std::size_t i = 0; i < sizeof...(Spaces); ++i) {
      if (fields[i].empty()) {
        m << spaces[i] << " does not fit into cca::ros2::" << Words::name << ", which holds " << Words::holds;
        return;
      }
      for (std::size_t k = 0; k < i; ++k)
        if (fields[k] == fields[i]) {
          m << spaces[k] << " and " << spaces[i] << " are both the `" << fields[i]
            << "` of a cca::ros2::" << Words::name << ", which has it once: leave one out";
          return;
        }
    }
  }
};

// All are over the axes of the first, whose names are those of the joints. True where `other_fields` is told:
// one sentence is enough.
template <class Words, class First, class... Rest>
constexpr bool share_joints = !are_fields<Words, First, Rest...>() ||
                              (std::is_same_v<typename First::axes, typename Rest::axes> && ...);
template <class Words, class First, class... Rest>
struct other_joints {
  static constexpr void tell(auto& m) {
    constexpr bool is_other[] = {!std::is_same_v<typename First::axes, typename Rest::axes>..., true};
    constexpr std::string_view spaces[] = {sent_in_words<Rest>()..., {}};
    std::size_t i = 0;
    while (!is_other[i]) ++i;
    m << "space.mismatch: a cca::ros2::" << Words::name << " of " << sent_in_words<First>() << " and "
      << spaces[i] << " has one list of joints: give its spaces " << Words::same;
  }
};

}  // namespace cca::ros2::detail

// The names of joints in a message: those of the axes of a space.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include <cca/base/array_size.hpp>
#include <cca/ros2/address.hpp>
#include <cca/space/info.hpp>

namespace cca::ros2::detail {

template <class Space>
class joint_names {
public:
  static constexpr std::size_t count = cca::detail::array_size(Space::size);

  joint_names() {
    for (std::size_t i = 0; i < count; ++i) {
      names[i] = cca::detail::space_of<Space>.labels[i];
      letters[i] = names[i].data();
    }
  }
  joint_names(const joint_names&) = delete;
  joint_names& operator=(const joint_names&) = delete;

  // As long as this object lives.
  message_sequence<char*> all() { return borrowed(letters.data(), letters.size()); }

  // Where each joint is among the names of a message. Null, or why they are refused.
  static const char* find(const message_sequence<char*>& in, std::array<std::size_t, count>& places) {
    for (std::size_t i = 0; i < count; ++i) {
      places[i] = in.length;
      for (std::size_t k = 0; k < in.length; ++k) {
        if (in.buffer[k] != cca::detail::space_of<Space>.labels[i]) continue;
        if (places[i] != in.length) return "a joint is named twice";
        places[i] = k;
      }
      if (places[i] == in.length) return "a joint is missing";
    }
    return nullptr;
  }

private:
  std::array<std::string, count> names;
  std::array<char*, count> letters{};
};

}  // namespace cca::ros2::detail

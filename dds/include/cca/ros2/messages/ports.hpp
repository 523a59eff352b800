// The ports of a publisher or subscriber: for each space of its message one, with the name of the message's
// field. Their numbers lie one after the other in one vector.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>

#include <cca/base/fixed_string.hpp>
#include <cca/base/type_name.hpp>
#include <cca/space/info.hpp>

namespace cca::ros2::detail {

template <fixed_string Name, class Space>
struct message_port {
  static constexpr auto name = Name;
  using space = Space;
};

template <class... Ports>
struct port_list {
  static constexpr int size = (Ports::space::size + ... + 0);
};

// The frame along whose axes the numbers of a domain type are: the last one that it names.
template <class... Frames>
struct last_of {
  using type = void;
};
template <class Last>
struct last_of<Last> {
  using type = Last;
};
template <class First, class... Rest>
  requires(sizeof...(Rest) > 0)
struct last_of<First, Rest...> : last_of<Rest...> {};

template <class Domain>
struct frame_along : last_of<> {};
template <template <class...> class Domain, class... Frames>
struct frame_along<Domain<Frames...>> : last_of<Frames...> {};

// frame_id: the name of a cca::frame<"name">, or that of the type.
template <class Frame>
std::string frame_name() {
  if constexpr (std::is_void_v<Frame>) return {};
  else if constexpr (requires { std::string_view(Frame::name); }) return std::string(Frame::name);
  else return std::string(cca::detail::type_name<Frame>());
}

// A sender that leaves frame_id empty is trusted; one that names another frame is not.
inline bool is_frame(const char* frame_id, const std::string& wanted) {
  return *frame_id == '\0' || frame_id == wanted;
}

}  // namespace cca::ros2::detail

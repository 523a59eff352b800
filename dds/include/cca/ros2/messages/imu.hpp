// sensor_msgs/Imu: an orientation, and two spaces over x, y, z, told apart by their units.
//
//   imu<trunk_orientation, trunk_angular_velocity, trunk_acceleration>
//
//   cca::orientation<Frame>    port "orientation"           how the sensor is rotated in Frame
//   a quantity in rad/s        port "angular_velocity"
//   a quantity in m/s^2        port "linear_acceleration"   upwards 9.81 at rest, as an accelerometer reads
//
// Each at most once. frame_id is the frame of the rates and accelerations; they must share it. The
// covariances are zero, which means unknown; where there is no space, the first number is -1, which means no
// estimate. Refused: a field that is wanted and has no estimate, another frame, an orientation that is no
// unit quaternion (to 0.001; within that it is normalised).
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/ros2/messages/geometry.hpp>
#include <cca/ros2/messages/header.hpp>
#include <cca/ros2/messages/message_mistakes.hpp>
#include <cca/ros2/messages/ports.hpp>
#include <cca/space/messages/space_in_words.hpp>
#include <cca/space/orientation.hpp>

namespace cca::ros2 {

namespace detail {

struct imu_message {
  header head;
  quaternion orientation;
  std::array<double, 9> orientation_covariance{};
  vector_3 angular_velocity;
  std::array<double, 9> angular_velocity_covariance{};
  vector_3 linear_acceleration;
  std::array<double, 9> linear_acceleration_covariance{};
};
inline constexpr std::array imu_fields{
    message_field{"header", kind::message, offsetof(imu_message, head), 1, &header_type},
    message_field{"orientation", kind::message, offsetof(imu_message, orientation), 1, &quaternion_type},
    message_field{"orientation_covariance", kind::float64, offsetof(imu_message, orientation_covariance), 9},
    message_field{"angular_velocity", kind::message, offsetof(imu_message, angular_velocity), 1,
                  &vector_3_type},
    message_field{"angular_velocity_covariance", kind::float64,
                  offsetof(imu_message, angular_velocity_covariance), 9},
    message_field{"linear_acceleration", kind::message, offsetof(imu_message, linear_acceleration), 1,
                  &vector_3_type},
    message_field{"linear_acceleration_covariance", kind::float64,
                  offsetof(imu_message, linear_acceleration_covariance), 9},
};

struct imu_orientation {
  static constexpr fixed_string name{"orientation"};
  static constexpr auto covariance = &imu_message::orientation_covariance;

  static void set(imu_message& m, const double* from) { m.orientation.set(from); }
  static const char* get(const imu_message& m, double* to) { return m.orientation.get(to); }
};
template <fixed_string Name, vector_3 imu_message::* Values, std::array<double, 9> imu_message::* Covariance>
struct imu_vector {
  static constexpr auto name = Name;
  static constexpr auto covariance = Covariance;

  static void set(imu_message& m, const double* from) { (m.*Values).set(from); }
  static const char* get(const imu_message& m, double* to) {
    (m.*Values).get(to);
    return nullptr;
  }
};
using imu_angular_velocity =
    imu_vector<"angular_velocity", &imu_message::angular_velocity, &imu_message::angular_velocity_covariance>;
using imu_linear_acceleration = imu_vector<"linear_acceleration",
                                           &imu_message::linear_acceleration,
                                           &imu_message::linear_acceleration_covariance>;

struct imu_no_field {
  static constexpr fixed_string name{"none"};
};
template <class Space>
constexpr auto imu_field() {
  constexpr std::string_view unit = cca::detail::space_of<Space>.unit;
  if constexpr (!std::is_same_v<typename Space::axes, axes<x, y, z>>)
    return std::type_identity<imu_no_field>{};
  else if constexpr (cca::detail::is_orientation<typename Space::domain>)
    return std::type_identity<imu_orientation>{};
  else if constexpr (unit == "rad/s") return std::type_identity<imu_angular_velocity>{};
  else if constexpr (unit == "m/s^2") return std::type_identity<imu_linear_acceleration>{};
  else return std::type_identity<imu_no_field>{};
}
template <class Space>
using imu_field_of = typename decltype(imu_field<Space>())::type;

struct imu_words {
  static constexpr std::string_view name = "imu";
  static constexpr std::string_view holds =
      "spaces over x, y, z: an orientation, one in rad/s (angular_velocity) and one in m/s^2 "
      "(linear_acceleration)";
  template <class Space>
  static constexpr std::string_view field =
      std::is_same_v<imu_field_of<Space>, imu_no_field> ? "" : imu_field_of<Space>::name.view();
};

}  // namespace detail

template <class... Spaces>
struct imu {
  static_assert(sizeof...(Spaces) >= 1, "cca::ros2::imu: name at least one space");
  template <class Field>
  static constexpr int times = (std::is_same_v<detail::imu_field_of<Spaces>, Field> + ... + 0);
  static_assert(cca::detail::holds_or_tells<detail::are_fields<detail::imu_words, Spaces...>(),
                                            detail::other_fields<detail::imu_words, Spaces...>>::value);

  using ports = detail::port_list<detail::message_port<detail::imu_field_of<Spaces>::name, Spaces>...>;
  using message = detail::imu_message;
  static constexpr int size = ports::size;
  static constexpr detail::message_type type{
      "sensor_msgs/msg/Imu", detail::imu_fields, sizeof(message), alignof(message),
      "RIHS01_7d9a00ff131080897a5ec7e26e315954b8eae3353c3f995c55faf71574000b5b"};

  class maker {
  public:
    maker() {
      made.head.frame_id = frame.data();
      if (!times<detail::imu_orientation>) made.orientation_covariance[0] = -1;
      if (!times<detail::imu_angular_velocity>) made.angular_velocity_covariance[0] = -1;
      if (!times<detail::imu_linear_acceleration>) made.linear_acceleration_covariance[0] = -1;
    }
    maker(const maker&) = delete;
    maker& operator=(const maker&) = delete;

    const message* make(const double* from, std::int64_t age) {
      made.head.stamp = detail::stamp_of(age);
      ((detail::imu_field_of<Spaces>::set(made, from), from += Spaces::size), ...);
      return &made;
    }

  private:
    std::string frame = sensor_frame();
    message made;
  };

  static const char* read(const message& m, double* to) {
    static const std::string wanted = sensor_frame();
    if (!detail::is_frame(m.head.frame_id, wanted)) return "another frame_id";
    const char* why = nullptr;
    ((why = why ? why : read_one<Spaces>(m, to), to += Spaces::size), ...);
    return why;
  }

private:
  template <class Space>
  static const char* read_one(const message& m, double* to) {
    using field = detail::imu_field_of<Space>;
    if ((m.*field::covariance)[0] == -1) return "a field without an estimate";
    return field::get(m, to);
  }

  template <class Space>
  static constexpr bool is_rotation = cca::detail::is_orientation<typename Space::domain>;
  template <class Space>
  using frame_of = typename detail::frame_along<typename Space::domain>::type;

  // The orientation's frame is that in which the sensor is rotated, so it is not the sensor's.
  static std::string sensor_frame() {
    std::string found;
    ((is_rotation<Spaces> || !found.empty() ? void() : void(found = detail::frame_name<frame_of<Spaces>>())),
     ...);
    return found;
  }
  template <class Space, class Other>
  static constexpr bool share_frame =
      is_rotation<Space> || is_rotation<Other> || std::is_same_v<frame_of<Space>, frame_of<Other>>;
  template <class Space>
  static constexpr bool shares_frame = (share_frame<Space, Spaces> && ...);
  struct in_two_frames {
    static constexpr void tell(auto& m) {
      m << "frame.mismatch: the angular velocity and the acceleration of a cca::ros2::imu are along the axes "
           "of different frames, and its message has one frame_id:";
      ((m << " " << cca::detail::space_in_words<Spaces>()), ...);
    }
  };
  static_assert(cca::detail::holds_or_tells<(shares_frame<Spaces> && ...), in_two_frames>::value);
};

}  // namespace cca::ros2

// geometry_msgs/PoseStamped, TransformStamped, and tf2_msgs/TFMessage with one transform, of a space of
// poses.
//
//   pose_stamped<trunk_pose>                  port "pose"
//   transform_stamped<trunk_pose, "trunk">    port "transform"
//   tf<trunk_pose, "trunk">                   port "transform"; the message of the topic "tf"
//
// All are of cca::pose<Frame>. frame_id is that Frame; "trunk" is child_frame_id, the frame of the thing
// whose pose it is. On "tf" many tell of many frames: a subscriber takes its child, and messages without it
// are neither used nor refused; so at least the last 100 are kept, as in tf2_ros. "tf_static" is told once:
// its quality is `transient_local`. Refused: another frame_id or child_frame_id, an orientation that is no
// unit quaternion (to 0.001; it is normalised if that is more than rounding).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <cca/dds/nodes/incoming.hpp>
#include <cca/ros2/messages/geometry.hpp>
#include <cca/ros2/messages/header.hpp>
#include <cca/ros2/messages/message_mistakes.hpp>
#include <cca/ros2/messages/ports.hpp>
#include <cca/space/pose.hpp>

namespace cca::ros2 {

namespace detail {

struct pose_message {
  header head;
  pose_parts pose;
};
inline constexpr std::array pose_message_fields{
    message_field{"header", kind::message, offsetof(pose_message, head), 1, &header_type},
    message_field{"pose", kind::message, offsetof(pose_message, pose), 1, &pose_type},
};

struct transform_message {
  header head;
  char* child_frame_id = nullptr;
  pose_parts transform;
};
inline constexpr std::array transform_message_fields{
    message_field{"header", kind::message, offsetof(transform_message, head), 1, &header_type},
    message_field{"child_frame_id", kind::string, offsetof(transform_message, child_frame_id)},
    message_field{"transform", kind::message, offsetof(transform_message, transform), 1, &transform_type},
};
inline constexpr message_type transform_message_type{
    "geometry_msgs/msg/TransformStamped", transform_message_fields, sizeof(transform_message),
    alignof(transform_message), "RIHS01_0a241f87d04668d94099cbb5ba11691d5ad32c2f29682e4eb5653424bd275206"};

struct tf_message {
  message_sequence<transform_message> transforms;
};
inline constexpr std::array tf_message_fields{
    message_field{"transforms", kind::message, offsetof(tf_message, transforms), message_field::sequence,
                  &transform_message_type},
};

struct pose_words {
  static constexpr std::string_view name = "pose_stamped", holds = "a space of cca::pose<Frame>";
};
struct transform_words : pose_words {
  static constexpr std::string_view name = "transform_stamped";
};
struct tf_words : pose_words {
  static constexpr std::string_view name = "tf";
};

template <class Space, class Words>
struct of_pose {
  static_assert(cca::detail::holds_or_tells<cca::detail::is_pose<typename Space::domain>,
                                            other_space<Words, Space>>::value);
  static constexpr int size = Space::size;
  static std::string frame() { return frame_name<typename Space::domain::frame>(); }
};

}  // namespace detail

template <class Space>
struct pose_stamped : detail::of_pose<Space, detail::pose_words> {
  using ports = detail::port_list<detail::message_port<"pose", Space>>;
  using message = detail::pose_message;
  static constexpr detail::message_type type{
      "geometry_msgs/msg/PoseStamped", detail::pose_message_fields, sizeof(message), alignof(message),
      "RIHS01_10f3786d7d40fd2b54367835614bff85d4ad3b5dab62bf8bca0cc232d73b4cd8"};

  class maker {
  public:
    maker() { made.head.frame_id = frame.data(); }
    maker(const maker&) = delete;
    maker& operator=(const maker&) = delete;

    const message* make(const double* from, std::int64_t age) {
      made.head.stamp = detail::stamp_of(age);
      made.pose.set(from);
      return &made;
    }

  private:
    std::string frame = pose_stamped::frame();
    message made;
  };

  static const char* read(const message& m, double* to) {
    static const std::string wanted = pose_stamped::frame();
    if (!detail::is_frame(m.head.frame_id, wanted)) return "another frame_id";
    return m.pose.get(to);
  }
};

template <class Space, fixed_string Child>
struct transform_stamped : detail::of_pose<Space, detail::transform_words> {
  using ports = detail::port_list<detail::message_port<"transform", Space>>;
  using message = detail::transform_message;
  static constexpr const detail::message_type& type = detail::transform_message_type;

  class maker {
  public:
    maker() {
      made.head.frame_id = frame.data();
      made.child_frame_id = child.data();
    }
    maker(const maker&) = delete;
    maker& operator=(const maker&) = delete;

    const message* make(const double* from, std::int64_t age) {
      made.head.stamp = detail::stamp_of(age);
      made.transform.set(from);
      return &made;
    }

  private:
    std::string frame = transform_stamped::frame(), child{Child.view()};
    message made;
  };

  static const char* read(const message& m, double* to) {
    static const std::string wanted = transform_stamped::frame();
    if (!is_child(m)) return "another child_frame_id";
    if (!detail::is_frame(m.head.frame_id, wanted)) return "another frame_id";
    return m.transform.get(to);
  }
  static bool is_child(const message& m) { return m.child_frame_id == Child.view(); }
};

template <class Space, fixed_string Child>
struct tf : detail::of_pose<Space, detail::tf_words> {
  using ports = detail::port_list<detail::message_port<"transform", Space>>;
  using message = detail::tf_message;
  using one = transform_stamped<Space, Child>;
  static constexpr std::int32_t least_depth = 100;
  static constexpr detail::message_type type{
      "tf2_msgs/msg/TFMessage", detail::tf_message_fields, sizeof(message), alignof(message),
      "RIHS01_e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087"};

  class maker {
  public:
    const message* make(const double* from, std::int64_t age) {
      transform = *of_one.make(from, age);
      made.transforms = detail::borrowed(&transform, 1);
      return &made;
    }

  private:
    typename one::maker of_one;
    detail::transform_message transform;
    message made;
  };

  static const char* read(const message& m, double* to) {
    for (const auto& each : m.transforms.all())
      if (one::is_child(each)) return one::read(each, to);
    return detail::is_for_others;
  }
};

}  // namespace cca::ros2

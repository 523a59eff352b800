// What a recording has of the robot's body, for viewers: /robot_description once, /tf at their rate. Nothing
// where the graph states no body (cca::shows).
//
// Errors: recording.unknown_port, recording.wrong_port.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <cca/graph/verdict/shown_ports.hpp>
#include <cca/graph/items/shows.hpp>
#include <cca/record/file/message_outlets.hpp>
#include <cca/record/messages/body_transforms.hpp>
#include <cca/record/messages/urdf.hpp>
#include <cca/record/messages/viewer_message.hpp>

namespace cca::recording::detail {

struct no_body {
  template <class... All>
  void write(const All&...) {}
};

template <class Graph>
class shown_body {
  using body = typename Graph::cca_shown_body;
  static_assert(cca::detail::checked_shows<Graph>{});
  static constexpr int angles = cca::detail::shown_ports_of<Graph>.angles,
                       orientation = cca::detail::shown_ports_of<Graph>.orientation;

public:
  // `space_of(output)`: its space.
  template <class SpaceOf>
  shown_body(message_outlets& outlets, SpaceOf space_of)
      : transforms(description_of<body>(), frame_of_base(space_of)) {
    const auto& space = space_of(angles);
    for (const described_axis& axis : transforms.description().axes)
      for (int i = 0; i < space.axis_count; ++i)
        if (space.labels[i] == axis.name) index.push_back(i);
    q.resize(index.size());
    tf = outlets.channel("/tf", transforms_type, transforms_schema());
    description = outlets.channel("/robot_description", description_type, description_schema, {}, true);
  }

  // A frame of one loop, at most every `interval` ns.
  template <class Layout>
  void write(message_outlets& outlets,
             const std::int64_t* frame,
             const Layout& layout,
             std::int64_t time,
             std::int64_t interval) {
    if (const double* const now = sample(frame, layout, orientation)) {
      std::memcpy(base.data(), now, sizeof base);
      has_base = true;
    }
    if (time < next) return;
    const double* const now = sample(frame, layout, angles);
    if (!now) return;
    next = time + interval;
    const auto at = static_cast<std::uint64_t>(time);
    if (!is_described) {
      is_described = true;
      const std::string text = urdf_of(transforms.description(), cca::detail::type_name<body>());
      std::vector<unsigned char> memory(text.size() + 64);
      cdr_writer to(memory);
      outlets.message(description, at, at, to.add(std::string_view(text)).view());
    }
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = now[index[i]];
    outlets.message(tf, at, at, transforms.made_of(q.data(), has_base ? base.data() : nullptr, time));
  }

private:
  template <class SpaceOf>
  static std::string frame_of_base(SpaceOf space_of) {
    if constexpr (orientation < 0) return {};
    else return std::string(frames_of(space_of(orientation).domain).back());
  }
  // Published in this beat, by this loop; else null.
  template <class Layout>
  const double* sample(const std::int64_t* frame, const Layout& layout, int output) {
    if (output < 0) return nullptr;
    const auto o = cca::detail::array_size(output);
    if (layout.origin[o] < 0 || frame[layout.origin[o]] == never) return nullptr;
    copied.resize(cca::detail::array_size(layout.size[o]));
    std::memcpy(copied.data(), frame + layout.at[o], sizeof(double) * copied.size());
    return copied.data();
  }

  body_transforms transforms;
  std::vector<int> index;  // where the axes of the body are in the space of the angles
  std::vector<double> q, copied;
  std::array<double, 4> base{0, 0, 0, 1};
  std::uint16_t tf = 0, description = 0;
  std::int64_t next = 0;
  bool has_base = false, is_described = false;
};

}  // namespace cca::recording::detail

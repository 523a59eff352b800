// What a recording has of the robot's body, for viewers: /robot_description once, /tf at their rate. Nothing
// where the graph states no body (cca::shows).
//
// Errors: cca::refused where the ports that it names are not there, or lack an axis of the body.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/refused.hpp>
#include <cca/graph/shows.hpp>
#include <cca/record/mcap/writer.hpp>
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

public:
  // `find(path)`: the number of an output, -1: there is none; `space_of(output)` its space.
  template <class Find, class SpaceOf>
  shown_body(mcap_writer& file, Find find, SpaceOf space_of)
      : transforms(description_of<body>(), frame_of_base(find, space_of)),
        angles(find(Graph::cca_shown_angles)),
        orientation(find(Graph::cca_shown_orientation)) {
    const std::string port(Graph::cca_shown_angles);
    if (angles < 0) throw refused("cca::shows: there is no output `" + port + "`");
    const auto& space = space_of(angles);
    for (const described_axis& axis : transforms.description().axes) {
      int found = -1;
      for (int i = 0; i < space.axis_count; ++i)
        if (space.labels[i] == axis.name) found = i;
      if (found < 0) throw refused("cca::shows: `" + port + "` has no axis `" + axis.name + "` of the body");
      index.push_back(found);
    }
    q.resize(index.size());
    tf = file.channel("/tf", transforms_type, transforms_schema());
    description = file.channel("/robot_description", description_type, description_schema);
  }

  // A frame of one loop, at most every `interval` ns.
  template <class Layout>
  void write(mcap_writer& file,
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
      file.message(description, at, at, to.add(std::string_view(text)).view());
    }
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = now[index[i]];
    file.message(tf, at, at, transforms.made_of(q.data(), has_base ? base.data() : nullptr, time));
  }

private:
  template <class Find, class SpaceOf>
  static std::string frame_of_base(Find find, SpaceOf space_of) {
    if (Graph::cca_shown_orientation.empty()) return {};
    const int output = find(Graph::cca_shown_orientation);
    if (output < 0)
      throw refused("cca::shows: there is no output `" + std::string(Graph::cca_shown_orientation) + "`");
    const auto& space = space_of(output);
    const auto frames = frames_of(space.domain);
    if (!space.domain.starts_with("orientation<") || frames.empty() || space.size != 4)
      throw refused("cca::shows: `" + std::string(Graph::cca_shown_orientation) + "` is no orientation");
    return std::string(frames.back());
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
  int angles, orientation;
  std::vector<int> index;  // where the axes of the body are in the space of the angles
  std::vector<double> q, copied;
  std::array<double, 4> base{0, 0, 0, 1};
  std::uint16_t tf = 0, description = 0;
  std::int64_t next = 0;
  bool has_base = false, is_described = false;
};

}  // namespace cca::recording::detail

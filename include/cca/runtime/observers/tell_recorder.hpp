// What a component has published goes into the frame of the beat.
#pragma once

#include <cstdint>

#include <cca/base/array_size.hpp>
#include <cca/base/eigen.hpp>
#include <cca/base/inlining.hpp>
#include <cca/runtime/observers/frame_layout.hpp>

namespace cca::detail {

template <class Graph, class Vector>
CCA_INLINE void tell_recorder(std::int64_t* frame, int output, const Vector& v, std::int64_t origin) {
  constexpr const auto& layout = frame_layout_of<Graph>;
  frame[layout.origin[array_size(output)]] = origin;
  auto* const coordinates = reinterpret_cast<double*>(frame + layout.at[array_size(output)]);
  Eigen::Map<typename Vector::PlainObject>{coordinates} = v;
}

}  // namespace cca::detail

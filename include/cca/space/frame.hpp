// Frames: coordinates are expressed in a frame, and a twist or a wrench acts at a frame's origin. Any class
// type can be a frame:
//
//   struct trunk;                             or, with a name of its own: cca::frame<"trunk">
//   struct foot_in_trunk : cca::space<cca::cartesian_position<trunk>, cca::axes<cca::x, cca::y, cca::z>> {};
//
// Errors: `frame.mismatch` where two samples of different frames are combined.
#pragma once

#include <string_view>
#include <type_traits>

#include <cca/base/fixed_string.hpp>

namespace cca {

template <fixed_string Name>
struct frame {
  static constexpr std::string_view name = Name.view();
};

namespace detail {

// The type of a domain type's `frames`.
template <class... Frames>
struct frame_list;

template <class Domain>
struct frames_of {
  using type = void;
};
template <class Domain>
  requires requires { typename Domain::frames; }
struct frames_of<Domain> {
  using type = typename Domain::frames;
};

}  // namespace detail

// A concept, not a constant: in their messages the compilers then name the two frames that differ.
template <class FrameA, class FrameB> concept SameFrame = std::is_same_v<FrameA, FrameB>;

template <class DomainA, class DomainB> concept SameFrames =
    std::is_same_v<typename detail::frames_of<DomainA>::type, typename detail::frames_of<DomainB>::type>;

}  // namespace cca

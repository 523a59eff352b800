// Frames: what coordinates are expressed in, and which point a twist or a wrench is that of. Any class type
// will do:
//
//   struct trunk;                             or, with a name of its own: cca::frame<"trunk">
//   struct foot_in_trunk : cca::space<cca::cartesian_position<trunk>, cca::axes<cca::x, cca::y, cca::z>> {};
//
// Errors: `frame.mismatch` where two samples meet that are not of the same frame.
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

// What a domain type with frames states as its `frames`.
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

// A concept, and not a constant, for its messages: the compilers then name the two frames that differ.
template <class FrameA, class FrameB> concept SameFrame = std::is_same_v<FrameA, FrameB>;

template <class DomainA, class DomainB> concept SameFrames =
    std::is_same_v<typename detail::frames_of<DomainA>::type, typename detail::frames_of<DomainB>::type>;

}  // namespace cca

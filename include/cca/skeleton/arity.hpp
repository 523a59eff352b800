// What a skeleton becomes if its parts don't fit together: a component without ports, whose message says why.
//
//   template <...>
//   struct blend : std::conditional_t<fits, detail::blend_of<...>, detail::bad_skeleton<problem>> {};
//
// The rule skeleton.arity reports it for the graph: the node's name, then this message.
#pragma once

#include <string_view>

#include <cca/base/text.hpp>

namespace cca::detail {

// Problem::message() is the rest of a sentence that begins with the node's name.
template <class Problem>
struct bad_skeleton {
  static constexpr auto sentence = Problem::message();
  static constexpr std::string_view wrong_arity = sentence.view();
};

// For a skeleton that chooses between sources or mixes them.
template <int Count>
struct too_few_sources {
  static constexpr text message() {
    text t;
    t << "has " << Count << (Count == 1 ? " source" : " sources")
      << ", but between fewer than two there is nothing to choose or to mix: name two or more, or leave it "
         "out and wire its reader directly";
    return t;
  }
};

}  // namespace cca::detail

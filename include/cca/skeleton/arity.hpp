// What a skeleton is made of where its parts don't come out even: a component without anything, which says
// why.
//
//   template <...> struct blend : std::conditional_t<is_even, detail::blend_of<...>, detail::uneven<problem>>
//   {};
//
// The rule skeleton.arity reports it as the message of the graph: the node, then what the skeleton says of
// itself.
#pragma once

#include <string_view>

#include <cca/base/text.hpp>

namespace cca::detail {

// Sentence::told() is the end of a sentence that begins with the node's name.
template <class Sentence>
struct uneven {
  static constexpr auto sentence = Sentence::told();
  static constexpr std::string_view wrong_arity = sentence.view();
};

// A skeleton that chooses between or mixes writers takes several.
template <int Count>
struct too_few_sources {
  static constexpr text told() {
    text t;
    t << "has " << Count << (Count == 1 ? " source" : " sources")
      << ", but between fewer than two there is nothing to choose or to mix: name two or more, or leave it "
         "out and wire its reader directly";
    return t;
  }
};

}  // namespace cca::detail

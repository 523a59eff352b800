// A check of types whose message names what is wrong:
//
//   template <class Component>
//   struct no_default {
//     static constexpr void tell(text& m) {
//       m << "component.no_default: " << type_name<Component>() << " has no constructor without arguments: ...";
//     }
//   };
//   static_assert(holds_or_tells<std::is_default_constructible_v<Component>, no_default<Component>>::value);
//
// If it does not hold, the compiler prints what `tell` writes. That is the only error of the assertion, and
// there is one for each mistake, however often it is checked. A sentence has no quotes and apostrophes:
// compilers print them with backslashes. After it the class or function goes on.
// Cost: an empty class if it holds. `tell` is compiled only if it does not.
#pragma once

#include <string_view>

#include <cca/base/messages/printed.hpp>
#include <cca/base/text.hpp>
#include <cca/base/type_name.hpp>

namespace cca::detail {

template <class Sentence>
struct told {
  static constexpr text said = [] {
    text one;
    Sentence::tell(one);
    return one;
  }();
  static constexpr std::string_view view() { return said.view(); }
};

// For a compiler that cuts texts: the same text as the name of a class without members. Where one stands for
// a bool, it prints that name, and does not say in three lines more where the class was declared.
template <auto... Text>
struct refused_as_bool {};
template <class Printed>
struct as_bool;
template <auto... Text>
struct as_bool<refused_graph<Text...>> {
  static constexpr refused_as_bool<Text...> shown{};
};

template <bool Holds, class Sentence, bool IsWhole = prints_whole_texts>
struct holds_or_tells {
  static constexpr bool value = true;
};
template <class Sentence>
struct holds_or_tells<false, Sentence, true> {
  static_assert(sizeof(printed<told<Sentence>>) != 0);
  static constexpr bool value = true;
};
template <class Sentence>
struct holds_or_tells<false, Sentence, false> {
  static_assert(as_bool<printed<told<Sentence>>>::shown);
  static constexpr bool value = true;
};

}  // namespace cca::detail

// What can be wrong in a body, and the sentences that name it. Used by body.hpp, which looks for it.
// Cost: the sentences are compiled only where one is told.
#pragma once

#include <cstddef>
#include <string_view>
#include <type_traits>

#include <cca/base/fixed_string.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/messages/tell_names.hpp>
#include <cca/mapping/serial_chain.hpp>
#include <cca/space/limits.hpp>
#include <cca/space/messages/space_in_words.hpp>

namespace cca::detail {

template <class Attachments, std::size_t Index, class Part, class Base>
struct closed_loop {
  static constexpr void tell(text& m) {
    m << "body.cycle: the parts of this body close a loop: ";
    if (Attachments::in_cycle(Index)) {
      m << "`" << Part::name << "`";
      auto at = static_cast<std::size_t>(Attachments::parent[Index]);
      for (std::size_t steps = 0; steps < Attachments::count; ++steps) {
        m << (steps == 0 ? " hangs on `" : ", which hangs on `") << Attachments::names[at] << "`";
        if (at == Index) break;
        at = static_cast<std::size_t>(Attachments::parent[at]);
      }
    } else {
      m << "the chain of `" << Part::name << "` ends in the frame "
        << type_name<typename Part::chain::tip_frame>()
        << (std::is_same_v<typename Part::chain::tip_frame, Base> ? ", which is that of the base"
                                                                  : ", in which another chain ends too");
    }
    m << "; a body is a tree or a star, so let each chain end in a frame of its own, and leave out the joint "
         "that closes the loop";
  }
};
template <class Part, class Base>
struct hangs_on_nothing {
  static constexpr void tell(text& m) {
    m << "body.unattached: the part `" << Part::name << "` hangs on nothing: its chain begins in the frame "
      << type_name<typename Part::chain::base>() << ", which is neither the base of the body, "
      << type_name<Base>()
      << ", nor the end of another part; begin it in one of those, or add the part that leads there";
  }
};
template <class Attachments>
struct two_parts_of_one_name {
  static constexpr void tell(text& m) {
    std::string_view twice;
    for (std::size_t i = 0; i < Attachments::count; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (Attachments::names[i] == Attachments::names[j]) twice = Attachments::names[i];
    m << "body.duplicate: two parts of this body are named `" << twice
      << "`, by which kinematics and descriptions find them; give each part a name of its own";
  }
};
template <class Axes, class... Parts>
struct shared_axis {
  static constexpr void tell(text& m) {
    const auto axis = axis_in_words(Axes(), repeated_in<Axes>::first());
    m << "body.duplicate: the parts ";
    const char* between = "`";
    const auto add = [&](bool shares, std::string_view part) {
      if (!shares) return;
      m << between << part << "`";
      between = " and `";
    };
    (add(has<typename Parts::chain::axes>(axis), Parts::name), ...);
    m << " of this body share the axis " << axis
      << "; give each part axes of its own, and let a joint that follows an axis of another part name it by "
         "`driven_by`";
  }

private:
  template <class Own>
  static constexpr bool has(std::string_view axis) {
    for (int i = 0; i < Own::count; ++i)
      if (axis_in_words(Own(), i) == axis) return true;
    return false;
  }
};
template <class Body, fixed_string Part>
struct unknown_part {
  static constexpr void tell(text& m) {
    m << "body.unknown_part: the body " << type_name<Body>() << " has no part `" << Part.view()
      << "` (the name in cca::part<name, chain>)";
    tell_names(m, Part.view(), Body::attached::names);
  }
};

template <class Type>
struct no_body {
  static constexpr void tell(text& m) {
    m << "body.no_body: the body of a robot is wanted, and `" << type_name<Type>();
    if constexpr (requires { typename Type::body; })
      m << "` is the description of one: write `" << type_name<Type>() << "::body`";
    else if constexpr (SerialChain<Type>)
      m << "` is a chain: write `cca::body<base, cca::part<name, " << type_name<Type>()
        << ">>`, or use what takes a chain, as cca::chain_pose";
    else m << "` is none: derive it from `cca::body<base, cca::part<...>...>`, as in cca/robot/body.hpp";
  }
};

}  // namespace cca::detail

// A body: body parts as types. Each part is a serial chain that is attached to another part or to the base of
// the body (the source document, figure 4.5).
//
//   struct oncilla_body : cca::body<trunk,
//       cca::part<"left_front_leg", left_front_leg, cca::driven_by<"left_front_hip", "left_front_knee">>,
//       cca::part<"left_front_paw", left_front_paw>, ...> {
//     static constexpr cca::link_inertia base{3.66, {0, 0, 0.02}, {...}};  // optional: inertia of the base
//   };
//
// The frames make the tree: a part is attached to the part whose chain ends in the frame where its own chain
// begins, else to the base. If all parts begin in the base, the body is a star. A part without joints is a
// fixed point on another part. The inertia of links is optional (`links` of the chain, serial_chain.hpp).
// `driven_by` names the resource nodes that move and measure a part; `cca::embodied<Body, Graph>` checks that
// they exist.
//
// The coordinates of a body are those of its parts, in order of declaration: `axes_of<Body>`. A joint may
// follow an axis of another part: `cca::prismatic(cca::along_y).driven_by("left_finger", -1)`. Errors:
// body.cycle, body.unattached, body.duplicate, body.no_body, mapping.bad_chain. Cost: constants. Example:
// tests/runtime/body/example.cpp; docs/body.md.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/component/component.hpp>
#include <cca/graph/items/graph.hpp>
#include <cca/mapping/serial_chain.hpp>
#include <cca/robot/body_mistakes.hpp>
#include <cca/base/fixed_string.hpp>
#include <cca/space/limits.hpp>
#include <cca/space/messages/space_in_words.hpp>

namespace cca {

// Names of resource nodes.
template <fixed_string... Nodes>
struct driven_by {
  static constexpr std::array<std::string_view, sizeof...(Nodes)> names{Nodes.view()...};
};

template <fixed_string Name, class Chain, class Nodes = driven_by<>>
struct part {
  static constexpr std::string_view name = Name.view();
  using chain = Chain;
  using nodes = Nodes;
};
template <fixed_string Name, class Type, class Nodes>
  requires(!SerialChain<Type>)
struct part<Name, Type, Nodes> : part<Name, detail::mended_chain<Type>, Nodes> {
  static_assert(detail::holds_or_tells<false, detail::no_chain<Type>>::value);
};

namespace detail {

// The part to which each part is attached: -1 the base, -2 nothing.
template <class Base, class... Parts>
struct attachments {
  using base_frame = Base;
  static constexpr std::size_t count = sizeof...(Parts);
  static constexpr int base = -1, nothing = -2;

  template <class Part>
  static constexpr int parent_of() {
    if (std::is_same_v<typename Part::chain::base, Base> || std::is_void_v<typename Part::chain::base>)
      return base;  // `void` of what is refused, and has its message
    int found = nothing, i = 0;
    ((found = std::is_same_v<typename Part::chain::base, typename Parts::chain::tip_frame> ? i : found, ++i),
     ...);
    return found;
  }
  static constexpr std::array<int, count> parent{parent_of<Parts>()...};

  // The number of chains that end in the same frame, plus one if it is the base: more than one makes a loop.
  template <class Part>
  static constexpr int ends_like() {
    return (int{std::is_same_v<typename Part::chain::tip_frame, typename Parts::chain::tip_frame>} + ... +
            int{std::is_same_v<typename Part::chain::tip_frame, Base>});
  }

  // Whether a part is attached, over other parts, to itself.
  static constexpr bool in_cycle(std::size_t i) {
    int at = parent[i];
    for (std::size_t steps = 0; at >= 0 && steps < count; ++steps) at = parent[static_cast<std::size_t>(at)];
    return at >= 0;
  }

  template <class Part, std::size_t Index>
  static constexpr bool closes_loop = in_cycle(Index) || ends_like<Part>() > 1;

  static constexpr std::array<std::string_view, count> names{Parts::name...};
  static constexpr bool distinct = [] {
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (names[i] == names[j]) return false;
    return true;
  }();
};

// Each rule is reported for the first part that breaks it, loops before unattached parts.
template <class Attachments, std::size_t Index, class... Parts>
constexpr auto check_cycles() {
  if constexpr (Index < sizeof...(Parts)) {
    using part = std::tuple_element_t<Index, std::tuple<Parts...>>;
    constexpr bool is_tree = !Attachments::template closes_loop<part, Index>;
    static_assert(
        holds_or_tells<is_tree,
                       closed_loop<Attachments, Index, part, typename Attachments::base_frame>>::value);
    if constexpr (is_tree) return check_cycles<Attachments, Index + 1, Parts...>();
    else return std::false_type{};
  } else {
    return std::true_type{};
  }
}
template <class Attachments, std::size_t Index, class... Parts>
constexpr auto check_attached() {
  if constexpr (Index < sizeof...(Parts)) {
    using part = std::tuple_element_t<Index, std::tuple<Parts...>>;
    constexpr bool is_attached = Attachments::parent[Index] != Attachments::nothing;
    static_assert(
        holds_or_tells<is_attached, hangs_on_nothing<part, typename Attachments::base_frame>>::value);
    if constexpr (is_attached) return check_attached<Attachments, Index + 1, Parts...>();
    else return std::false_type{};
  } else {
    return std::true_type{};
  }
}
template <class... Axes>
struct joined_axes {
  using type = axes<>;
};
template <class... A>
struct joined_axes<axes<A...>> {
  using type = axes<A...>;
};
template <class... A, class... B, class... Rest>
struct joined_axes<axes<A...>, axes<B...>, Rest...> : joined_axes<axes<A..., B...>, Rest...> {};

template <class Base, class... Parts>
constexpr auto check_body() {
  using all = attachments<Base, Parts...>;
  using all_axes = typename joined_axes<typename Parts::chain::axes...>::type;
  static_assert(holds_or_tells<all::distinct, two_parts_of_one_name<all>>::value);
  static_assert(holds_or_tells<(repeated_in<all_axes>::first() < 0), shared_axis<all_axes, Parts...>>::value);
  if constexpr (decltype(check_cycles<all, 0, Parts...>())::value) return check_attached<all, 0, Parts...>();
  else return std::false_type{};
}

}  // namespace detail

template <class Base, class... Parts>
struct body {
  using base_frame = Base;
  using parts = std::tuple<Parts...>;
  static_assert(((sizeof(Parts) != 0) && ...));  // a mistake in a part is reported from here
  using attached = detail::attachments<Base, Parts...>;
  using sound = decltype(detail::check_body<Base, Parts...>());
  using axes = typename detail::joined_axes<typename Parts::chain::axes...>::type;
};

// Short: all of it is printed where a rule is broken.
template <class Type> concept Body = requires {
  typename Type::parts;
  typename Type::attached;
  typename Type::base_frame;
};

namespace detail {

// Stands for what is no body, so that there is one error: the body of the description, one of the chain, or
// one without parts.
template <class Type>
struct mended_body {
  struct nowhere {};
  using type = body<nowhere>;
};
template <SerialChain Type>
struct mended_body<Type> {
  using type = body<typename Type::base, cca::part<"chain", Type>>;
};
template <class Type>
  requires(!Body<Type> && Body<typename Type::body>)
struct mended_body<Type> {
  using type = typename Type::body;
};

template <class Type>
struct body_or_refused {
  using type = Type;
};
template <class Type>
  requires(!Body<Type>)
struct body_or_refused<Type> : mended_body<Type> {
  static_assert(holds_or_tells<false, no_body<Type>>::value);
};
template <class Type>
using checked_body = typename body_or_refused<Type>::type;

}  // namespace detail

template <class Type>
using axes_of = typename detail::body_or_refused<Type>::type::axes;

// The index of a part by its name, -1 if there is none.
template <Body Type>
constexpr int part_index(std::string_view name) {
  for (std::size_t i = 0; i < Type::attached::count; ++i)
    if (Type::attached::names[i] == name) return static_cast<int>(i);
  return -1;
}

namespace detail {

// Whether a graph has a resource node of that name; a dotted path names one of an inner graph.
template <class Items>
struct nodes_in_items;
template <class Item>
struct resource_at {
  static constexpr bool has(std::string_view) { return false; }
};
template <class Type>
constexpr bool has_resource(std::string_view path) {
  if constexpr (Graph<Type>) return nodes_in_items<typename Type::cca_items>::has(path);
  else return false;
}
template <fixed_string Name, class Component, class Strategy>
struct resource_at<node<Name, Component, Strategy>> {
  static constexpr bool has(std::string_view path) {
    if (!path.starts_with(Name.view())) return false;
    const auto rest = path.substr(Name.view().size());
    if (rest.empty()) return IsResource<Component>;
    return rest.front() == '.' && has_resource<Component>(rest.substr(1));
  }
};
template <class... Items>
struct nodes_in_items<list<Items...>> {
  static constexpr bool has(std::string_view path) { return (resource_at<Items>::has(path) || ...); }
};

template <class Part, class Graph> concept DrivenIn = [] {
  for (const auto name : Part::nodes::names)
    if (!has_resource<Graph>(name)) return false;
  return true;
}();

template <class Part, class Graph>
struct driven_by_unknown {
  static constexpr void tell(text& m) {
    for (const auto name : Part::nodes::names)
      if (!has_resource<Graph>(name)) {
        m << "body.unattached: the part `" << Part::name << "` of this body is driven by the resource node `"
          << name << "`, which " << type_name<Graph>()
          << " lacks: a node with `sense` or `act` and that name; add it, or correct the name (for a node of "
             "an inner graph, its path)";
        return;
      }
  }
};
template <class Graph, class... Parts>
constexpr auto check_driven() {
  if constexpr (sizeof...(Parts) == 0) {
    return std::true_type{};
  } else {
    return []<class First, class... Rest>(std::type_identity<std::tuple<First, Rest...>>) {
      static_assert(holds_or_tells<DrivenIn<First, Graph>, driven_by_unknown<First, Graph>>::value);
      if constexpr (DrivenIn<First, Graph>) return check_driven<Graph, Rest...>();
      else return std::false_type{};
    }(std::type_identity<std::tuple<Parts...>>());
  }
}
template <class Graph, class Parts>
struct driven_in;
template <class Graph, class... Parts>
struct driven_in<Graph, std::tuple<Parts...>> {
  using checked = decltype(check_driven<Graph, Parts...>());
};

}  // namespace detail

// Refuses a graph without a resource node that a part of the body names:
// `static_assert(cca::embodied<body, graph>);`
template <class Type, class Graph>
inline constexpr bool embodied =
    detail::driven_in<Graph, typename detail::checked_body<Type>::parts>::checked::value;

}  // namespace cca

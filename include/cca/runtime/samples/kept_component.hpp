// A component as a controller keeps it: made by its default constructor.
// Errors: component.no_default.
#pragma once

#include <memory>
#include <type_traits>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/component/parameter_check.hpp>

namespace cca::detail {

template <class Component>
struct kept_component {
  [[no_unique_address]] Component component;
};
template <class Component>
struct no_default {
  static constexpr void tell(text& m) {
    m << "component.no_default: a controller makes its components, so each needs a constructor without "
         "arguments, and "
      << type_name<Component>()
      << " has none: give its constructor defaults; what differs between nodes is a template argument or one "
         "of its `parameters`";
  }
};
// It is never made, and no error follows from that.
template <class Component>
  requires(!std::is_default_constructible_v<Component>)
struct kept_component<Component> {
  static_assert(holds_or_tells<false, no_default<Component>>::value);
  kept_component() {}
  kept_component(const kept_component&) {}
  kept_component& operator=(const kept_component&) { return *this; }
  ~kept_component() {}
  union {
    Component component;
  };
};
// One that may leave parameters without a value: load() shall see which.
template <MayLeaveUnset Component>
  requires std::is_default_constructible_v<Component>
struct kept_component<Component> {
  [[no_unique_address]] parameters_marked before;
  [[no_unique_address]] Component component;
  kept_component() : before(std::addressof(component)) { forget_content(std::addressof(component)); }
};

}  // namespace cca::detail

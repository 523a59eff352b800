// Finds parameters without a value. BOOST_HANA_DEFINE_STRUCT gives its fields none, so a plain number, bool,
// enumeration or Eigen vector has one only if the component states it: `parameters p{1.5};`.
//
// A controller fills the place of the parameters with a mark before it constructs the component. Where the
// mark is still there when the parameters are checked, nobody has written a value. An integer of one or two
// bytes is not looked at, because its value may well be the mark.
//
// Cost: some stores where a controller is constructed, nothing in a beat.
// Errors: `cca::refused` from load(), as for values out of range.
#pragma once

#include <cstring>
#include <memory>

#include <cca/base/compiler.hpp>
#include <cca/component/schema.hpp>

namespace cca::detail {

inline constexpr unsigned char unset_mark = 0xA5;  // no bool, and of no enumeration that has names

// Only of a type that does not state its own first value, as `bounded`, `quantity` and `text` do.
constexpr bool may_be_unset(const schema& type) {
  switch (type.what) {
    case kind::boolean:
    case kind::choice:
      return true;
    case kind::integer:
      return !type.stated_range && type.bytes > 2;
    case kind::number:
      return !type.stated_range;
    case kind::array:
      return may_be_unset(*type.element);
    case kind::table:
      for (std::size_t i = 0; i < type.count; ++i)
        if (may_be_unset(*type.members[i].type)) return true;
      return false;
    default:
      return false;
  }
}

// Of a number, a bool, an enumeration.
inline bool is_unset(const schema& type, const void* value) {
  if (type.bytes == 0 || !may_be_unset(type)) return false;
  const auto* const at = static_cast<const unsigned char*>(value);
  for (std::size_t i = 0; i < type.bytes; ++i)
    if (at[i] != unset_mark) return false;
  return true;
}

// Not of a component whose parameters are in a virtual base: its constructor finds their place.
template <class Component> concept MayLeaveUnset = requires(typename Component::parameters& p) {
  static_cast<typename Component::parameters Component::*>(&Component::p);
  requires may_be_unset(schema_of<typename Component::parameters>);
};

// Before the component at this place is constructed.
struct parameters_marked {
  template <class Component>
  explicit parameters_marked(Component* at) {
    constexpr typename Component::parameters Component::* member = &Component::p;
    void* const p = std::addressof(at->*member);
    std::memset(p, unset_mark, sizeof(typename Component::parameters));
    forget_content(p);
  }
};

}  // namespace cca::detail

// The ports of `process` that make a component a mapping from one space to another: its input and its output.
#pragma once

#include <tuple>
#include <type_traits>

#include <cca/component/signature.hpp>
#include <cca/space/domain.hpp>

namespace cca::detail {

template <class Type>
constexpr bool is_status = std::is_same_v<typename Type::space::domain, status>;

// Inputs that must be wired, and outputs that are not a status.
template <class Port>
constexpr bool is_mapped = false;
template <fixed_string Name, class Space>
constexpr bool is_mapped<in<Name, Space>> = true;
template <fixed_string Name, class Space>
constexpr bool is_mapped<out<Name, Space>> = !is_status<out<Name, Space>>;
template <fixed_string Name, class Space>
constexpr bool is_mapped<maybe<Name, Space>> = !is_status<maybe<Name, Space>>;

template <class... Ports>
struct mapped_ports {
  static constexpr int count = (is_mapped<Ports> + ... + 0);
  using first = std::tuple_element_t<
      0,
      decltype(std::tuple_cat(
          std::declval<std::conditional_t<is_mapped<Ports>, std::tuple<Ports>, std::tuple<>>>()...,
          std::tuple<void*>()))>;
};

template <class List>
struct mapped_in;
template <class... Ports>
struct mapped_in<list<Ports...>> : mapped_ports<Ports...> {};

template <class Component>
using process_facts = function_facts<decltype(&Component::process)>;
template <class Component>
using mapped_inputs = mapped_in<typename process_facts<Component>::parameters>;
template <class Component>
using mapped_outputs = mapped_in<typename process_facts<Component>::results>;

// Spaces match when domain type (with its frame), ordered axes and rate agree.
template <class SpaceA, class SpaceB>
constexpr bool matching = same_coordinates<SpaceA, SpaceB> &&
                          (hz_of<typename SpaceA::rate> == hz_of<typename SpaceB::rate> ||
                           hz_of<typename SpaceA::rate> == 0 || hz_of<typename SpaceB::rate> == 0);

}  // namespace cca::detail

// Hooks: what a component does when the life-cycle moves. A hook that has the right name and another
// signature would be passed over in silence, so it is refused (component.hook_signature).
#pragma once

#include <concepts>
#include <string_view>
#include <type_traits>

namespace cca::detail {

struct hook_names {
  int on_load, on_save, on_start, on_stop, on_fault;
};

// A name that the component has too is ambiguous here, be it private, overloaded or a template.
template <class Component>
struct hook_probe : Component, hook_names {};

template <class Component> concept CanBeProbed =
    requires { sizeof(Component); } && std::is_class_v<Component> && !std::is_final_v<Component>;

template <class Component> concept NamesLoad =
    CanBeProbed<Component> && !requires { &hook_probe<Component>::on_load; };
template <class Component> concept NamesSave =
    CanBeProbed<Component> && !requires { &hook_probe<Component>::on_save; };
template <class Component> concept NamesStart =
    CanBeProbed<Component> && !requires { &hook_probe<Component>::on_start; };
template <class Component> concept NamesStop =
    CanBeProbed<Component> && !requires { &hook_probe<Component>::on_stop; };
template <class Component> concept NamesFault =
    CanBeProbed<Component> && !requires { &hook_probe<Component>::on_fault; };

template <class Component> concept OnLoad = requires(Component& c) {
  { c.on_load() } -> std::same_as<void>;
};
template <class Component> concept OnSave = requires(Component& c) {
  { c.on_save() } -> std::same_as<void>;
};
template <class Component> concept OnStart = requires(Component& c) {
  { c.on_start() } -> std::same_as<void>;
};
template <class Component> concept OnStop = requires(Component& c) {
  { c.on_stop() } -> std::same_as<void>;
};
template <class Component> concept OnFault = requires(Component& c) {
  { c.on_fault() } -> std::same_as<void>;
};

// As most have it: one question instead of ten.
template <class Component> concept NamesNone = CanBeProbed<Component> && requires {
  &hook_probe<Component>::on_load, &hook_probe<Component>::on_save, &hook_probe<Component>::on_start,
      &hook_probe<Component>::on_stop, &hook_probe<Component>::on_fault;
};

template <class Component>
constexpr std::string_view bad_hook() {
  if constexpr (NamesNone<Component>) return {};
  else if constexpr (NamesLoad<Component> && !OnLoad<Component>) return "on_load";
  else if constexpr (NamesSave<Component> && !OnSave<Component>) return "on_save";
  else if constexpr (NamesStart<Component> && !OnStart<Component>) return "on_start";
  else if constexpr (NamesStop<Component> && !OnStop<Component>) return "on_stop";
  else if constexpr (NamesFault<Component> && !OnFault<Component>) return "on_fault";
  else return {};
}

}  // namespace cca::detail

// Hooks: functions of a component that run when the life-cycle changes state. A hook with the right name and
// a wrong signature would never be called, so it is refused (component.hook_signature).
#pragma once

#include <concepts>
#include <string_view>
#include <type_traits>

#include <cca/base/compiler.hpp>

namespace cca::detail {

struct hook_names {
  int on_load, on_save, on_start, on_stop, on_fault;
};

// A name that the component also has is ambiguous here, even if it is private, overloaded or a template.
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

// Of a resource node: step() calls it instead of a beat while the controller is stopped or faulted, so that a
// robot can go on stopping. A deployment calls it once a period while it waits for other environments.
template <class Component> concept OnIdle = requires(Component& c) {
  { c.on_idle() } -> std::same_as<void>;
};

// load() calls it before on_load, once for each of its inputs that is wired: what it needs for this input,
// like a thread, is then made outside of the loop, and only where it is used.
template <class Component> concept OnWired = requires(Component& c, std::string_view input) {
  { c.on_wired(input) } -> std::same_as<void>;
};

// Most components have no hook: one check instead of ten keeps compiling fast.
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

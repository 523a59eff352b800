// What a controller's `load("trot.toml")` and `save("trot.toml")` do. A file has one table per component that
// has parameters: `[cpg]`, `[dmp.ode]`. Values that the file does not mention do not change.
// `load<"dmp">("dmp.toml")` and `save<"dmp">("dmp.toml")` do it for one component, or for those of an inner
// graph; what else the file has is left alone.
// Errors: `cca::refused`, one line per problem; then nothing has been changed.
#pragma once

#include <cca/base/compiler.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <toml++/toml.h>

#include <cca/base/file.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/component/parameters.hpp>
#include <cca/config/before_parsing.hpp>
#include <cca/config/by_path.hpp>
#include <cca/config/read.hpp>
#include <cca/config/write.hpp>

namespace cca::detail {

inline toml::table parse(std::string_view text, const problems& found) {
  if (const std::string wrong = complaint_before_parsing(text); !wrong.empty())
    throw refused(found.file() + wrong);
  try {
    return toml::parse(text, found.file());
  } catch (const toml::parse_error& error) {
    const auto at = error.source().begin;
    for (unsigned line = 1; line < at.line; ++line)
      text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    const auto line = text.substr(0, text.find_first_of("\r\n"));
    const char saw = at.column >= 1 && at.column <= line.size() ? line[at.column - 1] : ' ';
    throw refused(found.file() + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) +
                  ": not TOML: " + std::string(error.description()) + ", in `" + shortened(line) + "`" +
                  (is_letter(saw) ? " (put a text, or a number with its unit, in quotes)" : ""));
  }
}

// The TOML node at a component's path, or null. If a scope is not a table, `unknown_nodes` reports it.
inline const toml::node* node_at(const toml::table& root, std::string_view path) {
  const toml::table* table = &root;
  while (true) {
    const auto dot = path.find('.');
    const toml::node* node = table->get(path.substr(0, dot));
    if (dot == path.npos || !node) return node;
    table = node->as_table();
    if (!table) return nullptr;
    path.remove_prefix(dot + 1);
  }
}

// Reports each key that does not lead to a component, that is, to one of `paths`.
inline void unknown_nodes(const toml::table& table,
                          const std::string& scope,
                          const std::vector<std::string>& paths,
                          problems& found) {
  for (auto&& [key, node] : table) {
    const std::string path = member_path(scope, key.str());
    if (std::ranges::find(paths, path) != paths.end()) continue;
    if (std::ranges::any_of(paths, [&](const std::string& each) { return each.starts_with(path + "."); })) {
      if (const auto* inner = node.as_table()) unknown_nodes(*inner, path, paths, found);
      else found.add(node, path, "expected a table, got " + got(node));
      continue;
    }
    std::vector<std::string_view> siblings;
    for (const std::string_view each : paths) {
      if (!scope.empty() && !each.starts_with(scope + ".")) continue;
      const auto rest = each.substr(scope.empty() ? 0 : scope.size() + 1);
      const auto name = rest.substr(0, rest.find('.'));
      if (std::ranges::find(siblings, name) == siblings.end()) siblings.push_back(name);
    }
    found.add(&key.source(), path, unknown("node", key.str(), siblings));
  }
}

inline constexpr schema no_parameters{.what = kind::table};

inline void read_component(
    const toml::table& root, std::string_view path, const schema& type, void* values, problems& found) {
  const toml::node* node = node_at(root, path);
  if (node && !node->is_table()) found.add(*node, path, "expected a table, got " + got(*node));
  else read_table(type, values, node ? node->as_table() : nullptr, std::string(path), found);
}

template <class Component>
struct field_of_no_file {
  static constexpr void tell(text& m) {
    m << "parameters.unsupported_type: the field `" << unsupported_field<typename Component::parameters>()
      << "` of the parameters of " << type_name<Component>() << " has a type that no file can hold";
  }
};
template <HasParameters Component>
constexpr const schema& parameters_schema() {
  static_assert(holds_or_tells<unsupported_field<typename Component::parameters>().empty(),
                               field_of_no_file<Component>>::value);
  return schema_of<typename Component::parameters>;
}

// Whether a component is at a path, or in the inner graph there. Without a path each one is.
inline bool is_at_path(std::string_view component, std::string_view path) {
  return path.empty() ||
         (component.starts_with(path) && (component.size() == path.size() || component[path.size()] == '.'));
}

// All or nothing: reads twice, the first time into copies. `within`: the path of one node; empty: of all.
template <class Controller>
void load_parameters_from_text(Controller& controller,
                               std::string_view text,
                               std::string_view name,
                               std::string_view within = {}) {
  problems found(name);
  const toml::table root = parse(text, found);
  std::vector<std::string> paths;
  controller.for_each_component([&]<class Component>(std::string_view path, Component& component) {
    paths.emplace_back(path);
    if (!is_at_path(path, within)) return;
    if constexpr (HasParameters<Component>) {
      auto copy = component.p;
      read_component(root, path, parameters_schema<Component>(), &copy, found);
      if (found.count() > 0) return;
      double step = 0;
      if constexpr (requires { controller.step_of(path); }) step = controller.step_of(path);
      const toml::node* const where = node_at(root, path);
      for (auto& each : complaints_of(component, copy, path, step))
        found.add(where && !each.path.empty() ? &where->source() : nullptr, each.path, std::move(each.what));
    } else {
      read_component(root, path, no_parameters, nullptr, found);
    }
  });
  unknown_nodes(root, {}, paths, found);
  found.refuse();
  controller.for_each_component([&]<class Component>(std::string_view path, Component& component) {
    if constexpr (HasParameters<Component>)
      if (is_at_path(path, within))
        read_component(root, path, parameters_schema<Component>(), &component.p, found);
  });
}

inline constexpr std::size_t most_bytes_of_parameters = std::size_t{1} << 24;

template <class Controller>
void load_parameters(Controller& controller, std::string_view file, std::string_view within = {}) {
  load_parameters_from_text(controller, read_file(std::string(file), most_bytes_of_parameters), file, within);
}

// Refuses values that loading would refuse.
template <class Controller>
std::string parameters_text(Controller& controller, std::string_view name, std::string_view within = {}) {
  problems found(name);
  std::string text;
  controller.for_each_component([&]<class Component>(std::string_view path, Component& component) {
    using plain = std::remove_const_t<Component>;
    if constexpr (HasParameters<plain>) {
      if (!is_at_path(path, within)) return;
      std::vector<complaint> complaints;
      check(parameters_schema<plain>(), &component.p, std::string(path), complaints);
      for (auto& each : complaints) found.add(nullptr, each.path, std::move(each.what));
      write_table(parameters_schema<plain>(), &component.p, toml_path(path), text);
    }
  });
  found.refuse();
  return text;
}

template <class Controller>
void save_parameters(Controller& controller, std::string_view file, std::string_view within = {}) {
  write_file(std::string(file), parameters_text(controller, file, within));
}

// A controller's load(file), save(file), and set and parameter with a path call these. The core only declares
// the struct.
template <class Controller>
struct config_backend {
  static void load(Controller& controller, std::string_view file, std::string_view within = {}) {
    load_parameters(controller, file, within);
  }
  static void save(const Controller& controller, std::string_view file, std::string_view within = {}) {
    save_parameters(controller, file, within);
  }

  template <class Value>
  static void set(Controller& controller, std::string_view path, const Value& value) {
    set_parameter(controller, path, value);
  }
  template <class Type>
  static Type get(const Controller& controller, std::string_view path) {
    return parameter<Type>(controller, path);
  }
  static std::vector<std::string> paths(const Controller& controller) { return parameter_paths(controller); }
};

}  // namespace cca::detail

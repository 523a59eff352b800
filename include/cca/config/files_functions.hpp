// The functions of parameter files that need toml++. files.hpp includes this, unless they are compiled once
// for the program (cca/base/separate/compiled.hpp).
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include <cca/base/file.hpp>
#include <cca/base/refused.hpp>
#include <cca/config/before_parsing.hpp>
#include <cca/config/files.hpp>
#include <cca/config/problems.hpp>
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

inline void read_component(
    const toml::table& root, std::string_view path, const schema& type, void* values, problems& found) {
  const toml::node* node = node_at(root, path);
  if (node && !node->is_table()) found.add(*node, path, "expected a table, got " + got(*node));
  else read_table(type, values, node ? node->as_table() : nullptr, std::string(path), found);
}

// Whether a component is at a path, or in the inner graph there. Without a path each one is.
inline bool is_at_path(std::string_view component, std::string_view path) {
  return path.empty() ||
         (component.starts_with(path) && (component.size() == path.size() || component[path.size()] == '.'));
}

struct parameter_file::content {
  problems found;
  toml::table root;
  std::string within;
  std::vector<std::string> paths;  // of all components
};

CCA_CONFIG_INLINE parameter_file::parameter_file(std::string_view text,
                                                 std::string_view name,
                                                 std::string_view within)
    : in(std::make_unique<content>(content{problems(name), {}, std::string(within), {}})) {
  in->root = parse(text, in->found);
}

CCA_CONFIG_INLINE parameter_file::~parameter_file() = default;

CCA_CONFIG_INLINE bool parameter_file::read(std::string_view path, const schema& type, void* values) {
  in->paths.emplace_back(path);
  if (!is_at_path(path, in->within)) return false;
  read_component(in->root, path, type, values, in->found);
  return in->found.count() == 0;
}

CCA_CONFIG_INLINE void parameter_file::add(std::string_view path, std::vector<complaint> found) {
  const toml::node* const where = node_at(in->root, path);
  for (auto& each : found)
    in->found.add(where && !each.path.empty() ? &where->source() : nullptr, each.path, std::move(each.what));
}

CCA_CONFIG_INLINE void parameter_file::refuse() {
  unknown_nodes(in->root, {}, in->paths, in->found);
  in->found.refuse();
}

CCA_CONFIG_INLINE void parameter_file::put(std::string_view path, const schema& type, void* values) const {
  if (is_at_path(path, in->within)) read_component(in->root, path, type, values, in->found);
}

inline constexpr std::size_t most_bytes_of_parameters = std::size_t{1} << 24;

CCA_CONFIG_INLINE std::string text_of_parameter_file(const std::string& file) {
  return read_file(file, most_bytes_of_parameters);
}

CCA_CONFIG_INLINE void write_parameter_file(const std::string& file, std::string_view text) {
  write_file(file, text);
}

CCA_CONFIG_INLINE std::string parameters_as_toml(const std::vector<component_values>& all,
                                                 std::string_view name,
                                                 std::string_view within,
                                                 const std::vector<component_values>& before) {
  problems found(name);
  std::string text;
  for (const component_values& one : all) {
    if (!is_at_path(one.path, within)) continue;
    std::vector<complaint> complaints;
    check(*one.type, one.values, one.path, complaints);
    for (auto& each : complaints) found.add(nullptr, each.path, std::move(each.what));
    const auto was = std::ranges::find(before, one.path, &component_values::path);
    write_table(*one.type, one.values, was == before.end() ? nullptr : was->values, toml_path(one.path),
                text);
  }
  found.refuse();
  return text;
}

}  // namespace cca::detail

// What a controller's `load("trot.toml")` and `save("trot.toml")` do. A file has one table per component that
// has parameters: `[cpg]`, `[dmp.ode]`. Values that the file does not mention do not change.
// `load<"dmp">("dmp.toml")` and `save<"dmp">("dmp.toml")` do it for one component, or for those of an inner
// graph; what else the file has is left alone.
// Errors: `cca::refused`, one line per problem; then nothing has been changed.
#pragma once

#include <cca/base/compiler.hpp>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/separate/compiled.hpp>
#include <cca/component/parameters.hpp>
#include <cca/config/by_path.hpp>

namespace cca::detail {

// What a file says of the components of a controller. toml++ reads it: files_functions.hpp.
class parameter_file {
public:
  // Refuses what is not TOML. `within`: the path of one node; empty: of all.
  parameter_file(std::string_view text, std::string_view name, std::string_view within);
  parameter_file(const parameter_file&) = delete;
  parameter_file& operator=(const parameter_file&) = delete;
  ~parameter_file();

  // Reads a component's values, and notes what is wrong with them. False: something is wrong so far, or the
  // component is not asked for.
  bool read(std::string_view path, const schema& type, void* values);
  // What else speaks against the values of the component at a path.
  void add(std::string_view path, std::vector<complaint> found);
  // Throws if anything is wrong, or if a key leads to none of the components that were read.
  void refuse();
  // The same values again, which nothing speaks against.
  void put(std::string_view path, const schema& type, void* values) const;

private:
  struct content;
  std::unique_ptr<content> in;
};

std::string text_of_parameter_file(const std::string& file);
void write_parameter_file(const std::string& file, std::string_view text);
// Refuses values that loading would refuse. `name`: of the file, for messages. `before`: the same parameters
// at an earlier time, or none; where one was different then, a comment says what it was.
std::string parameters_as_toml(const std::vector<component_values>& all,
                               std::string_view name,
                               std::string_view within,
                               const std::vector<component_values>& before = {});

inline constexpr schema no_parameters{.what = kind::table};

// All or nothing: reads twice, the first time into copies. `within`: the path of one node; empty: of all.
template <class Controller>
void load_parameters_from_text(Controller& controller,
                               std::string_view text,
                               std::string_view name,
                               std::string_view within = {}) {
  parameter_file file(text, name, within);
  bool is_checked = false;
  // One function for both times: it is compiled for each type of component.
  const auto read = [&]<class Component>(std::string_view path, Component& component) {
    if constexpr (HasParameters<Component>) {
      if (is_checked) return file.put(path, parameters_schema<Component>(), &component.p);
      auto copy = component.p;
      if (!file.read(path, parameters_schema<Component>(), &copy)) return;
      double step = 0;
      if constexpr (requires { controller.step_of(path); }) step = controller.step_of(path);
      file.add(path, complaints_of(component, copy, path, step));
    } else if (!is_checked) {
      file.read(path, no_parameters, nullptr);
    }
  };
  controller.for_each_component(read);
  file.refuse();
  is_checked = true;
  controller.for_each_component(read);
}

template <class Controller>
void load_parameters(Controller& controller, std::string_view file, std::string_view within = {}) {
  load_parameters_from_text(controller, text_of_parameter_file(std::string(file)), file, within);
}

template <class Controller>
std::string parameters_text(const Controller& controller,
                            std::string_view name,
                            std::string_view within = {}) {
  return parameters_as_toml(values_to_save(controller), name, within);
}

template <class Controller>
void save_parameters(const Controller& controller, std::string_view file, std::string_view within = {}) {
  write_parameter_file(std::string(file), parameters_text(controller, file, within));
}
// With what each parameter was, in a copy of the controller's parameters.
template <class Controller>
void save_parameters_since(const Controller& controller,
                           const Controller& before,
                           std::string_view file,
                           std::string_view within) {
  write_parameter_file(std::string(file),
                       parameters_as_toml(values_to_save(controller), file, within, values_to_save(before)));
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
  static void save_since(const Controller& controller,
                         const Controller& before,
                         std::string_view file,
                         std::string_view within) {
    save_parameters_since(controller, before, file, within);
  }

  template <class Value>
  static void set(Controller& controller, std::string_view path, const Value& value) {
    set_parameter(controller, path, given_value_of(value));
  }
  template <class Type>
  static Type get(const Controller& controller, std::string_view path) {
    return parameter<Type>(controller, path);
  }
  static std::vector<std::string> paths(const Controller& controller) { return parameter_paths(controller); }
};

}  // namespace cca::detail

#if !CCA_HAS_COMPILED_CONFIG
#include <cca/config/files_functions.hpp>
#endif

// A controller's parameters by a path that is known only at run time, for tools and remote control.
//
//   c.set("cpg.frequency", 2.0);         a number, true, a text ("30 deg", "slope"), or several numbers
//   c.parameter("cpg.frequency")         "2.0", as a file spells it
//   c.parameter<double>("cpg.offset")    the number, in its SI unit
//   c.parameter_paths()                  all of them
//
// In any state, between two beats, from the thread that runs them. Errors: cca::refused, and nothing is
// changed: an unknown path (with the nearest one that exists), a wrong type, a value out of its range. Needs
// <cca/config.hpp>. docs/parameters.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cca::detail {

// Reading and writing parameters, in cca/config.hpp.
template <class Controller>
struct config_backend;
template <class Controller> concept HasConfig = requires { sizeof(config_backend<Controller>); };

// For assertions: of a concept the requirements would be listed, too.
template <class Controller>
constexpr bool has_config = HasConfig<Controller>;

// Without cca/config.hpp, after the message that says so.
struct no_config {
  static void load(const auto&...) {}
  static void save(const auto&...) {}
  static void set(const auto&...) {}
  template <class Type>
  static Type get(const auto&...) {
    return Type();
  }
  static std::vector<std::string> paths(const auto&...) { return {}; }
};
template <class Controller>
struct config_of {
  using type = no_config;
};
template <HasConfig Controller>
struct config_of<Controller> {
  using type = config_backend<Controller>;
};
template <class Controller>
using config_or_none = typename config_of<Controller>::type;

// To a recorder, if the controller has one.
template <class Controller>
void tell_parameters(Controller& c) {
  if constexpr (requires { c.parameters_changed(); }) c.parameters_changed();
}

template <class Controller>
class parameters_by_path {
public:
  template <class Value>
  void set(std::string_view path, const Value& value) {
    static_assert(has_config<Controller>,
                  "cca::controller: set(path, value) needs #include <cca/config.hpp>");
    config_or_none<Controller>::set(static_cast<Controller&>(*this), path, value);
    tell_parameters(static_cast<Controller&>(*this));
  }
  template <class Type = std::string>
  Type parameter(std::string_view path) const {
    static_assert(has_config<Controller>, "cca::controller: parameter(path) needs #include <cca/config.hpp>");
    return config_or_none<Controller>::template get<Type>(static_cast<const Controller&>(*this), path);
  }
  std::vector<std::string> parameter_paths() const {
    static_assert(has_config<Controller>,
                  "cca::controller: parameter_paths() needs #include <cca/config.hpp>");
    return config_or_none<Controller>::paths(static_cast<const Controller&>(*this));
  }
};

}  // namespace cca::detail

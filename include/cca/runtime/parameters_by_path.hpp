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
    static_assert(HasConfig<Controller>, "cca::controller: set(path, value) needs #include <cca/config.hpp>");
    config_backend<Controller>::set(static_cast<Controller&>(*this), path, value);
    tell_parameters(static_cast<Controller&>(*this));
  }
  template <class Type = std::string>
  Type parameter(std::string_view path) const {
    static_assert(HasConfig<Controller>, "cca::controller: parameter(path) needs #include <cca/config.hpp>");
    return config_backend<Controller>::template get<Type>(static_cast<const Controller&>(*this), path);
  }
  std::vector<std::string> parameter_paths() const {
    static_assert(HasConfig<Controller>,
                  "cca::controller: parameter_paths() needs #include <cca/config.hpp>");
    return config_backend<Controller>::paths(static_cast<const Controller&>(*this));
  }
};

}  // namespace cca::detail

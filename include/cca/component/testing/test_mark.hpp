// How the node of a cca::test_input (test_node.hpp) is known among components, also where only the parameters
// are: what a test is set to is not saved, because whoever loads a file wants no test.
#pragma once

namespace cca::detail {

template <class Component> concept TestNode = requires { Component::parameters::is_of_test_input; };

}  // namespace cca::detail

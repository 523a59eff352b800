// How the node of a cca::test_input is known among components: test_node.hpp.
#pragma once

namespace cca::detail {

template <class Component> concept TestNode = requires { Component::is_of_test_input; };

}  // namespace cca::detail

// A type that a template names only when it is itself asked for: so a file has many mistakes, and the
// compiler sees one.
#pragma once

#include <type_traits>

template <class Type, class Asked>
using late = typename std::conditional<sizeof(Asked) != 0, Type, Asked>::type;

// How the parameters of a recording differ from those of a component: by the schemas of their messages
// (messages/parameter_message.hpp). The message itself has only values: by them alone, a renamed parameter
// or two swapped ones would go unnoticed.
#pragma once

#include <string>
#include <string_view>

#include <cca/base/separate/compiled.hpp>

namespace cca::recording::detail {

// "the recording lacks `share`, and `part` is only in the recording"; empty: they have the same names in the
// same order, the same types, and units and choices that mean the same. Ranges may differ: values are
// checked.
std::string parameter_difference(std::string_view here, std::string_view there);

}  // namespace cca::recording::detail

#if !CCA_HAS_COMPILED_RECORD
#include <cca/record/replay/parameter_difference_functions.hpp>
#endif

// The parameters of a component as a message: the beat from which on they hold, then each field in SI units.
// A choice is its number, a text a string; fields of inner tables and elements of arrays are named
// `front_hip` and `gains_2`.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include <cca/base/separate/compiled.hpp>
#include <cca/component/parameters.hpp>
#include <cca/record/messages/cdr.hpp>
#include <cca/record/messages/sample_message.hpp>

namespace cca::recording::detail {

using cca::detail::kind;
using cca::detail::schema;

// ---- writing: no allocation, if `check` of the fields allocates nothing ----

void encode(const schema& type, const void* value, cdr_writer& to);

// More than the message ever takes.
std::size_t most_bytes(const schema& type);

// ---- reading ----

// False: it can't be the parameters of this component.
bool decode(const schema& type, void* value, cdr_reader& from);

// ---- the schema ----

void write_fields(const schema& type,
                  const std::string& name,
                  std::set<std::string>& taken,
                  std::ostream& to);

std::string parameter_schema(const schema& type);

}  // namespace cca::recording::detail

#if !CCA_HAS_COMPILED_RECORD
#include <cca/record/messages/parameter_message_functions.hpp>
#endif

// A sample as a message: the beat in which it was published, its time of origin in ns, its coordinates.
//
//   int64 beat
//   int64 origin  # ns
//   float64 hip  # rad, -0.9 to 0.9
//   float64 knee  # rad, -1.8 to 0
//
// In CDR these are words of eight bytes after the head, so that a sample is one copy.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include <cca/base/separate/compiled.hpp>
#include <cca/record/mcap/bytes.hpp>
#include <cca/space/space_schema.hpp>

namespace cca::recording::detail {

// A name that the languages for messages allow, and that no other field has.
std::string field_name(std::string_view wanted, std::set<std::string>& taken);

std::string sample_schema(const cca::detail::space_info& of);

// What a viewer can't read from the fields.
text_map sample_metadata(const cca::detail::space_info& of);

// "leg_angles" of `my::leg_angles`, with the letters that a type of ROS 2 may have.
std::string message_type(std::string_view space);

std::string topic_of(std::string_view path);

}  // namespace cca::recording::detail

#if !CCA_HAS_COMPILED_RECORD
#include <cca/record/messages/sample_message_functions.hpp>
#endif

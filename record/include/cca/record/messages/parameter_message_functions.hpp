// The functions that write and read the parameters of a component as a message. parameter_message.hpp
// includes this, unless they are compiled once for the program (cca/base/separate/compiled.hpp).
#pragma once

#include <cstdint>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include <cca/record/messages/parameter_message.hpp>
#include <cca/record/messages/sample_message.hpp>

namespace cca::recording::detail {

CCA_RECORD_INLINE void encode(const schema& type, const void* value, cdr_writer& to) {
  switch (type.what) {
    case kind::boolean:
      to.add(static_cast<std::uint8_t>(type.integer(value)));
      break;
    case kind::integer:
    case kind::choice:
      to.add(type.integer(value));
      break;
    case kind::number:
      to.add(type.number(value));
      break;
    case kind::text:
      to.add(type.characters(value));
      break;
    case kind::array:
      for (std::size_t i = 0; i < type.count; ++i) encode(*type.element, type.at(value, i), to);
      break;
    case kind::table:
      for (std::size_t i = 0; i < type.count; ++i)
        encode(*type.members[i].type, type.members[i].of(value), to);
      break;
    case kind::unsupported:
      break;
  }
}

CCA_RECORD_INLINE std::size_t most_bytes(const schema& type) {
  std::size_t all = 0;
  switch (type.what) {
    case kind::text:
      return type.count + 12;
    case kind::array:
      return type.count * most_bytes(*type.element);
    case kind::table:
      for (std::size_t i = 0; i < type.count; ++i) all += most_bytes(*type.members[i].type);
      return all;
    default:
      return 16;
  }
}

CCA_RECORD_INLINE bool decode(const schema& type, void* value, cdr_reader& from) {
  const auto writable = [](const void* field) { return const_cast<void*>(field); };
  switch (type.what) {
    case kind::boolean: {
      const auto number = from.number<std::uint8_t>();
      if (from.is_bad() || number > 1) return false;
      type.set_integer(value, number);
      return true;
    }
    case kind::integer:
    case kind::choice: {
      const auto number = from.number<std::int64_t>();
      if (from.is_bad()) return false;
      if (type.what == kind::choice ? number < 0 || number >= static_cast<std::int64_t>(type.count)
                                    : number < type.lowest || number > type.highest)
        return false;
      type.set_integer(value, number);
      return true;
    }
    case kind::number: {
      const auto number = from.number<double>();
      if (from.is_bad()) return false;
      type.set_number(value, number);
      return true;
    }
    case kind::text: {
      const std::string_view text = from.text();
      return !from.is_bad() && type.set_characters(value, text);
    }
    case kind::array:
      for (std::size_t i = 0; i < type.count; ++i)
        if (!decode(*type.element, writable(type.at(value, i)), from)) return false;
      return true;
    case kind::table:
      for (std::size_t i = 0; i < type.count; ++i)
        if (!decode(*type.members[i].type, writable(type.members[i].of(value)), from)) return false;
      return true;
    case kind::unsupported:
      break;
  }
  return false;
}

CCA_RECORD_INLINE void write_fields(const schema& type,
                                    const std::string& name,
                                    std::set<std::string>& taken,
                                    std::ostream& to) {
  const auto field = [&](const char* of) -> std::ostream& {
    return to << of << ' ' << field_name(name, taken);
  };
  switch (type.what) {
    case kind::boolean:
      field("bool") << '\n';
      break;
    case kind::integer:
      field("int64") << '\n';
      break;
    case kind::choice:
      field("int64") << "  #";
      for (std::size_t i = 0; i < type.count; ++i) to << (i ? ", " : " ") << i << ' ' << type.names[i];
      to << '\n';
      break;
    case kind::number:
      field("float64");
      if (!type.unit.empty() || type.stated_range) to << "  #";
      if (!type.unit.empty()) to << ' ' << type.unit;
      if (type.stated_range) to << (type.unit.empty() ? " " : ", ") << type.lower << " to " << type.upper;
      to << '\n';
      break;
    case kind::text:
      field("string") << '\n';
      break;
    case kind::array:
      for (std::size_t i = 0; i < type.count; ++i)
        write_fields(*type.element, name + "_" + std::to_string(i), taken, to);
      break;
    case kind::table:
      for (std::size_t i = 0; i < type.count; ++i)
        write_fields(*type.members[i].type,
                     (name.empty() ? "" : name + "_") + std::string(type.members[i].name), taken, to);
      break;
    case kind::unsupported:
      break;
  }
}

CCA_RECORD_INLINE std::string parameter_schema(const schema& type) {
  std::ostringstream text;
  std::set<std::string> taken{"beat"};
  text << "int64 beat  # from which on they hold\n";
  write_fields(type, {}, taken, text);
  return text.str();
}

}  // namespace cca::recording::detail

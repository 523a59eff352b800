#pragma once
// JSON as all programs write it: fields in the order in which they were set, numbers with all their digits,
// null for what is no finite number.
#include <iomanip>
#include <ostream>

#include <nlohmann/json.hpp>

namespace trot {

using json = nlohmann::ordered_json;

inline void write(std::ostream& out, const json& value) { out << std::setw(2) << value << '\n'; }

}  // namespace trot

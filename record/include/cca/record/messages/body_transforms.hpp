// Where the links of a body are, as tf2_msgs/msg/TFMessage: for each link its place in the one on which it
// hangs, the ends of the parts, and the base in the world.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/separate/compiled.hpp>
#include <cca/record/messages/body_description.hpp>
#include <cca/record/messages/cdr.hpp>

namespace cca::recording::detail {

inline constexpr std::string_view transforms_type = "tf2_msgs/msg/TFMessage",
                                  description_type = "std_msgs/msg/String",
                                  description_schema = "string data\n";

std::string transforms_schema();

class body_transforms {
public:
  // `turns_in`: the frame in which the base is turned; empty: none.
  body_transforms(body_description of, std::string turns_in);

  const body_description& description() const { return d; }

  // `angles` over the axes of the body, `base`: its orientation, x y z w, or null. Until the next call.
  std::span<const unsigned char> made_of(const double* angles, const double* base, std::int64_t stamp);

private:
  static void add(cdr_writer& to,
                  std::int64_t stamp,
                  std::string_view parent,
                  std::string_view child,
                  const std::array<double, 3>& at,
                  const std::array<double, 4>& turn);

  body_description d;
  std::string world;
  std::vector<unsigned char> memory;
};

}  // namespace cca::recording::detail

#if !CCA_HAS_COMPILED_RECORD
#include <cca/record/messages/body_transforms_functions.hpp>
#endif

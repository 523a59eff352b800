// Rules about parameters: the message of each mistake, and that the mended one is sound.
#include <string>

#include "rules_parts.hpp"

namespace {

using namespace parts;

struct with_pointer : source<> {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain), (void*, table));
  };
  parameters p{};
};
struct with_gain : source<> {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain), (bool, on));
  };
  parameters p{1, true};
};

struct parameter : khz<cca::node<"a", with_pointer>> {};
struct parameter_mended : khz<cca::node<"a", with_gain>> {};
static_assert(tells<parameter, parameter_mended>(
    {"parameters.unsupported_type", "a",
     "`a` (with_pointer): its parameter `table` is a `void*`, which no file can hold: use a number, bool, "
     "enum class, cca::bounded, cca::quantity, cca::text, a std::array or Eigen vector of fixed size of "
     "these, or a struct with BOOST_HANA_DEFINE_STRUCT"}));

struct tuning {
  BOOST_HANA_DEFINE_STRUCT(tuning, (int, order), (std::string, model));
};
struct with_inner_text : source<> {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain), (tuning, filter));
  };
  parameters p{};
};

struct parameter_nested : khz<cca::node<"a", with_inner_text>> {};
struct parameter_nested_mended : khz<cca::node<"a", with_gain>> {};
static_assert(tells<parameter_nested, parameter_nested_mended>(
    {"parameters.unsupported_type", "a",
     "`a` (with_inner_text): its parameter `filter.model` is a `std::string`, which no file can hold: use a "
     "number, bool, enum class, cca::bounded, cca::quantity, cca::text, a std::array or Eigen vector of "
     "fixed size of these, or a struct with BOOST_HANA_DEFINE_STRUCT"}));

struct without_p : source<> {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain));
  };
};

struct parameter_forgotten : khz<cca::node<"a", without_p>> {};
struct parameter_forgotten_mended : khz<cca::node<"a", with_gain>> {};
static_assert(tells<parameter_forgotten, parameter_forgotten_mended>(
    {"parameters.unsupported_type", "a",
     "`a` (without_p) has a struct `parameters` but no public member `parameters p`, so nothing would ever "
     "set them: add `parameters p{...};` with the default values"}));

struct without_names : source<> {
  struct parameters {
    double gain;
  };
  parameters p{};
};

struct parameter_unknown : khz<cca::node<"a", without_names>> {};
struct parameter_unknown_mended : khz<cca::node<"a", with_gain>> {};
static_assert(tells<parameter_unknown, parameter_unknown_mended>(
    {"parameters.unsupported_type", "a",
     "`a` (without_names): its parameter `p` is a `without_names::parameters`, whose fields are unknown: "
     "name them in it with BOOST_HANA_DEFINE_STRUCT, and make it copyable"}));

struct without_inner_names : source<> {
  struct spring {
    double stiffness = 1, rest = 0;
  };
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain), (spring, hip_spring));
  };
  parameters p{};
};

struct parameter_unknown_inside : khz<cca::node<"a", without_inner_names>> {};
static_assert(tells<parameter_unknown_inside, parameter_mended>(
    {"parameters.unsupported_type", "a",
     "`a` (without_inner_names): its parameter `hip_spring` is a `without_inner_names::spring`, which no "
     "file can hold: use a number, bool, enum class, cca::bounded, cca::quantity, cca::text, a std::array "
     "or Eigen vector of fixed size of these, or a struct with BOOST_HANA_DEFINE_STRUCT"}));

}  // namespace

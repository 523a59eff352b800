// Names of types as messages and pictures show them.
#include <cca/base/type_name.hpp>

namespace outer {
struct hip {};
template <class...>
struct leg {
  template <class>
  struct in {};
};
namespace {
struct knee {};
template <class>
struct foot {
  struct toe {};
};
}  // namespace
}  // namespace outer

using cca::detail::type_name;

static_assert(type_name<double>() == "double");
static_assert(type_name<outer::knee>() == "knee");
static_assert(type_name<outer::leg<outer::hip, outer::knee>>() == "leg<hip, knee>");
static_assert(type_name<outer::leg<>::in<outer::knee>>() == "in<knee>");
static_assert(
    type_name<outer::leg<outer::hip, outer::foot<outer::leg<outer::knee, double>>::toe, outer::hip>>() ==
    "leg<hip, toe, hip>");

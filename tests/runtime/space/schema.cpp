// The schema of a space as text.
#include <doctest/doctest.h>

#include <cca/space/domain.hpp>
#include <cca/space/space_schema.hpp>

namespace {

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}};
};
struct knee : cca::dimension<"knee"> {};
struct base : cca::frame<"base"> {};
struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};
struct attitude : cca::space<cca::orientation<base>, cca::axes<cca::x, cca::y, cca::z>> {};

}  // namespace

TEST_CASE("schema: a line for each number, with unit and limits") {
  // [schema]
  constexpr auto schema = cca::schema_of<leg_angles>;
  static_assert(schema.field(0).name() == "hip" && schema.field(0).unit == "rad");
  static_assert(schema.field(1).offset == 8 && schema.bytes() == 16);
  CHECK_EQ(schema.text(),
           "float64 hip  # rad, -0.9 to 0.9\n"
           "float64 knee  # rad\n");
  // [schema end]
  CHECK_EQ(cca::schema_of<attitude>.text(), "float64 qx\nfloat64 qy\nfloat64 qz\nfloat64 qw\n");
}

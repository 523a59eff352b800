// The schema of a space at compile time: names, units, layout, and hashes that both compilers must agree on.
#include <cca/space/array.hpp>
#include <cca/space/domain.hpp>
#include <cca/space/record.hpp>
#include <cca/space/space_schema.hpp>

namespace {

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.8, 0.0}};
};
struct other_knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.7, 0.0}};
};
struct odd_name : cca::dimension<"front left-hip"> {};
struct base : cca::frame<"base"> {};
struct tip : cca::frame<"tip"> {};
using xyz = cca::axes<cca::x, cca::y, cca::z>;

struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};
struct same_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};
struct slower : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<500>> {};
struct swapped : cca::space<cca::joint_angles, cca::axes<knee, hip>, cca::rate<1000>> {};
struct other_limits : cca::space<cca::joint_angles, cca::axes<hip, other_knee>, cca::rate<1000>> {};
struct velocities : cca::space<cca::joint_velocities, cca::axes<hip, knee>, cca::rate<1000>> {};
struct plain : cca::space<cca::number, cca::axes<odd_name>> {};
struct placed : cca::space<cca::pose<base>, xyz> {};
struct at_tip : cca::space<cca::pose<tip>, xyz> {};
struct in_named : cca::space<cca::pose<cca::frame<"world">>, xyz> {};  // a name with `>>` in it
struct moving : cca::space<cca::twist<tip, base>, xyz> {};
struct both_legs : cca::array_of<leg_angles, 2> {};
struct raw : cca::space<cca::record<3>, cca::axes<hip>> {};

using cca::schema_of;

constexpr auto legs = schema_of<leg_angles>;
static_assert(legs.field_count() == 2 && legs.bytes() == 16 && legs.hz() == 1000);
static_assert(legs.domain() == "joint_angles");
static_assert(legs.field(0).name() == "hip" && legs.field(0).unit == "rad" && legs.field(0).offset == 0);
static_assert(legs.field(1).name() == "knee" && legs.field(1).offset == 8);
static_assert(legs.field(1).lower == -1.8 && legs.field(1).upper == 0);
static_assert(schema_of<plain>.field(0).name() == "front_left_hip" && schema_of<plain>.field(0).unit.empty());
static_assert(schema_of<placed>.field(6).name() == "qw" && schema_of<placed>.field(2).unit == "m");
static_assert(schema_of<moving>.field(3).name() == "linear_x" && schema_of<moving>.field(3).unit == "m/s");
static_assert(schema_of<raw>.field(2).name() == "c2" && schema_of<raw>.bytes() == 24);
static_assert(schema_of<both_legs>.field(2).name() == "hip1" && schema_of<both_legs>.field(2).unit == "rad");

// The name of the space does not count; all else does.
static_assert(legs.hash() == schema_of<same_angles>.hash());
static_assert(legs.hash() != schema_of<slower>.hash() && legs.hash() != schema_of<swapped>.hash());
static_assert(legs.hash() != schema_of<other_limits>.hash() && legs.hash() != schema_of<velocities>.hash());
static_assert(schema_of<placed>.hash() != schema_of<at_tip>.hash());

// Written down, so that g++ and clang, today's and tomorrow's, give the same.
static_assert(legs.hash() == 5231017890460239179ull);
static_assert(schema_of<placed>.hash() == 12258844807943802775ull);
static_assert(schema_of<moving>.hash() == 9993594578919412939ull);
static_assert(schema_of<in_named>.hash() == 17456290755501120029ull);

}  // namespace

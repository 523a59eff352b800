// What BOOST_HANA_DEFINE_STRUCT takes for a missing comma, and what not.
#include <array>

#include <cca/component/parameters.hpp>

using cca::detail::has_all_commas;

static_assert(has_all_commas("parameters"));
static_assert(has_all_commas("parameters, (double, gain), (int, count)"));
static_assert(has_all_commas("parameters,(double,gain),(int,count)"));
static_assert(has_all_commas("parameters, (cca::bounded<double, 0.0, 5.0>, offset), (decltype(f(1, 2)), x)"));

static_assert(has_all_commas("values<T>, (T, gr\u00f6\u00dfe), (int, $x), (::other, _1)"));

static_assert(!has_all_commas("parameters, (double gain)"));
static_assert(!has_all_commas("parameters, (double, gain), (int count)"));
static_assert(!has_all_commas("parameters, (double, gain) (int, count)"));
static_assert(!has_all_commas("parameters (double, gain)"));
static_assert(!has_all_commas("parameters, double gain"));
static_assert(!has_all_commas("parameters, (cca::bounded<double, 0.0, 5.0> offset)"));
static_assert(!has_all_commas("parameters, (decltype(f(1, 2)) x)"));

// All of it is Hana's: fields that another macro lists, none at all, and more than 32.
#define TWO (int, a), (std::array<double, 2>, b)
#define EIGHT(n)                                                                                  \
  (double, n##1), (double, n##2), (double, n##3), (double, n##4), (double, n##5), (double, n##6), \
      (double, n##7), (double, n##8)
struct sums {
  BOOST_HANA_DEFINE_STRUCT(sums, (double, gain), TWO);
};
struct nothing {
  BOOST_HANA_DEFINE_STRUCT(nothing);
};
struct many {
  BOOST_HANA_DEFINE_STRUCT(many, EIGHT(a), EIGHT(b), EIGHT(c), EIGHT(d), TWO);
};
using cca::detail::schema_of;
static_assert(schema_of<sums>.count == 3 && schema_of<sums>.members[2].name == "b");
static_assert(schema_of<nothing>.count == 0);
static_assert(schema_of<many>.count == 34 && schema_of<many>.members[31].name == "d8");

// EXPECT: mapping\.chain: a mapping of this chain gives [a-z_]+ \(.*\), and the next one takes [a-z_]+ \(.*\): the [a-z ]+ differ
// Of two joints of a chain that do not meet, the first is reported.
#include <cca/mapping/mapping_chain.hpp>

struct one : cca::space<cca::number, cca::axes<cca::x>> {};
struct two : cca::space<cca::number, cca::axes<cca::x, cca::y>> {};

struct doubled {
  Eigen::Vector2d operator()(const cca::sample<one>& a) const { return {a[cca::x{}], 2 * a[cca::x{}]}; }
};
struct sum {
  double operator()(const Eigen::Vector2d& v) const { return v.sum(); }
};

using spread = cca::mapping<one, two, doubled>;
using gathered = cca::mapping<two, one, sum>;

#if CCA_REJECT
cca::mapping_chain<spread, spread, spread> chain;
#else
cca::mapping_chain<spread, gathered, spread> chain;
#endif

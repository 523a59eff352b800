// EXPECT: learner\.model: the model [a-z_]+ has no title, by which a file of learned parameters is recognised: add `static std::string title\(\)` to it
// A model states a title, so that a file of another model is refused.
#include <cca/adaptive/recursive_least_squares.hpp>

struct line {
  using input = Eigen::Vector2d;
  using output = Eigen::Vector2d;
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (Eigen::Matrix2d, weights));
  };
  static Eigen::Vector2d regressors(const input& x) { return x; }
  static output answer(const parameters& p, const input& x) { return p.weights * regressors(x); }
#if CCA_REJECT
#else
  static std::string title() { return "line"; }
#endif
};

using learner = cca::recursive_least_squares<line>;
static_assert(sizeof(learner::learned) > 0);

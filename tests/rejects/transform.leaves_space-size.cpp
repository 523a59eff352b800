// EXPECT: transform\.leaves_space: the function [a-z_]+ of this transformation returns a matrix of 1 x 1, but its input is in
// The result has another size.
#include <cca/mapping/mapping.hpp>

struct frequencies : cca::space<cca::frequency, cca::axes<cca::x, cca::y>> {};

struct slower {
#if CCA_REJECT
  Eigen::Matrix<double, 1, 1> operator()(const Eigen::Vector2d& f) const { return 0.5 * f.head<1>(); }
#else
  Eigen::Vector2d operator()(const Eigen::Vector2d& f) const { return 0.5 * f; }
#endif
};

cca::transformation<frequencies, slower> transformation;

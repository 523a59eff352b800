// A sample of 131,072 numbers: half a million steps of a loop over its coordinates are more than clang takes
// in one constant (docs/compilers.md, Clang's steps). Eigen's limit for what lies on the stack is lifted.
#define EIGEN_STACK_ALLOCATION_LIMIT 0
#include <cca/cca.hpp>

namespace large_samples {

struct brightness {
  double lower, upper;
  static constexpr std::string_view unit = "";
  static constexpr auto on_nan = cca::nan_policy::zero;
};
struct grey_values : cca::detail::linear_domain {
  using quantity = brightness;
  static constexpr int width(int) { return 256 * 512; }
  static constexpr double zero(int, int) { return 0; }
  template <class Self>
  struct methods : cca::detail::additive<Self> {};
};
struct sensor : cca::dimension<"sensor"> {};
struct image : cca::space<grey_values, cca::axes<sensor>> {};
struct mean_value : cca::space<cca::number, cca::axes<sensor>> {};

struct camera {
  auto process(cca::beat now) -> cca::out<"image", image> {
    cca::out<"image", image> taken;
    taken.vector().setConstant(static_cast<double>(now.index()));
    return taken;
  }
};
struct mean {
  auto process(cca::in<"image", image> of) -> cca::out<"mean", mean_value> { return of.vector().mean(); }
};

struct seen : cca::graph<cca::rate<100>,
                         cca::node<"camera", camera>,
                         cca::node<"at_once", mean>,
                         cca::node<"later", mean>,
                         cca::node<"queued", mean>,
                         cca::node<"grey", mean, cca::timed<2>>,
                         cca::wire<"camera.image", "at_once.image">,
                         cca::wire<"camera.image", "later.image", cca::delayed<2>>,
                         cca::wire<"camera.image", "queued.image", cca::queue<2, cca::drop_oldest>>,
                         cca::wire<"camera.image", "grey.image", cca::delayed<3>, cca::initial<0.5>>,
                         cca::observe<"*.mean">> {};

}  // namespace large_samples

static_assert(cca::detail::has_zeros<large_samples::image>);
static_assert(cca::well_formed<large_samples::seen>);

void take_large_samples(cca::controller<large_samples::seen>& c) { c.step(); }

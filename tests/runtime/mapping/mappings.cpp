// Mappings made from functions, chains of them, and rigid motions.
#include <doctest/doctest.h>

#include <cca/component/parameters.hpp>

#include "spaces.hpp"

using namespace mapping_test;

namespace {

// The expected values, by Eigen's matrices instead of the library's quaternions.
Eigen::Matrix3d matrix(const cca::placement& p) {
  const auto [x, y, z, w] = p.rotation;
  Eigen::Matrix3d m;
  m << 1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w),  //
      2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w),   //
      2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y);
  return m;
}
Eigen::Vector3d vector(const cca::placement& p) {
  return {p.translation[0], p.translation[1], p.translation[2]};
}
Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return m;
}

Eigen::Vector4d quaternion(laws::source& random) { return cca::rotation::exp(random.vector(1.5)); }

struct doubled {
  auto operator()(const cca::sample<foot_in_hip>& p) const {
    return cca::sample<foot_in_hip>(2 * p.vector());
  }
};
struct halved {
  Eigen::Vector3d operator()(const Eigen::Vector3d& v) const { return v / 2; }
};
struct scaled {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, factor));
  };
  parameters p{3};
  Eigen::Vector3d operator()(const Eigen::Vector3d& v) const { return p.factor * v; }
};
struct height {
  double operator()(const cca::sample<foot_in_hip>& p) const { return p[cca::z{}]; }
};
struct heights : cca::space<cca::number, cca::axes<cca::z>> {};

// Still a mapping: two outputs, one of them a status, an optional input and the beat.
struct mode : cca::dimension<"mode"> {};
struct modes : cca::space<cca::status, cca::axes<mode>> {};
struct counting {
  auto process(cca::in<"a", foot_in_hip> a, cca::optional_in<"near", foot_in_hip> near, cca::beat now)
      -> std::tuple<cca::out<"mode", modes>, cca::out<"b", foot_in_hip>> {
    return {near ? -1.0 : static_cast<double>(now.index()),
            a.vector() + Eigen::Vector3d::Constant(static_cast<double>(now.index()))};
  }
};
struct two_inputs {
  auto process(cca::in<"a", foot_in_hip>, cca::in<"b", foot_in_hip> b) -> cca::out<"c", foot_in_hip> {
    return b;
  }
};
// Outputs the origin of its input, and whether it is fresh.
struct noting {
  auto process(cca::in<"a", foot_in_hip> a) -> cca::out<"b", foot_in_hip> {
    return Eigen::Vector3d(static_cast<double>(a.origin()), a.fresh(), 0);
  }
};
struct sink {
  void process(cca::in<"a", foot_in_hip>) {}
};

static_assert(cca::Mapping<cca::mapping<foot_in_hip, heights, height>> &&
              !cca::Transformation<cca::mapping<foot_in_hip, heights, height>>);
static_assert(cca::Transformation<cca::transformation<foot_in_hip, doubled>>);
static_assert(cca::Mapping<counting> && cca::Transformation<counting>);
static_assert(!cca::Mapping<two_inputs> && !cca::Mapping<sink> && !cca::Mapping<int>);
static_assert(std::is_same_v<cca::input_space<counting>, foot_in_hip> &&
              std::is_same_v<cca::output_space<counting>, foot_in_hip>);

template <class Space>
bool near(const typename Space::vector_type& a, const typename Space::vector_type& b) {
  if constexpr (Space::size == 4) return std::min((a - b).norm(), (a + b).norm()) < 1e-12;
  else return (a - b).norm() < 1e-12;
}
template <class Space>
typename Space::vector_type random_point(laws::source& random) {
  typename Space::vector_type v;
  for (int i = 0; i < Space::size; ++i) v[i] = random(-2, 2);
  if constexpr (Space::size == 4) v = quaternion(random);
  if constexpr (Space::size == 7) v.template tail<4>() = quaternion(random);
  return v;
}

template <class From, class To, class Where = hip_in_trunk>
struct change_model {
  using forward = cca::frame_change<Where, From, To>;
  using inverse = cca::frame_change<cca::inverse_of<Where>, To, From>;
  static auto random(laws::source& r) { return random_point<From>(r); }
  static bool close(const typename From::vector_type& a, const typename From::vector_type& b) {
    return near<From>(a, b);
  }
};

struct scale_model {
  using forward = cca::transformation<foot_in_hip, doubled>;
  using inverse = cca::transformation<foot_in_hip, halved>;
  static auto random(laws::source& r) { return r.vector(2); }
  static bool close(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (a - b).norm() < 1e-12; }
};

// There and back, each as a chain.
struct chain_model {
  using forward = cca::mapping_chain<cca::frame_change<hip_in_trunk, foot_in_hip, foot_in_trunk>,
                                     cca::frame_change<trunk_in_world, foot_in_trunk, foot_in_world>>;
  using inverse =
      cca::mapping_chain<cca::frame_change<cca::inverse_of<trunk_in_world>, foot_in_world, foot_in_trunk>,
                         cca::frame_change<cca::inverse_of<hip_in_trunk>, foot_in_trunk, foot_in_hip>>;
  static auto random(laws::source& r) { return r.vector(2); }
  static bool close(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (a - b).norm() < 1e-12; }
};

struct lifted {
  static constexpr auto where = cca::at(0.1, 0.2, 0.3);
};
struct turned {
  static constexpr auto where = cca::turned_about({3, 0, 4}, -1.1);
};
struct both {
  static constexpr auto where = lifted::where * turned::where;
};
template <class Motion>
struct undone {
  static constexpr auto where = cca::inverse(Motion::where);
};

// Within a frame, a motion and its inverse.
template <template <class, class> class By, class Motion, class Space>
struct motion_model {
  using forward = By<Space, Motion>;
  using inverse = By<Space, undone<Motion>>;
  static auto random(laws::source& r) { return random_point<Space>(r); }
  static bool close(const typename Space::vector_type& a, const typename Space::vector_type& b) {
    return near<Space>(a, b);
  }
};

}  // namespace

TEST_SUITE("mappings") {
  TEST_CASE_TEMPLATE(
      "an inverse undoes its mapping", Model, scale_model, chain_model,
      change_model<foot_in_hip, foot_in_trunk>, change_model<turn_in_hip, turn_in_trunk>,
      change_model<pose_in_hip, pose_in_trunk>, change_model<twist_at_hip, twist_at_trunk>,
      change_model<wrench_at_hip, wrench_at_trunk>, change_model<twist_at_hip, twist_at_hip_in_trunk>,
      change_model<wrench_at_hip, wrench_at_hip_in_trunk>,
      motion_model<cca::translation_by, lifted, foot_in_hip>,
      motion_model<cca::rotation_by, turned, foot_in_hip>, motion_model<cca::rigid_motion, both, pose_in_hip>,
      motion_model<cca::rotation_by, turned, turn_in_hip>) {
    laws::inverse<Model>();
  }

  TEST_CASE("from functions") {
    const Eigen::Vector3d v(1, 2, 3);
    cca::mapping<foot_in_hip, heights, height> to_height;
    CHECK(laws::map(to_height, v)[0] == 3);
    cca::transformation<foot_in_hip, scaled> by_factor;
    static_assert(cca::HasParameters<decltype(by_factor)>);
    CHECK(laws::map(by_factor, v) == 3 * v);
    by_factor.p.factor = -1;
    CHECK(laws::map(by_factor, v) == -v);
    cca::transformation<foot_in_hip,
                        decltype([](const Eigen::Vector3d& a) { return Eigen::Vector3d(a.reverse()); })>
        by_lambda;
    CHECK(laws::map(by_lambda, v) == v.reverse());
  }

  TEST_CASE("a chain passes on the outputs of its mappings, their statuses and the beat") {
    using chain = cca::mapping_chain<counting, cca::transformation<foot_in_hip, doubled>>;
    static_assert(cca::Mapping<chain>);
    chain c;
    const cca::in<"a", foot_in_hip> a(Eigen::Vector3d(1, 2, 3), 7, true);
    const auto [b, mode] = c.process(a, cca::beat{5, 1'000'000, 1});
    static_assert(decltype(b)::name == "output" && decltype(mode)::name == "mode");
    CHECK(b.vector() == Eigen::Vector3d(12, 14, 16));
    CHECK(mode.vector()[0] == 5);
  }

  TEST_CASE("each mapping of a chain sees the origin and freshness of the chain's input") {
    cca::mapping_chain<noting, noting> c;
    for (const bool fresh : {true, false})
      CHECK(std::get<0>(c.process(cca::in<"a", foot_in_hip>(Eigen::Vector3d(1, 2, 3), 7, fresh),
                                  cca::beat{5, 1'000'000, 1}))
                .vector() == Eigen::Vector3d(7, fresh, 0));
  }

  TEST_CASE("placements agree with matrices") {
    constexpr auto a = hip_in_trunk::where, b = trunk_in_world::where * cca::turned_about({-1, 0.5, 3}, 2.0);
    CHECK((matrix(b * a) - matrix(b) * matrix(a)).norm() < 1e-15);
    CHECK((vector(b * a) - (matrix(b) * vector(a) + vector(b))).norm() < 1e-15);
    CHECK((matrix(inverse(a)) - matrix(a).transpose()).norm() < 1e-15);
    CHECK((vector(inverse(a) * a)).norm() < 1e-15);
    for (const double angle :
         {-7.0, -3.2, -cca::pi, -1.6, -0.8, -0.1, 0.0, 1e-9, 0.7, 0.79, 1.57, 2.4, 3.9, 5.5, 6.3, 20.0}) {
      CHECK(std::abs(cca::detail::constant_sine(angle) - std::sin(angle)) < 4e-16);
      CHECK(std::abs(cca::detail::constant_cosine(angle) - std::cos(angle)) < 4e-16);
      const Eigen::Vector3d axis(1, 2, -1);
      const auto q = cca::turned_about({1, 2, -1}, angle).rotation;
      CHECK((cca::detail::as_vector(q) - cca::rotation::about<double>(axis, angle)).norm() < 1e-15);
    }
    for (const double square : {0.0, 1e-12, 0.25, 2.0, 6.0, 1e9})
      CHECK(cca::detail::constant_root(square) == doctest::Approx(std::sqrt(square)).epsilon(1e-15));
  }

  TEST_CASE("frame changes agree with matrices") {
    laws::source random{std::mt19937_64{12}};
    const Eigen::Matrix3d R = matrix(hip_in_trunk::where);
    const Eigen::Vector3d t = vector(hip_in_trunk::where);
    for (int i = 0; i < laws::rounds; ++i) {
      const Eigen::Vector3d p = random.vector(2);
      cca::frame_change<hip_in_trunk, foot_in_hip, foot_in_trunk> position;
      CHECK((laws::map(position, p) - (R * p + t)).norm() < 1e-14);

      // Poses in the frame of the hip: rotation and position.
      const Eigen::Vector4d q = quaternion(random);
      cca::frame_change<hip_in_trunk, turn_in_hip, turn_in_trunk> turn;
      CHECK(
          (cca::rotation::matrix<double>(laws::map(turn, q)) - R * cca::rotation::matrix<double>(q)).norm() <
          1e-14);
      Eigen::Matrix<double, 7, 1> thing;
      thing << p, q;
      cca::frame_change<hip_in_trunk, pose_in_hip, pose_in_trunk> pose;
      const auto placed = laws::map(pose, thing);
      CHECK((placed.head<3>() - (R * p + t)).norm() < 1e-14);
      CHECK((cca::rotation::matrix<double>(placed.tail<4>()) - R * cca::rotation::matrix<double>(q)).norm() <
            1e-14);

      Eigen::Matrix<double, 6, 1> v;
      v << random.vector(2), random.vector(2);
      // Spatial transforms (Featherstone 2008, chapter 2) from hip to trunk coordinates.
      Eigen::Matrix<double, 6, 6> motion, force;
      motion << R, Eigen::Matrix3d::Zero(), skew(t) * R, R;
      force << R, skew(t) * R, Eigen::Matrix3d::Zero(), R;
      cca::frame_change<hip_in_trunk, twist_at_hip, twist_at_trunk> twist;
      CHECK((laws::map(twist, v) - motion * v).norm() < 1e-13);
      cca::frame_change<hip_in_trunk, wrench_at_hip, wrench_at_trunk> wrench;
      CHECK((laws::map(wrench, v) - force * v).norm() < 1e-13);
      cca::frame_change<hip_in_trunk, twist_at_hip, twist_at_hip_in_trunk> turned_only;
      CHECK((laws::map(turned_only, v).head<3>() - R * v.head<3>()).norm() < 1e-13);
      CHECK((laws::map(turned_only, v).tail<3>() - R * v.tail<3>()).norm() < 1e-13);
    }
  }

  TEST_CASE("motions within a frame") {
    const Eigen::Vector3d p(1, -2, 3);
    cca::translation_by<foot_in_hip, lifted> translation;
    cca::rotation_by<foot_in_hip, turned> rotation;
    cca::rigid_motion<foot_in_hip, both> motion;
    static_assert(cca::Transformation<decltype(motion)>);
    CHECK((laws::map(translation, p) - (p + vector(lifted::where))).norm() < 1e-15);
    CHECK((laws::map(rotation, p) - matrix(turned::where) * p).norm() < 1e-14);
    CHECK((laws::map(motion, p) - laws::map(translation, laws::map(rotation, p))).norm() < 1e-14);
    cca::translation_by<foot_in_plane, lifted> in_plane;  // only along the axes of the space
    CHECK((laws::map(in_plane, Eigen::Vector2d(1, 3)) - Eigen::Vector2d(1.1, 3.3)).norm() < 1e-15);
  }
}

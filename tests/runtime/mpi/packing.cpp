// Results as bytes: each comes back with its bits, and the next begins where it has ended.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <cca/mpi/packing.hpp>

namespace packing_test {

namespace mpi = cca::mpi::detail;

struct point {
  double x;
  int y;
  bool operator==(const point&) const = default;
};
struct named {
  BOOST_HANA_DEFINE_STRUCT(named, (std::string, name), (std::vector<point>, path), (Eigen::Vector3d, at));
};
struct with_pointer {
  BOOST_HANA_DEFINE_STRUCT(with_pointer, (std::string, name), (std::unique_ptr<int>, number));
};
struct no_fields {
  std::string name;
};

template <class T>
T there_and_back(const T& value) {
  std::string bytes = "before";
  mpi::put(bytes, value);
  mpi::put(bytes, std::uint64_t{77});
  std::string_view rest(bytes);
  rest.remove_prefix(6);
  T back = mpi::get<T>(rest);
  CHECK_EQ(mpi::get<std::uint64_t>(rest), 77);
  CHECK(rest.empty());
  // Cut short anywhere it is refused, and nothing beyond the end is read.
  for (std::size_t size = 0; size + 14 < bytes.size(); ++size) {
    const std::string part = bytes.substr(6, size);
    std::string_view cut(part);
    CHECK_THROWS_AS(mpi::get<T>(cut), std::runtime_error);
  }
  return back;
}

TEST_SUITE("packing") {
  TEST_CASE("what it is comes back") {
    CHECK_EQ(there_and_back(1.5), 1.5);
    CHECK_EQ(there_and_back(point{-0.25, 3}), point{-0.25, 3});
    CHECK_EQ(there_and_back(std::string("a\0b", 3)), std::string("a\0b", 3));
    CHECK_EQ(there_and_back(std::vector<std::string>{"", "one"}), std::vector<std::string>{"", "one"});
    CHECK_EQ(there_and_back(std::vector<bool>{true, false}), std::vector<bool>{true, false});
    CHECK_EQ(there_and_back(std::optional<std::string>("x")), std::optional<std::string>("x"));
    CHECK_EQ(there_and_back(std::optional<std::string>()), std::nullopt);
    CHECK_EQ(there_and_back(std::pair(std::string("x"), 2)), std::pair(std::string("x"), 2));
    const double tiny = std::numeric_limits<double>::denorm_min();
    const Eigen::MatrixXd m{{1, -0.0, tiny}, {4, 5, 6}};
    const Eigen::MatrixXd back = there_and_back(m);
    CHECK_EQ(back, m);
    CHECK(std::signbit(back(0, 1)));
    CHECK_EQ(there_and_back(Eigen::Vector4f(1, 2, 3, 4)), Eigen::Vector4f(1, 2, 3, 4));
    const named walk = there_and_back(named{"trot", {{1, 2}, {3, 4}}, {5, 6, 7}});
    CHECK_EQ(walk.name, "trot");
    CHECK_EQ(walk.path, std::vector<point>{{1, 2}, {3, 4}});
    CHECK_EQ(walk.at, Eigen::Vector3d(5, 6, 7));
  }

  TEST_CASE("what means something on one rank only is refused") {
    static_assert(mpi::Packable<named> && mpi::Packable<std::vector<std::vector<named>>>);
    static_assert(!mpi::Packable<double*> && !mpi::Packable<std::string_view> &&
                  !mpi::Packable<std::span<int>>);
    static_assert(!mpi::Packable<std::unique_ptr<int>> && !mpi::Packable<with_pointer> &&
                  !mpi::Packable<no_fields>);
    static_assert(!mpi::Packable<std::vector<const char*>> && !mpi::Packable<std::reference_wrapper<int>>);
    static_assert(!mpi::Packable<std::optional<int*>> && !mpi::Packable<std::array<char*, 2>>);
  }
}

}  // namespace packing_test

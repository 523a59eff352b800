// The order of sums, judged by a tree of additions that is written down as text: each number has a name.
#include <doctest/doctest.h>

#include <string>
#include <utility>

#include <cca/base/math/reductions.hpp>

#include "../dual.hpp"

namespace math = cca::math;

namespace {

// A number that remembers how it was computed.
struct term {
  std::string text;
  term() = default;
  term(int zero) : text(std::to_string(zero)) {}
  explicit term(std::string t) : text(std::move(t)) {}
  friend term operator+(const term& a, const term& b) { return term("(" + a.text + "+" + b.text + ")"); }
  term& operator+=(const term& b) { return *this = *this + b; }
  friend term operator*(const term& a, const term& b) { return term(a.text + b.text); }
};

template <int Rows, int Columns = 1>
using matrix =
    Eigen::Matrix<term, Rows, Columns, Rows == 1 && Columns != 1 ? Eigen::RowMajor : Eigen::ColMajor>;

template <int Rows, int Columns = 1>
matrix<Rows, Columns> named(char name) {
  matrix<Rows, Columns> m;
  for (int i = 0; i < Rows; ++i)
    for (int j = 0; j < Columns; ++j)
      m(i, j) = term(name + std::to_string(i) + (Columns > 1 ? "_" + std::to_string(j) : ""));
  return m;
}

// The definition, as slow as it is plain.
std::string in_halves(int first, int count, const auto& at) {
  if (count == 1) return at(first);
  return "(" + in_halves(first, count / 2, at) + "+" + in_halves(first + count / 2, count - count / 2, at) +
         ")";
}
std::string in_sequence(int count, const auto& at) {
  std::string all = at(0);
  for (int i = 1; i < count; ++i) all = "(" + all + "+" + at(i) + ")";
  return all;
}

template <int Size>
void check_size() {
  CAPTURE(Size);
  const auto a = named<Size>('a'), b = named<Size>('b');
  const auto one = [](int i) { return "a" + std::to_string(i); };
  const auto both = [](int i) { return "a" + std::to_string(i) + "b" + std::to_string(i); };
  const auto square = [](int i) { return "a" + std::to_string(i) + "a" + std::to_string(i); };
  CHECK(math::sum(a).text == (Size <= 55 ? in_halves(0, Size, one) : in_sequence(Size, one)));
  CHECK(math::dot(a, b).text == (Size <= 27 ? in_halves(0, Size, both) : in_sequence(Size, both)));
  CHECK(math::dot(a.transpose(), b).text == math::dot(a, b).text);
  CHECK(math::squared_norm(a).text == (Size <= 27 ? in_halves(0, Size, square) : in_sequence(Size, square)));
  const matrix<Eigen::Dynamic> more = a;
  CHECK(math::sum(more).text == in_sequence(Size, one));
  CHECK(math::dot(more, b).text == math::dot(a, b).text);  // one fixed size is enough
  CHECK(math::squared_norm(more).text == in_sequence(Size, square));
}
template <int... I>
void check_sizes(std::integer_sequence<int, I...>) {
  (check_size<I + 1>(), ...);
}

template <int Rows, int Depth, int Columns>
void check_product() {
  CAPTURE(Rows);
  CAPTURE(Depth);
  const auto a = named<Rows, Depth>('a');
  const auto b = named<Depth, Columns>('b');
  const auto c = math::product(a, b);
  static_assert(decltype(c)::RowsAtCompileTime == int{Rows} &&
                decltype(c)::ColsAtCompileTime == int{Columns});
  const bool sequence = Depth > 27 || (Rows >= 8 && Depth >= 8);
  for (int i = 0; i < Rows; ++i)
    for (int j = 0; j < Columns; ++j) {
      const auto at = [&](int k) { return a(i, k).text + b(k, j).text; };
      CHECK(c(i, j).text == (sequence ? in_sequence(Depth, at) : in_halves(0, Depth, at)));
      CHECK(math::product(a, matrix<Depth>(b.col(j)))[i].text == c(i, j).text);
    }
  constexpr int options = Depth != 1 ? int{Eigen::RowMajor} : int{Eigen::ColMajor};
  const Eigen::Matrix<term, Rows, Depth, options> by_rows = a;
  for (int i = 0; i < Rows; ++i)
    for (int j = 0; j < Columns; ++j) CHECK(math::product(by_rows, b)(i, j).text == c(i, j).text);
}

// Products with a power of two are exact, so a machine that fuses products and sums gets the same bits.
struct drawn_numbers {
  std::uint64_t state = 1;
  double next() {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state >> 11) * 0x1p-52 - 1;
  }
  double exponent() { return std::ldexp(1.0, static_cast<int>(next() * 8)); }
};

// Doubles of which columns lie in memory are multiplied by lanes: in the order of the definition.
template <int Rows, int Depth, int Columns>
void check_lanes() {
  CAPTURE(Rows);
  CAPTURE(Depth);
  drawn_numbers random;
  Eigen::Matrix<double, Rows, Depth> a;
  Eigen::Matrix<double, Depth, Columns> b;
  for (double& x : a.reshaped()) x = random.next();
  for (double& x : b.reshaped()) x = random.exponent();
  const auto halves = [](auto self, int first, int count, const auto& at) -> double {
    if (count == 1) return at(first);
    return self(self, first, count / 2, at) + self(self, first + count / 2, count - count / 2, at);
  };
  const bool sequence = Depth > 27 || (Rows >= 8 && Depth >= 8);
  Eigen::Matrix<double, Rows, Columns> wanted;
  int depends_on_order = 0;
  for (int i = 0; i < Rows; ++i)
    for (int j = 0; j < Columns; ++j) {
      const auto at = [&](int k) { return a(i, k) * b(k, j); };
      double in_order = at(0);
      for (int k = 1; k < Depth; ++k) in_order += at(k);
      const double in_halves = halves(halves, 0, Depth, at);
      depends_on_order += in_order != in_halves;
      wanted(i, j) = sequence ? in_order : in_halves;
    }
  if (Rows * Columns > 4) CHECK(depends_on_order > 0);
  CHECK(math::product(a, b) == wanted);
  CHECK(math::product(a, b.col(Columns - 1)) == wanted.col(Columns - 1));
  CHECK(math::product(2 * a, b) == 2 * wanted);
  Eigen::Matrix<double, Rows + 2, Depth> larger = Eigen::Matrix<double, Rows + 2, Depth>::Constant(1e30);
  larger.template middleRows<Rows>(1) = a;
  CHECK(math::product(larger.template middleRows<Rows>(1), b) == wanted);
  const Eigen::Matrix<double, Depth, Rows> turned = a.transpose();
  CHECK(math::product(turned.transpose(), b) == wanted);
  const Eigen::Map<const Eigen::Matrix<double, Rows, Depth>, 0, Eigen::OuterStride<>> mapped(
      larger.data() + 1, Eigen::OuterStride<>(Rows + 2));
  CHECK(math::product(mapped, b) == wanted);
  Eigen::Matrix<double, 2 * Rows, Depth> spread = Eigen::Matrix<double, 2 * Rows, Depth>::Constant(1e30);
  for (int i = 0; i < Rows; ++i) spread.row(2 * i) = a.row(i);
  const Eigen::Map<const Eigen::Matrix<double, Rows, Depth>, 0, Eigen::Stride<2 * Rows, 2>> every_second(
      spread.data());
  CHECK(math::product(every_second, b) == wanted);
}

}  // namespace

TEST_CASE("products by lanes have the order of the definition") {
  check_lanes<3, 3, 3>(), check_lanes<2, 3, 1>(), check_lanes<4, 4, 4>(), check_lanes<5, 7, 2>();
  check_lanes<6, 6, 1>(), check_lanes<6, 6, 6>(), check_lanes<7, 3, 9>(), check_lanes<3, 30, 2>();
  check_lanes<6, 20, 1>(), check_lanes<8, 7, 3>(), check_lanes<9, 9, 3>();
}

TEST_CASE("sums are added in halves up to a size, and in sequence beyond") {
  check_sizes(std::make_integer_sequence<int, 12>{});
  check_size<27>(), check_size<28>(), check_size<55>(), check_size<56>();
  CHECK(math::sum(named<3>('a')).text == "(a0+(a1+a2))");
}

TEST_CASE("a matrix is added as it lies in memory") {
  CHECK(math::sum(named<2, 3>('a')).text == "((a0_0+(a1_0+a0_1))+(a1_1+(a0_2+a1_2)))");
  const Eigen::Matrix<term, 2, 3, Eigen::RowMajor> by_rows = named<2, 3>('a');
  CHECK(math::sum(by_rows).text == "((a0_0+(a0_1+a0_2))+(a1_0+(a1_1+a1_2)))");
  CHECK(math::trace(named<3, 3>('a')).text == "(a0_0+(a1_1+a2_2))");
  CHECK(math::sum(by_rows.row(1)).text == "(a1_0+(a1_1+a1_2))");
}

TEST_CASE("each entry of a product is added like a dot product") {
  check_product<1, 5, 3>(), check_product<3, 3, 3>(), check_product<6, 7, 2>(), check_product<7, 9, 1>();
  check_product<8, 7, 2>(), check_product<8, 8, 2>(), check_product<9, 12, 1>(), check_product<2, 27, 1>();
  check_product<2, 28, 1>(), check_product<4, 1, 3>();
  const matrix<Eigen::Dynamic, Eigen::Dynamic> a = named<2, 3>('a');
  CHECK(math::product(a, named<3>('b'))[1].text == "((a1_0b0+a1_1b1)+a1_2b2)");
}

TEST_CASE("expressions, floats, and numbers with a derivative") {
  const Eigen::Vector3d a(1, 2, 4), b(3, 5, 7);
  CHECK(math::dot(a, b) == 41);
  CHECK(math::dot(a - b, 2 * b) == -84);
  CHECK(math::squared_norm(a) == 21);
  CHECK(math::norm(Eigen::Vector2d(3, 4)) == 5);
  CHECK(math::norm(Eigen::Vector2f(3, 4)) == 5.0F);
  CHECK(math::mean(a) == 7.0 / 3);
  CHECK(math::sum(a.array().abs()) == 7);
  CHECK(math::sum(Eigen::VectorXd()) == 0);
  CHECK(math::dot(Eigen::VectorXd(), Eigen::VectorXd()) == 0);
  CHECK(math::product(a + b, b.transpose())(2, 1) == 55);
  CHECK(math::product(a.asDiagonal().toDenseMatrix(), b - a) == Eigen::Vector3d(2, 6, 12));
  const Eigen::Matrix<test::dual, 3, 1> x(test::dual(1, 1), test::dual(2, 0), test::dual(4, 2));
  CHECK(math::dot(x, x) == test::dual(21));
  CHECK(math::dot(x, x).slope == 2 * (1 * 1 + 4 * 2));
}

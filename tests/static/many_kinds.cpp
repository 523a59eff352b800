// A graph of many components, all of different types: more than clang allows in one fold expression.
#include <utility>

#include <cca/cca.hpp>

namespace many_kinds {

template <int N>
struct kind {
  double sum = 0;
  void process(cca::beat now) { sum += N * now.dt(); }
};

// "n007"
template <int N>
constexpr cca::fixed_string name{{'n', '0' + N / 100, '0' + N / 10 % 10, '0' + N % 10, '\0'}};

template <class Numbers>
struct of_kinds;
template <int... N>
struct of_kinds<std::integer_sequence<int, N...>>
    : cca::graph<cca::rate<1000>, cca::node<name<N>, kind<N>>...> {};

using many = of_kinds<std::make_integer_sequence<int, 260>>;

}  // namespace many_kinds

static_assert(cca::well_formed<many_kinds::many>);

void beat_of_many_kinds(cca::controller<many_kinds::many>& c);
void beat_of_many_kinds(cca::controller<many_kinds::many>& c) { c.step(); }

// What a function of a sample says of a vector that has another number of coordinates than it takes: before
// Eigen says it without a name.
#pragma once

#include <type_traits>

#include <cca/base/eigen.hpp>
#include <cca/base/fixed_string.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/space/messages/space_in_words.hpp>

namespace cca::detail {

// Of the wrong length. Where a length is known only at run time, Eigen checks it.
template <class Vector, int Size> concept Unfit =
    Vector::SizeAtCompileTime != Size && Vector::SizeAtCompileTime != Eigen::Dynamic;

template <fixed_string Function, class Space, int Wanted, int Given>
struct other_vector {
  static constexpr void tell(text& m) {
    m << "space.wrong_length: `" << Function.view() << "` of " << space_in_words<Space>()
      << " takes a vector of " << Wanted << (Wanted == 1 ? " number" : " numbers");
    if constexpr (Wanted == Given) m << ", and this one is a row: write `.transpose()` behind it";
    else m << ", and this one has " << Given << ": give one of " << Wanted;
  }
};

// Whether it is a column of `Size` numbers. If not, the compiler prints the sentence.
template <fixed_string Function, class Space, int Size, class Vector>
constexpr bool takes_vector() {
  constexpr bool is_row = Size > 1 && Vector::RowsAtCompileTime == 1;
  constexpr bool fits = !Unfit<Vector, Size> && !is_row;
  static_assert(holds_or_tells<fits, other_vector<Function, Space, Size, Vector::SizeAtCompileTime>>::value);
  return fits;
}

}  // namespace cca::detail

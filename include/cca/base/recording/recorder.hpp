// A recording: the operations that an algorithm makes, found by running it at compile time.
//
// An algorithm is a template on its scalar. With `recorded` as scalar it computes nothing: each operation is
// written down. Constants fold, products with 0 and 1 vanish, signs move into sums and differences, and equal
// operations are one. tape.hpp keeps what the outputs need; straight_line.hpp makes code of it.
//
//   recorder r;
//   const recorded x = r.input(0), y = r.input(1);
//   r.output(x * y + 2 * x);
//
// All of it runs in constant expressions. Folding 0 * x loses a NaN in x: whoever records an algorithm says
// which inputs an output must not lose (tape.hpp). Capacity: 4,096 operations; with more, `is_full` is true
// and the recording is useless.
// Cost: for each operation a look-up in a hash table, about 50 steps of the compiler's evaluation.
#pragma once

#include <bit>
#include <cstdint>

namespace cca::detail {

enum class operation : std::uint32_t { add, subtract, multiply, divide };

// An operand is a number below 2^14: an operation, a constant or an input.
inline constexpr int most_operations = 4096, most_constants = 512, first_constant = 4096, first_input = 8192,
                     most_operands = 16384;

// An operation and its operands in one number, which is cheap to compare and to store.
struct recorded_operation {
  std::uint32_t word = 0;

  constexpr recorded_operation() = default;
  constexpr explicit recorded_operation(std::uint32_t made) : word(made) {}
  constexpr recorded_operation(operation what, int a, int b)
      : word(static_cast<std::uint32_t>(what) << 28 | static_cast<std::uint32_t>(a) << 14 |
             static_cast<std::uint32_t>(b)) {}
  constexpr operation what() const { return static_cast<operation>(word >> 28); }
  constexpr int first() const { return static_cast<int>(word >> 14 & 0x3fff); }
  constexpr int second() const { return static_cast<int>(word & 0x3fff); }
};

struct recorder;

// A number while an algorithm is recorded: a constant, or an operand or its negative.
struct recorded {
  recorder* in = nullptr;
  int place = 0;  // its operand plus one; 0: the constant. So zeroed memory is the number 0.
  bool is_negative = false;
  double constant = 0;

  constexpr recorded() = default;
  constexpr recorded(double value) : constant(value) {}
  constexpr recorded(recorder* r, int operand, bool negative)
      : in(r), place(operand + 1), is_negative(negative) {}

  constexpr bool is_constant() const { return place == 0; }
  constexpr int operand() const { return place - 1; }
  constexpr recorded operator-() const {
    return is_constant() ? recorded(-constant) : recorded(in, operand(), !is_negative);
  }
};

struct recorder {
  static constexpr std::uint32_t most_outputs = 512, places = 8192;

  // Arrays without values: to fill them would take the compiler more time and memory than all the rest.
  std::uint32_t operations[most_operations];  // words of recorded_operation
  double constants[most_constants];
  std::uint16_t operation_at[places]{}, constant_at[places / 8]{};  // hash tables of indices plus one
  int outputs[most_outputs];  // operands, or ~operand of what is to be negated
  std::uint64_t owners[most_outputs];
  int operation_count = 0, constant_count = 0, output_count = 0;
  bool is_full = false;
  // Constants keep their signs: algorithms that differ in numbers only then make equal operations.
  bool keeps_signs = false;

  constexpr recorder() {}

  // Whether a constant is written down as its negative.
  constexpr bool turns(double constant) const { return constant < 0 && !keeps_signs; }

  constexpr recorded input(int i) { return {this, first_input + i, false}; }
  // `owners`: a bit for each owner of inputs that this output must not lose (tape.hpp).
  constexpr void output(const recorded& x, std::uint64_t owners_of_x = 0) {
    if (output_count == most_outputs) {
      is_full = true;
      return;
    }
    const bool minus = x.is_constant() ? turns(x.constant) : x.is_negative;
    const int operand = x.is_constant() ? operand_of(minus ? -x.constant : x.constant) : x.operand();
    owners[output_count] = owners_of_x;
    outputs[output_count++] = minus ? ~operand : operand;
  }

  // A constant; not negative, unless signs are kept.
  constexpr int operand_of(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value + 0.0);  // -0 is 0
    auto at = static_cast<std::uint32_t>(bits >> 32 ^ bits) * 2654435761u >> 22;
    for (; constant_at[at] != 0; at = (at + 1) % (places / 8))
      if (constants[constant_at[at] - 1] == value) return first_constant + constant_at[at] - 1;
    if (constant_count == most_constants) {
      is_full = true;
      return first_constant;
    }
    constants[constant_count] = value + 0.0;
    constant_at[at] = static_cast<std::uint16_t>(++constant_count);
    return first_constant + constant_count - 1;
  }
  constexpr int operand_of(operation what, int a, int b) {
    if (is_full) return 0;  // spares the compiler the rest
    const recorded_operation made(what, a, b);
    auto at = made.word * 2654435761u >> 19;
    for (; operation_at[at] != 0; at = (at + 1) % places)
      if (operations[operation_at[at] - 1] == made.word) return operation_at[at] - 1;
    if (operation_count == most_operations) {
      is_full = true;
      return 0;
    }
    operations[operation_count] = made.word;
    operation_at[at] = static_cast<std::uint16_t>(++operation_count);
    return operation_count - 1;
  }
};

constexpr recorded operator+(const recorded& x, const recorded& y) {
  if (x.is_constant()) {
    if (x.constant == 0) return y;
    if (y.is_constant()) return x.constant + y.constant;
    return y + x;
  }
  recorder& r = *x.in;
  if (y.is_constant()) {
    if (y.constant == 0) return x;
    const bool minus = r.turns(y.constant);
    const int k = r.operand_of(minus ? -y.constant : y.constant);
    if (minus == x.is_negative) return {&r, r.operand_of(operation::add, x.operand(), k), minus};
    return {&r, r.operand_of(operation::subtract, x.operand(), k), x.is_negative};
  }
  if (x.place > y.place) return y + x;
  if (x.is_negative == y.is_negative)
    return {&r, r.operand_of(operation::add, x.operand(), y.operand()), x.is_negative};
  if (x.place == y.place) return 0.0;
  return {&r, r.operand_of(operation::subtract, x.operand(), y.operand()), x.is_negative};
}
constexpr recorded operator-(const recorded& x, const recorded& y) { return x + -y; }

constexpr recorded operator*(const recorded& x, const recorded& y) {
  if (x.is_constant()) {
    if (x.constant == 0) return 0.0;
    if (y.is_constant()) return x.constant * y.constant;
    if (x.constant == 1) return y;
    if (x.constant == -1) return -y;
    recorder& r = *y.in;
    const bool minus = r.turns(x.constant);
    const int k = r.operand_of(minus ? -x.constant : x.constant);
    return {&r, r.operand_of(operation::multiply, y.operand(), k), y.is_negative != minus};
  }
  if (y.is_constant() || x.place > y.place) return y * x;
  return {x.in, x.in->operand_of(operation::multiply, x.operand(), y.operand()),
          x.is_negative != y.is_negative};
}

constexpr recorded operator/(const recorded& x, const recorded& y) {
  if (y.is_constant()) return x * recorded(1 / y.constant);
  recorder& r = *y.in;
  if (!x.is_constant())
    return {&r, r.operand_of(operation::divide, x.operand(), y.operand()), x.is_negative != y.is_negative};
  if (x.constant == 0) return 0.0;
  const bool minus = r.turns(x.constant);
  const int k = r.operand_of(minus ? -x.constant : x.constant);
  return {&r, r.operand_of(operation::divide, k, y.operand()), y.is_negative != minus};
}

}  // namespace cca::detail

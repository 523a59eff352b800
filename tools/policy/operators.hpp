// The operators, one function each. Source: onnx.ai, Operators.md.
#pragma once

#include <map>

#include "lowering.hpp"

namespace cca_policy {

struct operators {
  lowering& l;

  void unary(const std::string& function, const std::string& more = "") const { l.unary(function, more); }
  double real(const char* name, double otherwise) const { return l.real(name, otherwise); }

  // -- shapes
  void identity() const { l.alias(l.input(0).dims); }
  void cast() const {
    const std::int64_t to = l.whole("to", 1);
    const value& v = l.input(0);
    const bool is_real = to == 1 || to == 11;
    if (!v.is_constant && !is_real) l.refuse_here("it makes integers of computed numbers");
    value same = v;
    same.is_whole = !is_real;
    if (same.is_whole)
      for (double& n : same.numbers) n = std::trunc(n);
    l.set(0, std::move(same));
  }
  void constant() const {
    const node& n = *l.here_;
    value v;
    v.is_constant = true;
    if (const auto t = n.tensors.find("value"); t != n.tensors.end()) return l.set(0, of(t->second));
    if (n.reals.contains("value_float")) v.numbers = {n.reals.at("value_float")};
    else if (n.real_lists.contains("value_floats")) {
      v.numbers = n.real_lists.at("value_floats");
      v.dims = {static_cast<std::int64_t>(v.numbers.size())};
    } else if (n.wholes.contains("value_int")) {
      v.is_whole = true;
      v.numbers = {static_cast<double>(n.wholes.at("value_int"))};
    } else if (n.whole_lists.contains("value_ints")) {
      v.is_whole = true;
      for (const auto w : n.whole_lists.at("value_ints")) v.numbers.push_back(static_cast<double>(w));
      v.dims = {static_cast<std::int64_t>(v.numbers.size())};
    } else l.refuse_here("it has no numbers");
    l.set(0, std::move(v));
  }
  static value of(const tensor& t) {
    value v;
    v.is_constant = true;
    v.is_whole = t.is_whole;
    v.dims = t.dims;
    v.numbers = t.values;
    for (const auto w : t.wholes) v.numbers.push_back(static_cast<double>(w));
    return v;
  }
  void shape_of() const {
    value v;
    v.is_constant = v.is_whole = true;
    for (const auto d : l.input(0).dims) v.numbers.push_back(static_cast<double>(d));
    v.dims = {static_cast<std::int64_t>(v.numbers.size())};
    l.set(0, std::move(v));
  }
  void reshape() const {
    const value& v = l.input(0);
    shape dims = l.whole_list(1, "the shape");
    std::int64_t known = 1;
    std::size_t open = dims.size();
    if (dims.size() > 8) l.refuse_here("its shape has more than 8 dimensions");
    for (std::size_t i = 0; i < dims.size(); ++i) {
      if (dims[i] == 0 && l.whole("allowzero", 0) == 0 && i < v.dims.size()) dims[i] = v.dims[i];
      if (dims[i] == -1 && open == dims.size()) open = i;
      else if (dims[i] < 0) l.refuse_here("its shape has a negative number");
      else if (dims[i] > most_numbers || known > most_numbers / std::max<std::int64_t>(1, dims[i]))
        l.refuse_here("its shape is too large");
      else known *= dims[i];
    }
    if (open < dims.size()) {
      if (known == 0 || v.count() % known != 0) l.refuse_here("its shape does not fit " + in_words(v.dims));
      dims[open] = v.count() / known;
    }
    l.alias(dims);
  }
  void flatten() const {
    const shape& d = l.input(0).dims;
    const std::int64_t axis = l.whole("axis", 1);
    const auto rank = static_cast<std::int64_t>(d.size());
    const std::int64_t at = axis < 0 ? axis + rank : axis;
    if (at < 0 || at > rank) l.refuse_here("its axis does not exist");
    l.alias({product_of(d, 0, static_cast<std::size_t>(at)),
             product_of(d, static_cast<std::size_t>(at), d.size())});
  }
  places axes_or(std::size_t input, places otherwise) const {
    if (l.here_->whole_lists.contains("axes")) return l.here_->whole_lists.at("axes");
    return l.has(input) ? l.whole_list(input, "the list of axes") : otherwise;
  }
  void squeeze() const {
    const shape& d = l.input(0).dims;
    places all;
    for (std::size_t i = 0; i < d.size(); ++i)
      if (d[i] == 1) all.push_back(static_cast<std::int64_t>(i));
    std::set<std::size_t> gone;
    for (const auto a : axes_or(1, all)) gone.insert(axis_of(a, d.size(), "Squeeze"));
    shape kept;
    for (std::size_t i = 0; i < d.size(); ++i)
      if (!gone.contains(i)) kept.push_back(d[i]);
    l.alias(kept);
  }
  void unsqueeze() const {
    const shape& d = l.input(0).dims;
    const places axes = axes_or(1, {});
    const std::size_t rank = d.size() + axes.size();
    if (rank > 8) l.refuse_here("its result has more than 8 dimensions");
    std::set<std::size_t> added;
    for (const auto a : axes) added.insert(axis_of(a, rank, "Unsqueeze"));
    if (added.size() != axes.size()) l.refuse_here("it names an axis twice");
    shape made;
    for (std::size_t i = 0, from = 0; i < rank; ++i) made.push_back(added.contains(i) ? 1 : d[from++]);
    l.alias(made);
  }
  void transpose() const {
    const value& v = l.input(0);
    const std::size_t rank = v.dims.size();
    places order;
    if (l.here_->whole_lists.contains("perm")) order = l.here_->whole_lists.at("perm");
    else
      for (std::size_t i = rank; i-- > 0;) order.push_back(static_cast<std::int64_t>(i));
    std::set<std::size_t> once;
    shape dims;
    if (order.size() != rank) l.refuse_here("its order has another length than its input");
    for (const auto o : order) {
      once.insert(axis_of(o, rank, "Transpose"));
      dims.push_back(v.dims[axis_of(o, rank, "Transpose")]);
    }
    if (once.size() != rank) l.refuse_here("it names an axis twice");
    shape steps(rank, 1);
    for (std::size_t i = rank; i-- > 1;) steps[i - 1] = steps[i] * v.dims[i];
    places kept;
    const std::int64_t count = v.count();
    for (std::int64_t flat = 0; flat < count; ++flat) {
      std::int64_t rest = flat, from = 0;
      for (std::size_t i = rank; i-- > 0;) {
        from += rest % dims[i] * steps[static_cast<std::size_t>(axis_of(order[i], rank, "Transpose"))];
        rest /= dims[i];
      }
      kept.push_back(from);
    }
    l.pick(0, v, dims, kept);
  }
  void concat() const {
    const node& n = *l.here_;
    const value& first = l.input(0);
    const std::size_t axis = axis_of(l.whole("axis", 0), first.dims.size(), "Concat");
    shape dims = first.dims;
    bool all_constant = true;
    dims[axis] = 0;
    for (std::size_t i = 0; i < n.inputs.size(); ++i) {
      const value& v = l.input(i);
      shape other = v.dims;
      if (other.size() != dims.size()) l.refuse_here("its inputs have different numbers of dimensions");
      dims[axis] += other[axis];
      other[axis] = dims[axis];
      if (other != dims) l.refuse_here("its inputs do not fit side by side");
      all_constant = all_constant && v.is_constant;
    }
    if (count_of(dims) < 0 || product_of(dims, 0, axis) != 1)
      l.refuse_here("it joins along an axis after one that is longer than one: put the joined axis first");
    if (all_constant) {
      value v;
      v.dims = dims;
      v.is_constant = true;
      v.is_whole = first.is_whole;
      if (count_of(dims) > most_computed) l.refuse_here("its result is too large");
      for (std::size_t i = 0; i < n.inputs.size(); ++i)
        v.numbers.insert(v.numbers.end(), l.input(i).numbers.begin(), l.input(i).numbers.end());
      return l.set(0, std::move(v));
    }
    std::string text;
    for (std::size_t i = 0; i < n.inputs.size(); ++i)
      if (l.input(i).count() > 0) text += (text.empty() ? "joined(" : ", ") + l.text_of_value(l.input(i));
    l.set(0, l.computed(dims, text + ")"));
  }
  static std::int64_t from_start(std::int64_t at, std::int64_t size, std::int64_t least, std::int64_t most) {
    if (at < 0) at = at < -size ? -1 : at + size;
    return std::min(std::max(at, least), most);
  }
  void slice() const {
    const value* v = &l.input(0);
    const node& n = *l.here_;
    const bool old = n.whole_lists.contains("starts") && n.whole_lists.contains("ends");
    const places starts = old ? n.whole_lists.at("starts") : l.whole_list(1, "the list of starts"),
                 ends = old ? n.whole_lists.at("ends") : l.whole_list(2, "the list of ends");
    places otherwise, ones(starts.size(), 1);
    for (std::size_t i = 0; i < starts.size(); ++i) otherwise.push_back(static_cast<std::int64_t>(i));
    const places axes = old && !n.whole_lists.contains("axes") ? otherwise : axes_or(3, otherwise),
                 steps = !old && l.has(4) ? l.whole_list(4, "the list of steps") : ones;
    if (ends.size() != starts.size() || axes.size() != starts.size() || steps.size() != starts.size() ||
        starts.size() > v->dims.size())
      l.refuse_here("its lists have different lengths");
    shape dims = v->dims;
    places kept;
    for (std::int64_t i = 0; i < v->count(); ++i) kept.push_back(i);
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const std::size_t axis = axis_of(axes[i], dims.size(), "Slice");
      const std::int64_t size = dims[axis], step = steps[i];
      if (step == 0 || step > most_numbers || step < -most_numbers)
        l.refuse_here("its step is 0 or too large");
      const std::int64_t begin = step > 0 ? from_start(starts[i], size, 0, size)
                                          : from_start(starts[i], size, -1, size - 1),
                         end = step > 0 ? from_start(ends[i], size, 0, size)
                                        : from_start(ends[i], size, -1, size - 1);
      places some;
      for (std::int64_t k = begin; step > 0 ? k < end : k > end; k += step) some.push_back(k);
      places left;
      for (const auto p : along(dims, axis, some)) left.push_back(kept[static_cast<std::size_t>(p)]);
      kept = std::move(left);
      dims[axis] = static_cast<std::int64_t>(some.size());
    }
    l.pick(0, *v, dims, kept);
  }
  void gather() const {
    const value& v = l.input(0);
    const value& index = l.constant(1, "the list of indices");
    const std::size_t axis = axis_of(l.whole("axis", 0), v.dims.size(), "Gather");
    places kept;
    for (std::int64_t i : l.whole_list(1, "the list of indices")) {
      if (i < 0) i += v.dims[axis];
      if (i < 0 || i >= v.dims[axis]) l.refuse_here("an index is out of range");
      kept.push_back(i);
    }
    shape dims(v.dims.begin(), v.dims.begin() + static_cast<std::ptrdiff_t>(axis));
    dims.insert(dims.end(), index.dims.begin(), index.dims.end());
    dims.insert(dims.end(), v.dims.begin() + static_cast<std::ptrdiff_t>(axis) + 1, v.dims.end());
    l.pick(0, v, dims, along(v.dims, axis, kept));
  }
  void split() const {
    const value v = l.input(0);
    const std::size_t axis = axis_of(l.whole("axis", 0), v.dims.size(), "Split");
    const std::size_t count = l.here_->outputs.size();
    places sizes;
    if (l.here_->whole_lists.contains("split")) sizes = l.here_->whole_lists.at("split");
    else if (l.has(1)) sizes = l.whole_list(1, "the list of sizes");
    else {
      const std::int64_t each =
          (v.dims[axis] + static_cast<std::int64_t>(count) - 1) / static_cast<std::int64_t>(count);
      for (std::size_t i = 0; i < count; ++i)
        sizes.push_back(std::min(each, v.dims[axis] - each * static_cast<std::int64_t>(i)));
    }
    std::int64_t begin = 0;
    if (sizes.size() != count) l.refuse_here("it has another number of sizes than of outputs");
    for (std::size_t i = 0; i < count; ++i) {
      if (sizes[i] < 0 || sizes[i] > v.dims[axis] - begin) l.refuse_here("its sizes do not fit");
      places some;
      for (std::int64_t k = 0; k < sizes[i]; ++k) some.push_back(begin + k);
      begin += sizes[i];
      shape dims = v.dims;
      dims[axis] = sizes[i];
      l.pick(i, v, dims, along(v.dims, axis, some));
    }
  }

  // -- sums
  // W by columns, then the bias.
  void weighted(const value& x,
                const value& matrix,
                bool rows_are_outputs,
                double alpha,
                const std::vector<double>& bias,
                const shape& dims) const {
    const std::int64_t from = x.count(), to = matrix.count() / std::max<std::int64_t>(1, from);
    if (x.is_constant) l.refuse_here("its first input is a constant");
    std::vector<double> w;
    for (std::int64_t j = 0; j < from; ++j)
      for (std::int64_t i = 0; i < to; ++i)
        w.push_back(alpha * matrix.numbers.at(
                                static_cast<std::size_t>(rows_are_outputs ? i * from + j : j * to + i)));
    w.insert(w.end(), bias.begin(), bias.end());
    const std::string at = l.stored(w);
    l.set(0, l.computed(dims, std::string(bias.empty() ? "product<" : "dense<") + std::to_string(to) + ">(" +
                                  at + ", " + x.variable + ")"));
  }
  void gemm() const {
    const value& x = l.input(0);
    const value& matrix = l.constant(1, "the matrix");
    const bool transposed = l.whole("transB", 0) != 0;
    const shape kept = without_ones(x.dims);
    if (matrix.dims.size() != 2 || matrix.is_whole) l.refuse_here("its second input is no matrix");
    const std::int64_t from = matrix.dims[transposed ? 1 : 0], to = matrix.dims[transposed ? 0 : 1];
    if (kept.size() > 1 || x.count() != from || to < 1)
      l.refuse_here("it takes " + std::to_string(from) + " numbers, and gets " + in_words(x.dims));
    std::vector<double> bias;
    if (l.has(2)) {
      const value& c = l.constant(2, "the bias");
      if (c.count() != 1 && c.count() != to)
        l.refuse_here("its bias has " + std::to_string(c.count()) + " numbers");
      for (std::int64_t i = 0; i < to; ++i)
        bias.push_back(real_one("beta") * c.numbers.at(c.count() == 1 ? 0 : static_cast<std::size_t>(i)));
    }
    weighted(x, matrix, transposed, real_one("alpha"), bias, {1, to});
  }
  double real_one(const char* name) const { return l.real(name, 1); }
  void matmul() const {
    const value& x = l.input(0);
    const value& matrix = l.constant(1, "the matrix");
    if (matrix.dims.size() != 2 || x.dims.empty())
      l.refuse_here("its second input is no matrix of two dimensions");
    if (without_ones(x.dims).size() > 1 || x.dims.back() != matrix.dims[0] || x.count() != matrix.dims[0] ||
        matrix.dims[1] < 1)
      l.refuse_here("it takes " + std::to_string(matrix.dims[0]) + " numbers, and gets " + in_words(x.dims));
    shape dims = x.dims;
    dims.back() = matrix.dims[1];
    weighted(x, matrix, false, 1, {}, dims);
  }

  // -- number by number
  shape broadcast(const shape& a, const shape& b) const {
    shape dims(std::max(a.size(), b.size()), 1);
    for (std::size_t i = 0; i < dims.size(); ++i) {
      const std::int64_t of_a = i < a.size() ? a[a.size() - 1 - i] : 1,
                         of_b = i < b.size() ? b[b.size() - 1 - i] : 1;
      if (of_a != of_b && of_a != 1 && of_b != 1)
        l.refuse_here(in_words(a) + " and " + in_words(b) + " do not fit");
      dims[dims.size() - 1 - i] = of_a == 1 ? of_b : of_a;
    }
    return dims;
  }
  void arithmetic(const std::string& function, const std::function<double(double, double)>& f) const {
    const value &a = l.input(0), &b = l.input(1);
    const shape dims = broadcast(a.dims, b.dims);
    const std::int64_t count = count_of(dims);
    for (const value* v : {&a, &b})
      if (v->count() != 1 && v->count() != count)
        l.refuse_here("it spreads " + in_words(v->dims) + " over " + in_words(dims) +
                      "; only one number, or as many as there are");
    if (a.is_constant && b.is_constant) {
      value v;
      v.dims = dims;
      v.is_constant = true;
      v.is_whole = a.is_whole && b.is_whole;
      if (count > most_numbers || count < 0) l.refuse_here("its result is too large");
      for (std::int64_t i = 0; i < count; ++i) {
        const double of_a = a.numbers.at(a.count() == 1 ? 0 : static_cast<std::size_t>(i)),
                     of_b = b.numbers.at(b.count() == 1 ? 0 : static_cast<std::size_t>(i));
        if (v.is_whole && function == "over" && of_b == 0) l.refuse_here("it divides by zero");
        v.numbers.push_back(v.is_whole ? std::trunc(f(of_a, of_b)) : f(of_a, of_b));
      }
      return l.set(0, std::move(v));
    }
    if (function == "plus" && fuses(a, b, dims)) return;
    if (function == "plus" && fuses(b, a, dims)) return;
    const std::string of_a = l.text_of_value(a), of_b = l.text_of_value(b);
    l.set(0, l.computed(dims, function + "(" + of_a + ", " + of_b + ")"));
  }
  // A product and the bias that follows it are one operation.
  bool fuses(const value& sum, const value& bias, const shape& dims) const {
    if (sum.is_constant || !bias.is_constant || l.lines_.empty() || bias.count() != sum.count()) return false;
    auto& last = l.lines_.back();
    if (last.left != sum.variable || !last.right.starts_with("product<")) return false;
    if (l.uses(sum.variable) > 1) return false;
    last.right.replace(0, 7, "dense");
    (void)l.stored(bias.numbers);
    value v;
    v.dims = dims;
    v.variable = sum.variable;
    l.set(0, std::move(v));
    return true;
  }
  void power() const {
    const value& to = l.constant(1, "the exponent");
    if (to.numbers.size() == 1 && to.numbers[0] == 2) return l.unary("square");
    if (to.numbers.size() == 1 && to.numbers[0] == 0.5) return l.unary("root");
    l.refuse_here("only the exponents 2 and 0.5 are possible");
  }
  void clip() const {
    const auto bound = [&](const char* name, std::size_t input, double otherwise) {
      if (l.here_->reals.contains(name)) return l.here_->reals.at(name);
      if (!l.has(input)) return otherwise;
      const value& v = l.constant(input, "its bound");
      if (v.numbers.size() != 1) l.refuse_here("its bound is not one number");
      return v.numbers[0];
    };
    const double least = bound("min", 1, -3e38), most = bound("max", 2, 3e38);
    if (!(least <= most)) l.refuse_here("its bounds are the wrong way round");
    l.unary("limited", ", " + text_of(least) + ", " + text_of(most));
  }
  void sum() const { arithmetic("plus", std::plus<>()); }

  // -- over all numbers
  void all_of(const places& axes, const shape& dims) const {
    std::set<std::size_t> named;
    for (const auto a : axes) named.insert(axis_of(a, dims.size(), l.here_->op));
    for (std::size_t i = 0; i < dims.size(); ++i)
      if (dims[i] != 1 && !named.contains(i))
        l.refuse_here("it goes over some of the numbers of " + in_words(dims) + "; only over all of them");
  }
  void softmax() const {
    const shape& d = l.input(0).dims;
    const bool old = l.model_.opset < 13;
    places axes;
    const std::size_t axis = axis_of(l.whole("axis", old ? 1 : -1), d.size(), "Softmax");
    for (std::size_t i = axis; i < (old ? d.size() : axis + 1); ++i)
      axes.push_back(static_cast<std::int64_t>(i));
    all_of(axes, d);
    l.unary("softmax");
  }
  void reduce(const char* function) const {
    const value& x = l.input(0);
    places all;
    for (std::size_t i = 0; i < x.dims.size(); ++i) all.push_back(static_cast<std::int64_t>(i));
    places axes = axes_or(1, all);
    if (axes.empty() && l.whole("noop_with_empty_axes", 0) == 0) axes = all;
    all_of(axes, x.dims);
    if (x.is_constant) l.refuse_here("its input is a constant, which is not expected here");
    std::set<std::size_t> gone;
    for (const auto a : axes) gone.insert(axis_of(a, x.dims.size(), l.here_->op));
    shape dims;
    for (std::size_t i = 0; i < x.dims.size(); ++i)
      if (!gone.contains(i) || l.whole("keepdims", 1) != 0) dims.push_back(1);
    l.set(0, l.computed(dims, std::string(function) + "(" + x.variable + ")"));
  }
  void lp_norm() const {
    const value& x = l.input(0);
    if (l.whole("p", 2) != 2) l.refuse_here("only p = 2 is possible");
    all_of({l.whole("axis", -1)}, x.dims);
    if (x.is_constant) l.refuse_here("its input is a constant, which is not expected here");
    l.set(0, l.computed(x.dims, "over(" + x.variable + ", length(" + x.variable + "))"));
  }
  void layer_norm() const {
    const value& x = l.input(0);
    const value& scale = l.constant(1, "its scale");
    const std::size_t axis = axis_of(l.whole("axis", -1), x.dims.size(), "LayerNormalization");
    places axes;
    for (std::size_t i = axis; i < x.dims.size(); ++i) axes.push_back(static_cast<std::int64_t>(i));
    all_of(axes, x.dims);
    if (x.is_constant || scale.count() != x.count()) l.refuse_here("its scale has another size");
    std::string text = "times(layer_norm(" + x.variable + ", " + text_of(l.real("epsilon", 1e-5)) + "), " +
                       l.text_of_value(scale) + ")";
    if (l.has(2)) {
      const value& bias = l.constant(2, "its bias");
      if (bias.count() != x.count()) l.refuse_here("its bias has another size");
      text = "plus(" + text + ", " + l.text_of_value(bias) + ")";
    }
    l.set(0, l.computed(x.dims, text));
  }
  void batch_norm() const {
    const value& x = l.input(0);
    value scale, offset;
    if (l.whole("training_mode", 0) != 0) l.refuse_here("it is in training mode: export for inference");
    for (std::size_t i = 1; i < 5; ++i)
      if (l.constant(i, "its statistics").count() != x.count())
        l.refuse_here("its statistics have another size");
    scale.is_constant = offset.is_constant = true;
    for (std::size_t i = 0; i < static_cast<std::size_t>(x.count()); ++i) {
      const double s = l.input(1).numbers[i] / std::sqrt(l.input(4).numbers[i] + l.real("epsilon", 1e-5));
      scale.numbers.push_back(s);
      offset.numbers.push_back(l.input(2).numbers[i] - s * l.input(3).numbers[i]);
    }
    if (x.is_constant) l.refuse_here("its input is a constant, which is not expected here");
    const std::string by = l.text_of_value(scale), and_by = l.text_of_value(offset);
    l.set(0, l.computed(x.dims, "plus(times(" + x.variable + ", " + by + "), " + and_by + ")"));
  }

  // -- recurrent
  void recurrent(int gates) const {
    const value &x = l.input(0), &w = l.constant(1, "W"), &r = l.constant(2, "R");
    const node& n = *l.here_;
    const bool is_lstm = gates == 4;
    if (w.dims.size() != 3 || r.dims.size() != 3 || w.dims[0] != 1 || r.dims[0] != 1)
      l.refuse_here("only one direction is possible");
    const std::int64_t units = r.dims[2], from = w.dims[2];
    if (units < 1 || w.dims[1] != gates * units || r.dims[1] != gates * units ||
        l.whole("hidden_size", units) != units)
      l.refuse_here("its matrices have other sizes than its units");
    if (x.count() != from)
      l.refuse_here("it takes one beat of " + std::to_string(from) + " numbers, and gets " +
                    in_words(x.dims));
    if (x.is_constant) l.refuse_here("its input is a constant, which is not expected here");
    if (n.texts.contains("direction") && n.texts.at("direction") != "forward")
      l.refuse_here("it does not run forward");
    for (const char* other : {"activations"})
      if (n.texts.contains(other)) {
        const std::string usual = is_lstm ? "Sigmoid,Tanh,Tanh" : "Sigmoid,Tanh";
        if (n.texts.at(other) != usual)
          l.refuse_here("its activations are " + n.texts.at(other) + ", not " + usual);
      }
    if (n.reals.contains("clip") || l.whole("input_forget", 0) != 0 || l.whole("layout", 0) != 0)
      l.refuse_here("it has clip, input_forget or layout, which are not possible");
    if (l.has(4)) l.refuse_here("it has lengths of sequences, which are not possible");
    if (is_lstm && l.has(7)) l.refuse_here("it has peepholes, which are not possible");
    std::vector<double> all;
    for (const value* m : {&w, &r}) {
      const std::int64_t columns = m == &w ? from : units;
      if (!is_lstm && m == &r && l.whole("linear_before_reset", 0) == 0) {  // R of z and r, then that of h
        by_columns(all, m->numbers, columns, 0, 2 * units);
        by_columns(all, m->numbers, columns, 2 * units, 3 * units);
      } else by_columns(all, m->numbers, columns, 0, gates * units);
    }
    std::vector<double> bias(static_cast<std::size_t>(2 * gates * units), 0);
    if (l.has(3)) {
      bias = l.constant(3, "B").numbers;
      if (static_cast<std::int64_t>(bias.size()) != 2 * gates * units)
        l.refuse_here("its bias has another size");
    }
    if (is_lstm) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(gates * units); ++i)
        bias[i] += bias[i + static_cast<std::size_t>(gates * units)];
      bias.resize(static_cast<std::size_t>(gates * units));
    }
    all.insert(all.end(), bias.begin(), bias.end());
    const std::string at = l.stored(all);
    const auto before = [&](std::size_t i) {
      value zeros;
      zeros.is_constant = true;
      zeros.numbers.assign(static_cast<std::size_t>(units), 0);
      const value& v = l.has(i) ? l.input(i) : zeros;
      if (l.has(i) && v.count() != units) l.refuse_here("its state has another size than its units");
      return l.text_of_value(v);
    };
    const shape state{1, 1, units};
    if (!is_lstm) {
      const char* kind = l.whole("linear_before_reset", 0) == 0 ? "gru<true>(" : "gru<false>(";
      value h = l.computed(state, kind + at + ", " + x.variable + ", " + before(5) + ")");
      l.set(1, h);
      h.dims = {1, 1, 1, units};
      return l.set(0, h);
    }
    const std::string h0 = before(5), c0 = before(6);
    value both = l.computed(state, "lstm(" + at + ", " + x.variable + ", " + h0 + ", " + c0 + ")");
    value h = both, c = both;
    h.variable += ".h";
    c.variable += ".c";
    l.set(1, h);
    l.set(2, c);
    h.dims = {1, 1, 1, units};
    l.set(0, h);
  }
  static void by_columns(std::vector<double>& to,
                         const std::vector<double>& m,
                         std::int64_t columns,
                         std::int64_t first,
                         std::int64_t end) {
    for (std::int64_t j = 0; j < columns; ++j)
      for (std::int64_t i = first; i < end; ++i)
        to.push_back(m.at(static_cast<std::size_t>(i * columns + j)));
  }
};

}  // namespace cca_policy

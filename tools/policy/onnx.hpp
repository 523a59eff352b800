// What an ONNX file holds: nodes, tensors, inputs, outputs, metadata. Source: onnx.ai, onnx.proto, IR 3
// to 10.
#pragma once

#include <charconv>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "wire.hpp"

namespace cca_policy {

inline constexpr std::int64_t most_numbers = 50'000'000;  // of one tensor

struct tensor {
  std::string name;
  std::vector<std::int64_t> dims;
  std::vector<double> values;
  std::vector<std::int64_t> wholes;  // of tensors of integers
  bool is_whole = false;
  bool is_double = false;
};

struct node {
  std::string op, domain, name;
  std::vector<std::string> inputs, outputs;
  std::map<std::string, double> reals;
  std::map<std::string, std::int64_t> wholes;
  std::map<std::string, std::string> texts;
  std::map<std::string, tensor> tensors;
  std::map<std::string, std::vector<double>> real_lists;
  std::map<std::string, std::vector<std::int64_t>> whole_lists;
  bool has_graph = false;
};

struct value_info {
  std::string name;
  std::vector<std::int64_t> dims;  // -1: not stated
  std::int64_t type = 0;
};

struct onnx_model {
  std::int64_t opset = 0;
  std::string producer;
  std::vector<node> nodes;
  std::vector<tensor> initializers;
  std::vector<value_info> inputs, outputs;
  std::map<std::string, std::string> metadata;
};

namespace onnx_type {
inline constexpr std::uint64_t real = 1, int32 = 6, int64 = 7, boolean = 9, large_real = 11;
}

// As many as the shape says; -1: not a shape that anything of this file can have.
inline std::int64_t count_of(const std::vector<std::int64_t>& dims) {
  std::int64_t count = 1;
  for (const std::int64_t d : dims) {
    if (d < 0 || (d > 0 && count > most_numbers / d)) return -1;
    count *= d;
  }
  return count;
}

// Tensors may lie in other files, as newer exporters write them: NAME.onnx.data beside NAME.onnx. Each tensor
// names the file, where in it its bytes begin, and how many they are.
class weights_beside {
public:
  // What gives the text of a file by its name, from the folder of the model; nothing: there are no others.
  explicit weights_beside(std::function<std::string(const std::string&)> read) : read_(std::move(read)) {}

  std::string_view of(const std::string& tensor, const std::map<std::string, std::string>& said) {
    const auto word = [&](const char* key) {
      const auto found = said.find(key);
      return found == said.end() ? std::string() : found->second;
    };
    const std::string file = word("location"), what = "the tensor `" + tensor + "` lies in `" + file + "`";
    if (!read_)
      refuse(what +
             ", and only this file is known here: write one with the weights inside, in Python by "
             "onnx.save(onnx.load(FILE), NEW_FILE)");
    if (!is_below(file)) refuse(what + ": expected a file in the folder of the model or below it");
    if (!texts_.contains(file)) try {
        texts_[file] = read_(file);
      } catch (const cca::refused& e) { refuse(what + ": " + e.what()); }
    const std::string_view all = texts_[file];
    const std::uint64_t from = size(word("offset"), 0, what);
    if (from > all.size()) refuse_end(what, from, all.size());
    const std::uint64_t count = size(word("length"), all.size() - from, what);
    if (count > all.size() - from)
      refuse_end(what, count > ~from ? ~std::uint64_t{0} : from + count, all.size());
    taken_ += count;  // several tensors may say the same bytes
    if (taken_ > 8 * most_numbers) refuse(what + ": the tensors have more than 400 MB together");
    return all.substr(static_cast<std::size_t>(from), static_cast<std::size_t>(count));
  }

private:
  static bool is_below(const std::string& file) {
    if (file.empty() || file.front() == '/' || file.find('\\') != file.npos || file.find('\0') != file.npos)
      return false;
    for (std::size_t at = 0; at <= file.size();) {
      const std::size_t end = std::min(file.find('/', at), file.size());
      if (file.substr(at, end - at) == "..") return false;
      at = end + 1;
    }
    return true;
  }
  static std::uint64_t size(const std::string& text, std::uint64_t otherwise, const std::string& what) {
    if (text.empty()) return otherwise;
    std::uint64_t n = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), n);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size())
      refuse("damaged: " + what + " at `" + text.substr(0, 40) + "`, which is no number of bytes");
    return n;
  }
  [[noreturn]] static void refuse_end(const std::string& what, std::uint64_t end, std::size_t has) {
    refuse(what + " up to byte " + std::to_string(end) + ", and the file has " + std::to_string(has) +
           ": it is damaged, or of another export");
  }

  std::function<std::string(const std::string&)> read_;
  std::map<std::string, std::string> texts_;
  std::uint64_t taken_ = 0;
};

inline tensor read_tensor(std::string_view bytes, weights_beside& beside) {
  tensor t;
  std::uint64_t type = 0;
  std::string_view raw;
  bool is_raw = false, is_beside = false;
  std::map<std::string, std::string> place;  // in another file
  for (message m(bytes); m.next();) switch (m.field) {
      case 1:
        m.each_varint([&](std::uint64_t d) { t.dims.push_back(static_cast<std::int64_t>(d)); });
        break;
      case 2:
        type = m.number;
        break;
      case 4:
        m.each_fixed<std::uint32_t>([&](std::uint32_t w) { t.values.push_back(std::bit_cast<float>(w)); });
        break;
      case 5:
      case 7:
        m.each_varint([&](std::uint64_t w) {
          t.wholes.push_back(m.field == 5 ? static_cast<std::int32_t>(w) : static_cast<std::int64_t>(w));
        });
        break;
      case 8:
        t.name = m.text();
        break;
      case 9:
        raw = m.inner();
        is_raw = true;
        break;
      case 10:
        m.each_fixed<std::uint64_t>([&](std::uint64_t w) { t.values.push_back(std::bit_cast<double>(w)); });
        break;
      case 13: {
        std::string key;
        for (message e(m.inner()); e.next();) {
          if (e.field == 1) key = e.text();
          if (e.field == 2) place[key] = e.text();
        }
        is_beside = true;
        break;
      }
      case 14:
        is_beside = is_beside || m.number != 0;
        break;
      default:
        break;
    }
  if (t.dims.size() > 8) refuse("the tensor `" + t.name + "` has more than 8 dimensions");
  t.is_whole = type == onnx_type::int32 || type == onnx_type::int64 || type == onnx_type::boolean;
  t.is_double = type == onnx_type::large_real;
  if (!t.is_whole && type != onnx_type::real && type != onnx_type::large_real)
    refuse("the tensor `" + t.name + "` has numbers of type " + std::to_string(type) +
           ", neither float nor double nor an integer of 32 or 64 bits: export in float");
  if (is_beside) {
    raw = beside.of(t.name, place);
    is_raw = true;
  }
  if (is_raw) {
    const std::size_t width = type == onnx_type::boolean                            ? 1
                              : type == onnx_type::real || type == onnx_type::int32 ? 4
                                                                                    : 8;
    if (raw.size() % width != 0) refuse("damaged: the tensor `" + t.name + "` ends within a number");
    t.values.clear();
    t.wholes.clear();
    for (std::size_t at = 0; at < raw.size(); at += width) {
      std::uint64_t word = 0;
      for (std::size_t i = 0; i < width; ++i)
        word |= static_cast<std::uint64_t>(static_cast<unsigned char>(raw[at + i])) << (8 * i);
      if (type == onnx_type::real) t.values.push_back(std::bit_cast<float>(static_cast<std::uint32_t>(word)));
      else if (type == onnx_type::large_real) t.values.push_back(std::bit_cast<double>(word));
      else if (width == 4) t.wholes.push_back(static_cast<std::int32_t>(word));
      else t.wholes.push_back(static_cast<std::int64_t>(word));
    }
  }
  const auto found = static_cast<std::int64_t>(t.is_whole ? t.wholes.size() : t.values.size());
  if (count_of(t.dims) != found)
    refuse("damaged: the tensor `" + t.name + "` has " + std::to_string(found) +
           " numbers, which is not what its shape says");
  return t;
}

inline void read_attribute(std::string_view bytes, node& n, weights_beside& beside) {
  std::string name;
  for (message m(bytes); m.next();) switch (m.field) {
      case 1:
        name = m.text();
        break;
      case 2:
        n.reals[name] = m.real();
        break;
      case 3:
        n.wholes[name] = m.whole();
        break;
      case 4:
        n.texts[name] = m.text();
        break;
      case 5:
        n.tensors[name] = read_tensor(m.inner(), beside);
        break;
      case 6:
      case 11:
        n.has_graph = true;
        break;
      case 7:
        m.each_fixed<std::uint32_t>(
            [&](std::uint32_t w) { n.real_lists[name].push_back(std::bit_cast<float>(w)); });
        break;
      case 8:
        m.each_varint([&](std::uint64_t w) { n.whole_lists[name].push_back(static_cast<std::int64_t>(w)); });
        break;
      case 9:
        n.texts[name] += (n.texts[name].empty() ? "" : ",") + m.text();
        break;
      default:
        break;
    }
}

inline node read_node(std::string_view bytes, weights_beside& beside) {
  node n;
  for (message m(bytes); m.next();) switch (m.field) {
      case 1:
        n.inputs.push_back(m.text());
        break;
      case 2:
        n.outputs.push_back(m.text());
        break;
      case 3:
        n.name = m.text();
        break;
      case 4:
        n.op = m.text();
        break;
      case 5:
        read_attribute(m.inner(), n, beside);
        break;
      case 7:
        n.domain = m.text();
        break;
      default:
        break;
    }
  return n;
}

// The shape of a value: in TypeProto, the tensor's shape, whose dimensions are numbers or names.
inline value_info read_value(std::string_view bytes) {
  value_info v;
  for (message m(bytes); m.next();) {
    if (m.field == 1) v.name = m.text();
    if (m.field != 2) continue;
    for (message type(m.inner()); type.next();) {
      if (type.field != 1) continue;
      for (message of(type.inner()); of.next();) {
        if (of.field == 1 && !of.is_bytes) v.type = of.whole();
        if (of.field != 2) continue;
        for (message shape(of.inner()); shape.next();) {
          if (shape.field != 1) continue;
          std::int64_t size = -1;
          for (message d(shape.inner()); d.next();)
            if (d.field == 1 && !d.is_bytes) size = d.whole();
          v.dims.push_back(size);
          if (v.dims.size() > 8) refuse("`" + v.name + "` has more than 8 dimensions");
        }
      }
    }
  }
  return v;
}

// `beside_it` gives the text of another file from the folder of this one.
inline onnx_model read_onnx(std::string_view file,
                            std::function<std::string(const std::string&)> beside_it = {}) {
  weights_beside beside(std::move(beside_it));
  onnx_model r;
  bool has_graph = false;
  for (message m(file); m.next();) {
    std::string key, value;
    switch (m.field) {
      case 2:
        r.producer = m.text();
        break;
      case 7:
        has_graph = true;
        for (message g(m.inner()); g.next();) {
          if (g.field == 1) r.nodes.push_back(read_node(g.inner(), beside));
          if (g.field == 5) r.initializers.push_back(read_tensor(g.inner(), beside));
          if (g.field == 11) r.inputs.push_back(read_value(g.inner()));
          if (g.field == 12) r.outputs.push_back(read_value(g.inner()));
          if (g.field == 15) refuse("it has sparse tensors: export them dense");
        }
        break;
      case 8: {
        std::int64_t version = 0;
        for (message e(m.inner()); e.next();) {
          if (e.field == 1) key = e.text();
          if (e.field == 2) version = e.whole();
        }
        if (key.empty() || key == "ai.onnx") r.opset = version;
        break;
      }
      case 14:
        for (message e(m.inner()); e.next();) {
          if (e.field == 1) key = e.text();
          if (e.field == 2) value = e.text();
        }
        r.metadata[key] = value;
        break;
      default:
        break;
    }
  }
  if (!has_graph || r.nodes.empty()) refuse("not an ONNX file, or one without a network");
  if (r.opset < 7 || r.opset > 24)
    refuse("opset " + std::to_string(r.opset) + " is not known here: export with one from 7 to 24");
  return r;
}

}  // namespace cca_policy

// What the tool has to say about a file: errors, for which it writes nothing, and notes about what it leaves
// out. Each has the line in the file, like a compiler's.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace cca_urdf {

struct remark {
  int line = 0;  // of the file; 0: of the whole file
  bool is_error = false;
  std::string text;
};

class remarks {
public:
  void error(int line, std::string text) {
    all_.push_back({line, true, std::move(text)});
    ++errors_;
  }
  void note(int line, std::string text) { all_.push_back({line, false, std::move(text)}); }

  long errors() const { return errors_; }
  bool has_error() const { return errors() > 0; }
  bool has_note() const { return errors() < static_cast<long>(all_.size()); }

  // By line; those of one line in the order in which they were said.
  std::vector<remark> sorted() const {
    std::multimap<int, const remark*> by_line;
    for (const remark& r : all_) by_line.emplace(r.line, &r);
    std::vector<remark> all;
    for (const auto& [line, r] : by_line) all.push_back(*r);
    return all;
  }

private:
  std::vector<remark> all_;
  long errors_ = 0;
};

inline std::string text_of(const std::vector<remark>& all, const std::string& file) {
  std::string text;
  for (const remark& r : all)
    text += file + (r.line > 0 ? ":" + std::to_string(r.line) : "") +
            (r.is_error ? ": error: " : ": note: ") + r.text + "\n";
  return text;
}

}  // namespace cca_urdf

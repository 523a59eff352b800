// The functions that the page calls. A text is returned as its address; text_size() is its length.
#include <cstring>
#include <string>

#include "live_program.hpp"

namespace {

cca::page::live_program& of_page() { return cca::page::program(); }

std::string text;
const char* returned(std::string&& t) {
  text = std::move(t);
  return text.data();
}

}  // namespace

extern "C" {

[[clang::export_name("text_size")]] std::size_t page_text_size() { return text.size(); }
[[clang::export_name("description")]] const char* page_description() {
  return returned(of_page().description());
}
[[clang::export_name("parameters")]] const char* page_parameters() {
  return returned(of_page().parameters());
}
[[clang::export_name("status")]] const char* page_status() { return returned(of_page().status()); }
[[clang::export_name("advance")]] int page_advance(int beats) { return of_page().advance(beats); }
[[clang::export_name("begin_anew")]] void page_begin_anew() { of_page().begin_anew(); }
[[clang::export_name("change")]] void page_change(int transition) { of_page().change(transition); }
[[clang::export_name("set")]] const char* page_set(int field, double value) {
  return returned(of_page().set(field, value));
}
[[clang::export_name("push")]] void page_push(double x, double y, double z, double seconds) {
  of_page().push(x, y, z, seconds);
}
[[clang::export_name("press")]] void page_press(int button, int down) { of_page().press(button, down != 0); }
[[clang::export_name("take_snapshot")]] void page_take_snapshot() { of_page().take_snapshot(); }
[[clang::export_name("go_back")]] bool page_go_back(double beat) {
  return of_page().go_back(static_cast<std::int64_t>(beat));
}
[[clang::export_name("rows")]] double* page_rows() { return of_page().rows(); }
[[clang::export_name("row_width")]] int page_row_width() { return of_page().row_width(); }
[[clang::export_name("origins")]] double* page_origins() { return of_page().origins(); }
[[clang::export_name("published")]] double* page_published() { return of_page().published(); }
[[clang::export_name("poses")]] double* page_poses() { return of_page().poses(); }

}  // extern "C"

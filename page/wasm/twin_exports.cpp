// The functions of a twin that the page calls. A text is returned as its address; text_size() is its length.
#include <cstddef>
#include <string>

#include "twin.hpp"

namespace {

std::string text;

}  // namespace

extern "C" {

[[clang::export_name("text_size")]] std::size_t twin_text_size() { return text.size(); }
[[clang::export_name("begin")]] void twin_begin() { cca::page::twin().begin(); }
[[clang::export_name("room")]] unsigned char* twin_room(std::size_t size) {
  return cca::page::twin().room(size);
}
[[clang::export_name("take")]] void twin_take() { cca::page::twin().take(); }
[[clang::export_name("result")]] const char* twin_result() {
  text = cca::page::twin().result();
  return text.data();
}

}  // extern "C"

// Exceptions in WebAssembly. Debian's libc++abi for it has none, and the library throws only between two
// beats, to refuse a call that then has changed nothing. So a throw becomes an exception of the page's
// language: it leaves all frames at once, and the page shows the text. No destructor runs, so a refusal leaks
// a few hundred bytes.
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <typeinfo>

#include <cca/base/refused.hpp>

extern "C" {

[[clang::import_module("page"), clang::import_name("refuse"), noreturn]] void page_refuse(const char* text,
                                                                                          std::size_t size);

void* __cxa_allocate_exception(std::size_t size) { return std::malloc(size); }
void __cxa_free_exception(void* thrown) { std::free(thrown); }
[[noreturn]] void __cxa_throw(void* thrown, std::type_info* type, void (*)(void*)) {
  const char* text = type->name();
  if (*type == typeid(cca::refused)) text = static_cast<cca::refused*>(thrown)->what();
  else if (*type == typeid(std::runtime_error)) text = static_cast<std::runtime_error*>(thrown)->what();
  page_refuse(text, std::strlen(text));
}
void* __cxa_begin_catch(void* thrown) { return thrown; }
void __cxa_end_catch() {}
[[noreturn]] void __cxa_rethrow() { std::abort(); }

}  // extern "C"

// A recording in a page: one HTML file, which opens in a browser without server and network.
//
//   cca::recording::write_page("trot.html", "trot.mcap", cca::recording::page_without_recording());
//
// The page without a recording is page/recording.html of cca; the target cca::record states where it is.
// Errors: cca::refused if it is missing or is none, std::system_error if a file can't be read or written. An
// HTML file of this name is replaced when the new one is complete. Test: tests/runtime/record/page.cpp;
// docs/page.md.
#pragma once

#include <string>

#include <cca/base/separate/compiled.hpp>

namespace cca::recording {

// Throws cca::refused if it isn't there.
std::string existing_page(const std::string& file);

inline std::string page_without_recording() {
#ifdef CCA_RECORDING_PAGE
  return existing_page(CCA_RECORDING_PAGE);
#else
  return existing_page("");
#endif
}

void write_page(const std::string& page, const std::string& recording, const std::string& from);

}  // namespace cca::recording

#if !CCA_HAS_COMPILED_RECORD
#include <cca/record/page_functions.hpp>
#endif

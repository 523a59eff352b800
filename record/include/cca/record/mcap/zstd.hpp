// Chunks are compressed by Zstandard. Needs libzstd.
#pragma once

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <zstd.h>

#include <cca/record/mcap/bytes.hpp>

namespace cca::recording::detail {

class zstd_compressor {
public:
  explicit zstd_compressor(int compression_level) : level(compression_level), context(ZSTD_createCCtx()) {}

  // Valid until the next call.
  byte_view compress(byte_view from) {
    to.resize(ZSTD_compressBound(from.size()));
    const std::size_t size =
        ZSTD_compressCCtx(context.get(), to.data(), to.size(), from.data(), from.size(), level);
    if (ZSTD_isError(size)) throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(size));
    return {to.data(), size};
  }

private:
  struct release {
    void operator()(ZSTD_CCtx* c) const { ZSTD_freeCCtx(c); }
  };
  int level;
  std::unique_ptr<ZSTD_CCtx, release> context;
  std::vector<unsigned char> to;
};

// False: it is damaged, or not exactly as long as `to`.
inline bool decompress_zstd(byte_view from, std::vector<unsigned char>& to) {
  const std::size_t size = ZSTD_decompress(to.data(), to.size(), from.data(), from.size());
  return !ZSTD_isError(size) && size == to.size();
}

}  // namespace cca::recording::detail

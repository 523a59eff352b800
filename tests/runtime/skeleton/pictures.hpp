// Pictures of graphs whose spaces stand in an unnamed namespace: compilers spell that in two ways, and the pages not at all.
#pragma once

#include <string>
#include <string_view>

inline std::string plain(std::string picture) {
  for (const std::string_view unnamed : {"{anonymous}::", "(anonymous namespace)::"})
    for (auto at = picture.find(unnamed); at != picture.npos; at = picture.find(unnamed)) picture.erase(at, unnamed.size());
  return picture;
}

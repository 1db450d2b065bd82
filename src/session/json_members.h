// Documents are JSON objects. A program that knows only some of their members preserves the others.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/result.h"

namespace macula::session {

inline constexpr std::size_t kMostJsonBytes = 8'000'000;
inline constexpr int kMostJsonDepth = 64;

// Whether it is an object in UTF-8, within both limits.
bool isDocument(std::string_view json);

// `written`, with the members of `before` that it lacks and whose path is not in `known`. Recurses into an
// object if `known` has a longer path: with "camera" and "camera.eye" unknown members of camera stay, with
// "camera" alone camera is as written. Returns `written` itself if there is nothing to add.
std::string withUnknownMembers(std::string_view written, std::string_view before,
                               std::span<const std::string_view> known);

}  // namespace macula::session

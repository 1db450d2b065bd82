// Documents are JSON objects, of which a program may know only a part: what it does not know it hands on.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/result.h"

namespace macula::session {

inline constexpr std::size_t kMostJsonBytes = 8'000'000;
inline constexpr int kMostJsonDepth = 64;

// An object in UTF-8, not longer and not deeper than that.
bool isDocument(std::string_view json);

// `written`, with the members of `before` that it lacks and whose path is not in `known`. Objects are looked
// into where `known` has a longer path: with "camera" and "camera.eye" unknown members of camera stay, with
// "camera" alone camera is as written. Where there is nothing to add, the text is `written` itself.
std::string withUnknownMembers(std::string_view written, std::string_view before,
                               std::span<const std::string_view> known);

}  // namespace macula::session

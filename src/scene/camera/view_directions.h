// The names of view directions as a user types them: anterior, posterior, left, right, superior, inferior,
// oblique, three-quarter, turned.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/frames.h"

namespace macula::scene {

// Nothing for an unknown name.
std::optional<ViewDirection> viewDirectionOf(std::string_view name);

std::string nameOf(ViewDirection direction);

}  // namespace macula::scene

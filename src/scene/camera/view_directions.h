// The directions that a patient is looked at from, as a person types them: anterior, posterior, left, right,
// superior, inferior, oblique, three-quarter, turned.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/frames.h"

namespace macula::app {

// Nothing for a name that no direction has.
std::optional<ViewDirection> viewDirectionOf(std::string_view name);

std::string nameOf(ViewDirection direction);

}  // namespace macula::app

// Identifies a point of a transfer function by curve and index.
#pragma once

#include <cstddef>

namespace macula::viewer {

struct PointId {
    enum class Curve { opacity, colour };
    Curve curve = Curve::opacity;
    std::size_t index = 0;

    bool operator==(const PointId&) const = default;
};

}  // namespace macula::viewer

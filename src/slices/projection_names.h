// Names of projections, as in files.
#pragma once

#include <array>
#include <string_view>

#include "slices/sampled_slice.h"

namespace macula::slices {

inline constexpr std::array kProjections{Projection::mean, Projection::maximum, Projection::minimum};

constexpr std::string_view nameOf(Projection projection) {
    switch (projection) {
        case Projection::mean:
            return "mean";
        case Projection::maximum:
            return "maximum";
        case Projection::minimum:
            return "minimum";
    }
    return {};
}

}  // namespace macula::slices

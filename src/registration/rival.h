// Finds a second place where two volumes are nearly as alike, such as a spine one vertebra off.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "registration/comparison.h"
#include "registration/pattern_search.h"

namespace macula::registration {

struct Rival {
    Highest place;
    double shiftMm = 0.0;  // distance of the fixed volume's middle from its place in the answer
    // The share of the likeness lost between both places that returns at this one: 1 means that it fits as
    // well as the answer. Features that are the same everywhere, such as the outline of a trunk, do not
    // count.
    double share = 0.0;
};

// The rival with the largest share, at least 10 mm from `answer`. Starts from the three highest peaks along
// the patient, up to 160 mm to both sides, and from three of `others`, the runners-up of a coarser search. At
// most 66 comparisons and six calls of `search`, which climbs from a start to the highest value around it.
std::optional<Rival> strongestRival(const Comparison& on, const Parameters& answer,
                                    std::span<const Parameters> others,
                                    const std::function<Highest(const Parameters&)>& search);

}  // namespace macula::registration

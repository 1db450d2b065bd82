// Another place where two volumes are nearly as much alike: a spine fits itself one vertebra off.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "registration/comparison.h"
#include "registration/pattern_search.h"

namespace macula::registration {

struct Rival {
    Highest place;
    double shiftMm = 0.0;  // how far it moves the middle of the fixed volume from where the answer has it
    // How much of the likeness that is lost between both comes back there: 1, it fits as well as the answer.
    // What lies the same everywhere, such as the outline of a trunk, counts for nothing in it.
    double share = 0.0;
};

// The one of the largest share that is at least a centimetre from `answer`. Looked for along the patient up
// to 160 mm to both sides, and from `others`, the runners-up of a coarser search. At most 65 comparisons, and
// six searches of `search`, which leads from a start to the highest value around it.
std::optional<Rival> strongestRival(const Comparison& on, const Parameters& answer,
                                    std::span<const Parameters> others,
                                    const std::function<Highest(const Parameters&)>& search);

}  // namespace macula::registration

// Combines two pictures of the same view: one that is lit by what many views have found (lit_view.h), which
// has hardly any noise but what its places have in common, such as a cell that holds the light of two walls;
// and one that is traced, whose mean over many pixels is right.
#pragma once

#include "pipeline/hybrid/light/traced_view.h"

namespace macula::hybrid {

// `lit`, made as bright as `traced` in each colour over some 16 pixels around each pixel, but no more than
// twice and no less than half as bright as it was; of that and of `traced` a mean, in which `traced` counts
// for `tracedShare` (0 to 1). Coverage is that of `lit`, samples are those of `traced`. Where one of them is
// not known (not finite) it is the other. Both of the same camera and size, linear and premultiplied.
TracedView combined(const TracedView& traced, TracedView lit, double tracedShare);

}  // namespace macula::hybrid

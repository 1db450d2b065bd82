// Combines two pictures of the same view: a lit one, whose light many views have found (lit_view.h), with
// hardly any noise but shared errors, such as a cell that mixes the light of two walls; and a traced one,
// whose mean over many pixels is right.
#pragma once

#include "pipeline/hybrid/light/traced_view.h"

namespace macula::hybrid {

// Scales `lit`, in each colour and by a half to twofold, to the brightness of `traced` over some 16 pixels
// around each pixel. Then mixes in `traced` with the weight `tracedShare` (0 to 1). Coverage is that of
// `lit`, samples are those of `traced`. Where one picture is unknown (not finite), the other one stands
// alone. Both must have the same camera and size, and be linear and premultiplied.
TracedView combined(const TracedView& traced, TracedView lit, double tracedShare);

}  // namespace macula::hybrid

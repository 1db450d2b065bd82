// Whether two transfer functions are one to who looks at the picture.
#pragma once

#include "pipeline/volume/transfer_function.h"

namespace macula::app {

// Whether both draw the same, whatever else is in the files that they come from.
bool isSame(const TransferFunction& a, const TransferFunction& b);

}  // namespace macula::app

// Whether two transfer functions are the same to a user.
#pragma once

#include "pipeline/volume/transfer_function.h"

namespace macula::scene {

// Whether both are equal in everything but the document (TransferFunction::document).
bool isSame(const TransferFunction& a, const TransferFunction& b);

}  // namespace macula::scene

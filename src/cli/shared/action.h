// The work of a verb, which begins when the whole command line is understood.
#pragma once

#include <functional>

#include "base/result.h"

namespace macula::cli {

using Action = std::function<Result<void>()>;

}  // namespace macula::cli

// Turns exceptions of the standard library and of other libraries into errors for a person.
#pragma once

#include <exception>
#include <string>

#include "base/result.h"

namespace macula {

// The error for an exception thrown during `task`, such as Text("read this folder"). Lack of memory or of
// threads gives outOfMemory; every other exception gives inputNotUsable. The exception's own text may name a
// patient, so it is neither shown nor logged; its type is logged.
Error errorOf(const std::exception& thrown, Text task, std::string where = {});

}  // namespace macula

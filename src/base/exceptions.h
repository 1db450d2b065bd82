// Exceptions of the standard library and of others, as errors for a person.
#pragma once

#include <exception>
#include <string>

#include "base/result.h"

namespace macula {

// The error for an exception thrown during `task`, such as Text("read this folder"). Lack of memory or of
// threads is outOfMemory; every other exception is inputNotUsable. The exception's own text may name a
// patient and is neither shown nor logged; its type is logged.
Error errorOf(const std::exception& thrown, Text task, std::string where = {});

}  // namespace macula

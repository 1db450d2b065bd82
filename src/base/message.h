// A message about a series, a volume or a file: a sentence for a person, and a stable key with typed
// arguments for programs and tests.
#pragma once

#include <string>
#include <vector>

#include "base/text.h"

namespace macula {

enum class Severity {
    info,           // nothing to do
    warning,        // it is shown, but check this before you rely on it
    blocksVolume,   // cannot be shown in 3D
    blocksLoading,  // cannot be shown at all
};

// `sentence` and `action` (what to do) hold no patient data. A key never changes its meaning.
struct Message {
    Severity severity = Severity::info;
    std::string key;
    std::vector<TextArgument> arguments;
    Text sentence;
    Text action;

    bool operator==(const Message&) const = default;
};

}  // namespace macula

// A message about a series, a volume or a file: a sentence for a person, and a stable key with typed
// arguments for programs and tests.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace macula {

enum class Severity {
    info,           // nothing to do
    warning,        // shown, but look at it before relying on it
    blocksVolume,   // cannot be shown in 3D
    blocksLoading,  // cannot be shown at all
};

using MessageValue = std::variant<std::int64_t, double, std::string>;

struct MessageArgument {
    std::string name;
    MessageValue value;

    bool operator==(const MessageArgument&) const = default;
};

// `sentence` and `action` (what to do) hold no patient data. A key never changes its meaning.
struct Message {
    Severity severity = Severity::info;
    std::string key;
    std::vector<MessageArgument> arguments;
    std::string sentence;
    std::string action;

    bool operator==(const Message&) const = default;
};

}  // namespace macula

// Uses what was read of a message as the program does.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/check.h"
#include "base/utf8.h"
#include "net/archive/file_meta.h"
#include "net/dimse/command.h"
#include "net/dimse/identifier.h"

namespace macula::net {

inline void useIdentifier(std::span<const std::uint8_t> bytes, std::string_view transferSyntax) {
    const auto keys = identifierOf(bytes, transferSyntax);
    if (!keys) return;
    for (const auto& [key, value] : *keys) {
        MACULA_CHECK(isValidUtf8(value));
        for (const std::string& each : allValues(*keys, key)) MACULA_CHECK(isValidUtf8(each));
        static_cast<void>(numberValue(*keys, key));
        const std::string uid = uidValue(*keys, key);
        MACULA_CHECK(uid.empty() || isUid(uid));
    }
}

inline void useCommand(std::span<const std::uint8_t> bytes) {
    const auto command = commandOf(bytes);
    if (!command) return;
    const auto again = commandOf(bytesOf(*command));
    MACULA_CHECK(again && again->field == command->field && again->status == command->status);
}

}  // namespace macula::net

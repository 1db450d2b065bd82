// Any bytes as one command and as one identifier of an association: ends in an error, or in texts that can be
// used.
#include <cstdint>
#include <span>
#include <string>

#include "net/dimse/contexts.h"
#include "use_messages.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace macula::net;
    if (size == 0) return 0;
    const std::span<const std::uint8_t> rest(data + 1, size - 1);
    switch (data[0] % 3) {
        case 0:
            useCommand(rest);
            break;
        case 1:
            useIdentifier(rest, kExplicitLittleEndian);
            break;
        default:
            useIdentifier(rest, kImplicitLittleEndian);
    }
    return 0;
}

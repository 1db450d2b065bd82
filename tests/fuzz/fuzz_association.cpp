// Any bytes as what an archive sends over an association, from its answer to our request on; and as one
// command, and as one identifier. Whatever comes ends in an error that can be told, or in texts that can be
// used.
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "base/check.h"
#include "base/utf8.h"
#include "net/archive/file_meta.h"
#include "net/dimse/association.h"
#include "net/dimse/command.h"
#include "net/dimse/contexts.h"
#include "net/dimse/identifier.h"
#include "net/dimse/messages.h"
#include "net/dimse/wire.h"

namespace macula::net {
namespace {

constexpr std::size_t kMostBytes = 64 << 10;  // that a socket takes without being read
constexpr int kMostMessages = 64;
constexpr std::size_t kMostBytesOfAnswer = 16 << 10;
constexpr std::chrono::seconds kPatience{5};
const std::string kFindModel = "1.2.840.10008.5.1.4.1.2.2.1";
const std::string kCtImage = "1.2.840.10008.5.1.4.1.1.2";

void useIdentifier(std::span<const std::uint8_t> bytes, std::string_view transferSyntax) {
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

void useCommand(std::span<const std::uint8_t> bytes) {
    const auto command = commandOf(bytes);
    if (!command) return;
    const auto again = commandOf(bytesOf(*command));
    MACULA_CHECK(again && again->field == command->field && again->status == command->status);
}

// The peer has said all that it will, and hangs up.
std::unique_ptr<Wire> wireWith(std::span<const std::uint8_t> bytes, int& peer) {
    int ends[2] = {-1, -1};
    MACULA_CHECK(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, ends) == 0);
    peer = ends[1];
    const ssize_t sent = bytes.empty() ? 0 : send(peer, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    MACULA_CHECK(sent == static_cast<ssize_t>(bytes.size()));
    shutdown(peer, SHUT_WR);
    return std::make_unique<Wire>(ends[0], kPatience, CancelToken());
}

void converse(std::span<const std::uint8_t> bytes) {
    int peer = -1;
    auto wire = wireWith(bytes, peer);
    auto association = Association::request(
        std::move(wire), {"MACULA", "ARCHIVE"},
        {plainContext(kFindModel), {kCtImage, {std::string(kExplicitLittleEndian)}, true}});
    if (!association) {
        MACULA_CHECK(!association.error().message.empty() && !association.error().hint.empty());
    } else {
        for (int message = 0; message < kMostMessages; ++message) {
            const auto received = receiveCommand(**association);
            if (!received) break;
            const AcceptedContext* context = (*association)->contextOf(received->context);
            if (!received->command.hasDataset) continue;
            const auto dataset = receiveSmallDataset(**association, received->context, kMostBytesOfAnswer);
            if (!dataset) break;
            MACULA_CHECK_LE(dataset->bytes.size(), kMostBytesOfAnswer);
            if (context != nullptr) useIdentifier(dataset->bytes, context->transferSyntax);
        }
        association->reset();
    }
    close(peer);
}

}  // namespace
}  // namespace macula::net

// DCMTK 3.6.7 loses a few bytes of an answer that it finds malformed.
extern "C" const char* __lsan_default_suppressions();  // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libdcmnet\n";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace macula::net;
    if (size == 0) return 0;
    const std::span<const std::uint8_t> rest(data + 1, std::min(size - 1, kMostBytes));
    switch (data[0] % 4) {
        case 0:
            useCommand(rest);
            break;
        case 1:
            useIdentifier(rest, kExplicitLittleEndian);
            break;
        case 2:
            useIdentifier(rest, kImplicitLittleEndian);
            break;
        default:
            converse(rest);
    }
    return 0;
}

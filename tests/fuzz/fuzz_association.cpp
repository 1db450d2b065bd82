// Any bytes as what an archive sends over an association, from its answer to our request on: ends in an error
// that can be told, or in texts that can be used.
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "base/check.h"
#include "net/dimse/association.h"
#include "net/dimse/contexts.h"
#include "net/dimse/messages.h"
#include "net/dimse/wire.h"
#include "use_messages.h"

namespace macula::net {
namespace {

constexpr std::size_t kMostBytes = 64 << 10;  // that a socket takes without being read
constexpr int kMostMessages = 64;
constexpr std::size_t kMostBytesOfAnswer = 16 << 10;
// A peer that is answered more than it reads is given up at once.
constexpr std::chrono::milliseconds kPatience{20};
const std::string kFindModel = "1.2.840.10008.5.1.4.1.2.2.1";
const std::string kCtImage = "1.2.840.10008.5.1.4.1.1.2";

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
    converse({data, std::min(size, kMostBytes)});
    return 0;
}

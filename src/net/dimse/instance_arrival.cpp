#include "net/dimse/instance_arrival.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <span>
#include <utility>
#include <vector>

#include "net/archive/file_meta.h"
#include "net/dimse/contexts.h"
#include "net/dimse/elements.h"

namespace macula::net {

namespace {

using Fate = ArrivedInstance::Fate;

constexpr std::size_t kMostBytesOfHead = std::size_t{256} << 10;
constexpr std::uint32_t kStudyInstanceUid = 0x0020000d;

// A file that is written to its end, or dropped.
class InstanceFile {
  public:
    explicit InstanceFile(const std::filesystem::path& path)
        : descriptor_(::open(path.c_str(), O_WRONLY | O_TRUNC | O_NOFOLLOW | O_CLOEXEC)) {}
    ~InstanceFile() { close(); }
    InstanceFile(const InstanceFile&) = delete;
    InstanceFile& operator=(const InstanceFile&) = delete;

    bool write(const void* bytes, std::size_t count) {
        const char* at = static_cast<const char*>(bytes);
        while (count > 0) {
            const ssize_t written = ::write(descriptor_, at, count);
            if (written < 0 && errno == EINTR) continue;
            if (written <= 0) return false;
            at += written;
            count -= static_cast<std::size_t>(written);
        }
        return descriptor_ >= 0;
    }
    bool close() {
        if (descriptor_ < 0) return false;
        return ::close(std::exchange(descriptor_, -1)) == 0;
    }

  private:
    int descriptor_;
};

// Of the beginning of a dataset; empty where it is not found there.
std::string studyOfHead(std::span<const unsigned char> head, std::string_view transferSyntax) {
    Encoding encoding{};
    std::string study;
    if (!encodingOf(transferSyntax, encoding)) return study;
    forEachElement(head, encoding, [&](const Element& element) {
        if (element.tag == kStudyInstanceUid) study = textOf(element);
        return element.tag < kStudyInstanceUid;
    });
    return study;
}

// Receives one instance; its steps share what they have.
class Arrival {
  public:
    Arrival(Association& association, const ReceivedCommand& request, Receiver& receiver,
            const ArrivalLimits& limits)
        : association_(association), request_(request), receiver_(receiver), limits_(limits) {}

    ArrivedInstance run() {
        const Command& command = request_.command;
        if (!isUid(command.sopClassUid) || !isUid(command.sopInstanceUid))
            return readOver(Fate::nameless, {}, limits_.mostBytes);
        const Result<std::filesystem::path> place = receiver_.place();
        if (!place) return readOver(Fate::withoutRoom, place.error(), limits_.mostReadOver);
        return write(*place);
    }

  private:
    ArrivedInstance readOver(Fate fate, std::optional<Error> error, std::uintmax_t most) {
        if (most == 0 && fate == Fate::withoutRoom) return {.fate = fate, .error = std::move(error)};
        std::uintmax_t count = 0;
        const Result<void> ignored = receiveDataset(
            association_, request_.context, [&](std::span<const unsigned char> bytes) -> Result<void> {
                count += bytes.size();
                if (count > most) return notWhatDicomSays();
                return {};
            });
        if (!ignored && fate == Fate::nameless) return {.fate = Fate::cutOff, .error = ignored.error()};
        return {.fate = fate, .isReadToTheEnd = ignored.ok(), .error = std::move(error)};
    }

    ArrivedInstance write(const std::filesystem::path& place) {
        const AcceptedContext* context = association_.contextOf(request_.context);
        MACULA_CHECK(context != nullptr);
        InstanceFile file(place);
        const std::string meta = fileMetaBytes(
            {request_.command.sopClassUid, request_.command.sopInstanceUid, context->transferSyntax});
        std::uintmax_t count = meta.size();
        std::uintmax_t readOver = 0;
        bool isWritten = file.write(meta.data(), meta.size());
        bool isTooLarge = false;
        std::vector<unsigned char> head;
        const Result<void> received = receiveDataset(
            association_, request_.context, [&](std::span<const unsigned char> bytes) -> Result<void> {
                count += bytes.size();
                isTooLarge = isWritten && count > limits_.mostBytes;
                if (isTooLarge) return notWhatDicomSays();
                isWritten =
                    isWritten && limits_.hasRoomFor(bytes.size()) && file.write(bytes.data(), bytes.size());
                if (!isWritten) {
                    readOver += bytes.size();
                    return readOver <= limits_.mostReadOver ? Result<void>() : notWhatDicomSays();
                }
                const std::size_t wanting = kMostBytesOfHead - std::min(kMostBytesOfHead, head.size());
                const auto part = bytes.first(std::min(wanting, bytes.size()));
                head.insert(head.end(), part.begin(), part.end());
                return {};
            });
        isWritten = file.close() && isWritten;
        if (received && isWritten)
            return {.fate = Fate::whole,
                    .isReadToTheEnd = true,
                    .file = place,
                    .studyInstanceUid = studyOfHead(head, context->transferSyntax)};
        receiver_.drop(place);
        if (!isWritten) return {.fate = Fate::withoutRoom, .isReadToTheEnd = received.ok()};
        if (isTooLarge) return {.fate = Fate::tooLarge};
        return {.fate = Fate::cutOff, .error = received.error()};
    }

    Association& association_;
    const ReceivedCommand& request_;
    Receiver& receiver_;
    const ArrivalLimits& limits_;
};

}  // namespace

ArrivedInstance receiveInstance(Association& association, const ReceivedCommand& request, Receiver& receiver,
                                const ArrivalLimits& limits) {
    return Arrival(association, request, receiver, limits).run();
}

}  // namespace macula::net

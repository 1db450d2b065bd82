#include "net/dimse/send.h"

#include <algorithm>
#include <fstream>

#include "net/dimse/contexts.h"
#include "net/dimse/messages.h"

namespace macula::net {

namespace {

constexpr int kTriesToSend = 3;
// More than a fragment: the association cuts it as small as the archive wants.
constexpr std::size_t kBytesOfPart = std::size_t{256} << 10;

Error otherTransferSyntax() {
    return archiveError(Text("The archive does not take the encoding of this file."),
                        Text("Macula sends files as they are. Convert the file with other software, or ask "
                             "the administrator of the archive to allow this transfer syntax."));
}

Error cutOffFile() {
    return {ErrorCode::inputNotUsable,
            Text("This file is cut off or damaged."),
            {},
            Text("Get the file again from where it came from.")};
}

Error namelessFile() {
    return {ErrorCode::inputNotUsable,
            Text("The file does not name the object that it holds."),
            {},
            Text("Leave it out, or write it again with the program that made it.")};
}

Error fileTrouble() {
    return {ErrorCode::inputNotUsable,
            Text("This file could not be read to its end."),
            {},
            Text("Check the disk, and whether somebody else changes the file.")};
}

}  // namespace

Sending::Sending(const Connector& connector, std::span<const std::filesystem::path> files, Progress& progress)
    : connector_(connector), files_(files), progress_(progress) {}

void Sending::note(const Outgoing& outgoing, const Error& error, bool isRefused) {
    sent_.notSent.push_back({outgoing.file, error.message, error.hint, isRefused});
    progress_.advance();
}

void Sending::readAll() {
    for (const std::filesystem::path& file : files_) {
        const Result<FileMeta> meta = readFileMeta(file);
        if (!meta) {
            note({file, {}}, meta.error());
            continue;
        }
        std::error_code ignored;
        const bool isOdd = (std::filesystem::file_size(file, ignored) - meta->datasetOffset) % 2 != 0;
        if (!meta->isWhole())
            note({file, *meta}, namelessFile());
        else if (isOdd && meta->transferSyntaxUid != kDeflated)
            note({file, *meta}, cutOffFile());
        else
            left_.push_back({file, *meta});
    }
}

std::vector<Sending::Outgoing> Sending::nextBatch() {
    std::set<Kind> kinds;
    std::vector<Outgoing> batch;
    std::vector<Outgoing> rest;
    for (Outgoing& each : left_) {
        const bool fits = kinds.contains(each.kind()) || kinds.size() < kMostContexts;
        if (fits) kinds.insert(each.kind());
        (fits ? batch : rest).push_back(std::move(each));
    }
    left_ = std::move(rest);
    return batch;
}

Result<Sent> Sending::run() {
    progress_.beginStage(Text("Sending to the archive"), std::max<std::size_t>(files_.size(), 1));
    readAll();
    while (!left_.empty()) {
        std::vector<Outgoing> batch = nextBatch();
        MACULA_TRY_VOID(sendWithTries(batch));
    }
    return sent_;
}

// A connection that breaks is made again. A file with which it breaks each time is left out; after some such
// files, all are.
Result<void> Sending::sendWithTries(std::vector<Outgoing>& batch) {
    int failures = 0;
    int filesGivenUp = 0;
    while (!batch.empty()) {
        const std::size_t before = batch.size();
        isConnected_ = false;
        const Result<void> attempted = sendBatch(batch);
        if (progress_.cancelled()) return cancelledSending(sent_.stored, files_.size());
        if (attempted) continue;
        const Error& error = attempted.error();
        if (error.code != ErrorCode::archiveNotUsable) return error;
        if (!isConnected_ && sent_.stored == 0) return error;
        if (batch.size() < before) failures = filesGivenUp = 0;
        if (++failures <= kTriesToSend) continue;
        failures = 0;
        const bool givesUp = !isConnected_ || ++filesGivenUp == kTriesToSend;
        const std::size_t count = givesUp ? batch.size() : 1;
        for (std::size_t i = 0; i < count; ++i) note(batch[i], error, false);
        batch.erase(batch.begin(), batch.begin() + static_cast<std::ptrdiff_t>(count));
    }
    return {};
}

Result<void> Sending::sendBatch(std::vector<Outgoing>& batch) {
    std::set<Kind> kinds;
    for (const Outgoing& each : batch) kinds.insert(each.kind());
    std::vector<ProposedContext> contexts;
    for (const Kind& kind : kinds) contexts.push_back({kind.first, {kind.second}, false});
    MACULA_TRY(const std::unique_ptr<Association> association, connector_.open(contexts, progress_.token()));
    isConnected_ = true;
    while (!batch.empty()) {
        if (progress_.cancelled()) break;
        const Outgoing& outgoing = batch.front();
        const AcceptedContext* context =
            association->contextFor(outgoing.meta.sopClassUid, outgoing.meta.transferSyntaxUid);
        if (context == nullptr) {
            const bool knowsClass = association->contextFor(outgoing.meta.sopClassUid) != nullptr ||
                                    association->refusesTransferSyntax(outgoing.meta.sopClassUid);
            note(outgoing, knowsClass ? otherTransferSyntax() : serviceNotOffered(Service::store));
        } else {
            Result<void> sent = sendFile(*association, *context, outgoing);
            if (!sent && sent.error().code == ErrorCode::inputNotUsable) {
                // The archive waits for the rest of the file: only a new association helps the others.
                note(outgoing, sent.error());
                batch.erase(batch.begin());
                association->abort();
                return {};
            }
            if (!sent) return sent;
        }
        batch.erase(batch.begin());
    }
    association->release();
    return {};
}

Result<void> Sending::sendFile(Association& association, const AcceptedContext& context,
                               const Outgoing& outgoing) {
    const std::uint16_t messageId = association.newMessageId();
    MACULA_TRY_VOID(sendCommand(association, context.id,
                                {.field = CommandField::storeRequest,
                                 .messageId = messageId,
                                 .sopClassUid = outgoing.meta.sopClassUid,
                                 .sopInstanceUid = outgoing.meta.sopInstanceUid,
                                 .priority = std::uint16_t{0},
                                 .hasDataset = true}));
    MACULA_TRY_VOID(sendBytes(association, context, outgoing));
    MACULA_TRY(const ReceivedCommand received, receiveCommand(association));
    const Command& response = received.command;
    if (response.field != CommandField::storeResponse || response.respondsTo != messageId ||
        !response.status || response.hasDataset)
        return notWhatDicomSays();
    if (*response.status != 0 && !isWarning(*response.status)) {
        note(outgoing, errorOfStatus(Service::store, *response.status));
        return {};
    }
    ++sent_.stored;
    progress_.advance();
    return {};
}

Result<void> Sending::sendBytes(Association& association, const AcceptedContext& context,
                                const Outgoing& outgoing) {
    std::error_code problem;
    const std::uintmax_t size = std::filesystem::file_size(outgoing.file, problem);
    std::ifstream stream(outgoing.file, std::ios::binary);
    stream.seekg(static_cast<std::streamoff>(outgoing.meta.datasetOffset));
    if (problem || !stream || size < outgoing.meta.datasetOffset) return fileTrouble();
    std::uintmax_t left = size - outgoing.meta.datasetOffset;
    const bool isOdd = left % 2 != 0;
    std::vector<unsigned char> part;
    do {
        if (progress_.cancelled()) return cancelledError();
        part.resize(std::min<std::uintmax_t>(left, kBytesOfPart));
        stream.read(reinterpret_cast<char*>(part.data()), static_cast<std::streamsize>(part.size()));
        if (!stream) return fileTrouble();
        left -= part.size();
        // Fragments are even. A deflated dataset of an odd length gets a zero (PS3.5 A.5).
        if (left == 0 && isOdd) part.push_back(0);
        MACULA_TRY_VOID(sendDataset(association, context.id, part, left == 0));
    } while (left > 0);
    return {};
}

}  // namespace macula::net

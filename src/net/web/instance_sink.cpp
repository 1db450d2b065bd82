#include "net/web/instance_sink.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "net/archive/file_meta.h"

namespace macula::net {

namespace {

Error strangeAnswer() {
    return {
        ErrorCode::archiveNotUsable,
        Text("The archive sent something else than the images that it was asked for."),
        {},
        Text("Ask the administrator of the archive whether WADO-RS is on, or use DIMSE with this archive.")};
}

Error diskError(int reason) {
    const bool isFull = reason == ENOSPC || reason == EDQUOT;
    return {ErrorCode::outputNotWritable,
            isFull ? Text("There is no space left for images from the archive.")
                   : Text("The images from the archive cannot be written."),
            {},
            isFull ? Text("Free space on the disk, or keep images elsewhere.")
                   : Text("Check the folder in which images are kept, and its permissions.")};
}

bool isDicomPart(const std::string& contentType) {
    const std::string type = mediaTypeOf(contentType);
    return type.empty() || type == "application/dicom" || type == "application/octet-stream";
}

}  // namespace

InstanceSink::InstanceSink(FetchTally& tally, InstanceKey promised, std::size_t mostInstances)
    : tally_(tally), promised_(std::move(promised)), mostInstances_(mostInstances) {}

InstanceSink::~InstanceSink() {
    dropFile();
}

Error InstanceSink::receivers(Error error) {
    isReceiversError_ = true;
    return error;
}

Result<void> InstanceSink::begin(const HttpHead& head) {
    hasBegun_ = true;
    if (const auto boundary = boundaryOf(head.contentType)) {
        PartSink& parts = *this;
        parser_.emplace(*boundary, parts);
        return {};
    }
    // One instance may come by itself.
    if (mediaTypeOf(head.contentType) != "application/dicom") return strangeAnswer();
    return beginPart({});
}

Result<void> InstanceSink::write(std::span<const std::byte> bytes) {
    const std::span<const char> text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return parser_ ? parser_->feed(text) : partBytes(text);
}

Result<bool> InstanceSink::finish() {
    if (!hasBegun_) return true;
    if (parser_) return parser_->isComplete();
    MACULA_TRY_VOID(endPart());
    return true;
}

Result<void> InstanceSink::beginPart(const PartHeaders& headers) {
    isSkipped_ = !isDicomPart(headers.contentType);
    if (isSkipped_) return {};
    if (instances_ >= mostInstances_) return strangeAnswer();
    return openFile();
}

Result<void> InstanceSink::openFile() {
    auto place = tally_.receiver.place();
    if (!place) return receivers(place.error());
    file_ = *std::move(place);
    bytes_ = 0;
    isTooLarge_ = false;
    descriptor_ = open(file_.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW);
    if (descriptor_ >= 0) return {};
    const int reason = errno;
    dropFile();
    return receivers(diskError(reason));
}

Result<void> InstanceSink::partBytes(std::span<const char> bytes) {
    if (isSkipped_ || isTooLarge_) return {};
    bytes_ += bytes.size();
    tally_.fetched.bytes += bytes.size();
    if (bytes_ <= tally_.receiver.mostBytesOfInstance()) return writeFile(bytes);
    isTooLarge_ = true;
    ++tally_.fetched.refused;
    if (const auto meta = readFileMeta(file_); meta.ok() && !meta->sopInstanceUid.empty())
        tally_.came.insert(meta->sopInstanceUid);
    dropFile();
    // An endless one would never stop.
    return strangeAnswer();
}

Result<void> InstanceSink::writeFile(std::span<const char> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) {
            const int reason = errno;
            dropFile();
            return receivers(diskError(reason));
        }
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return {};
}

Result<void> InstanceSink::endPart() {
    if (isSkipped_ || file_.empty()) return {};
    if (close(std::exchange(descriptor_, -1)) != 0) {
        const int reason = errno;
        dropFile();
        return receivers(diskError(reason));
    }
    ++instances_;
    const auto meta = readFileMeta(file_);
    auto verdict = tally_.receiver.take(std::exchange(file_, {}), promised_);
    if (!verdict) return receivers(verdict.error());
    // Images that were asked for first come again with their series.
    const bool isKnown = meta.ok() && !meta->sopInstanceUid.empty();
    const bool comesAgain = isKnown && !tally_.came.insert(meta->sopInstanceUid).second;
    switch (*verdict) {
        case Receiver::Verdict::kept:
            ++tally_.fetched.kept;
            break;
        case Receiver::Verdict::hadAlready:
            if (comesAgain) return {};
            if (!isKnown || tally_.had.insert(meta->sopInstanceUid).second) ++tally_.fetched.hadAlready;
            break;
        case Receiver::Verdict::refused:
            ++tally_.fetched.refused;
            break;
    }
    tally_.progress.advance();
    return {};
}

void InstanceSink::dropFile() noexcept {
    if (descriptor_ >= 0) close(std::exchange(descriptor_, -1));
    if (file_.empty()) return;
    tally_.receiver.drop(file_);
    file_.clear();
}

}  // namespace macula::net

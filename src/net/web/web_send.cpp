#include "net/web/web_send.h"

#include <algorithm>

#include "net/archive/file_meta.h"
#include "net/web/gathered_body.h"
#include "net/web/stow_answer.h"

namespace macula::net {

namespace {

constexpr std::uint64_t kMostBytesOfGroup = std::uint64_t{64} << 20;
constexpr std::size_t kMostFilesOfGroup = 100;
constexpr std::uintmax_t kMostBytesOfStowAnswer = std::uintmax_t{16} << 20;
constexpr int kAccepted = 202;  // some were not stored
constexpr int kConflict = 409;  // none was

}  // namespace

WebSend::WebSend(const std::string& service, HttpClient& client, Progress& progress)
    : service_(service), client_(client), progress_(progress) {}

Result<Sent> WebSend::run(std::span<const std::filesystem::path> files) {
    progress_.beginStage(Text("Sending {} images to the archive", files.size()),
                         std::max<std::size_t>(files.size(), 1));
    for (const std::filesystem::path& file : files) lookAt(file);
    const std::span<const ToSend> all(toSend_);
    for (std::size_t from = 0; from < all.size();) {
        std::size_t to = from;
        for (std::uint64_t bytes = 0; to < all.size() && to - from < kMostFilesOfGroup; ++to) {
            bytes += all[to].upload.bytes;
            if (to > from && bytes > kMostBytesOfGroup) break;
        }
        if (auto sent = sendGroup(all.subspan(from, to - from)); !sent) {
            const Error& error = sent.error();
            // What is stored must be told.
            if (error.code == ErrorCode::cancelled)
                return Error{
                    ErrorCode::cancelled,
                    Text("{} of {} files were stored before this was cancelled.", sent_.stored, files.size()),
                    {},
                    {}};
            if (sent_.stored == 0) return error;
            note(all.subspan(judged_), error, false);
            break;
        }
        progress_.advance(to - from);
        from = to;
    }
    return std::move(sent_);
}

void WebSend::lookAt(const std::filesystem::path& file) {
    auto meta = readFileMeta(file);
    std::error_code failed;
    const std::uintmax_t bytes = std::filesystem::file_size(file, failed);
    if (meta.ok() && !failed && !meta->sopInstanceUid.empty()) {
        toSend_.push_back({{file, bytes}, std::move(meta->sopInstanceUid)});
        return;
    }
    progress_.advance();
    if (!meta.ok()) {
        sent_.notSent.push_back({file, meta.error().message, meta.error().hint});
    } else {
        sent_.notSent.push_back({file, Text("The file does not name the object that it holds."),
                                 Text("Ask whoever made the file: it has no valid SOP Instance UID.")});
    }
}

// Fails where no other group would fare better.
Result<void> WebSend::sendGroup(std::span<const ToSend> group) {
    std::vector<UploadBody::Upload> uploads;
    for (const ToSend& one : group) uploads.push_back(one.upload);
    UploadBody body(uploads);
    GatheredBody answer;
    HttpRequest request{.url = service_ + "/studies",
                        .accept = "application/dicom+json",
                        .contentType = body.contentType(),
                        .body = &body,
                        .sink = &answer,
                        .mostBytes = kMostBytesOfStowAnswer,
                        .otherSuccess = kConflict};
    HttpOutcome outcome = client_.run(request, progress_);
    if (outcome.trouble == HttpTrouble::closed) {
        // A connection that was used before may have ended unseen. Storing twice does no harm.
        MACULA_TRY_VOID(body.rewind());
        outcome = client_.run(request, progress_);
    }
    if (outcome.ok()) {
        judge(group, outcome.status, answer.text());
        return {};
    }
    if (outcome.ended && outcome.ended->code != ErrorCode::inputNotUsable) return *outcome.ended;
    const bool isOfThisGroup = outcome.ended || outcome.trouble == HttpTrouble::requestTooLarge ||
                               outcome.trouble == HttpTrouble::badRequest ||
                               outcome.trouble == HttpTrouble::mediaTypeRefused ||
                               outcome.trouble == HttpTrouble::serverFailed;
    if (!isOfThisGroup) return outcome.error();
    if (group.size() == 1) {
        note(group, outcome.error(), true);
        return {};
    }
    // One of them may be at fault, or all together be too large.
    const std::size_t half = group.size() / 2;
    MACULA_TRY_VOID(sendGroup(group.first(half)));
    return sendGroup(group.subspan(half));
}

void WebSend::judge(std::span<const ToSend> group, int status, const std::string& answer) {
    const auto said = stowAnswerIn(answer);
    // Archives that answer with something else still say by the status whether all is well.
    const StowAnswer stow = said.ok() ? *said : StowAnswer{};
    judged_ += group.size();
    const bool isAllWell = status != kAccepted && status != kConflict && stow.stored.empty();
    for (const ToSend& one : group) {
        const auto refused = stow.refused.find(one.sopInstanceUid);
        if (refused != stow.refused.end()) {
            const StowReason reason = stowReason(refused->second);
            sent_.notSent.push_back({one.upload.file, reason.why, reason.advice});
        } else if (isAllWell || stow.stored.contains(one.sopInstanceUid)) {
            ++sent_.stored;
        } else {
            const StowReason reason = stowReason(0);
            sent_.notSent.push_back({one.upload.file, reason.why, reason.advice});
        }
    }
}

void WebSend::note(std::span<const ToSend> group, const Error& error, bool isRefused) {
    judged_ += group.size();
    for (const ToSend& one : group)
        sent_.notSent.push_back({one.upload.file, error.message, error.hint, isRefused});
}

}  // namespace macula::net

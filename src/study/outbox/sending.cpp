#include "study/outbox/sending.h"

#include <utility>

namespace macula::study {

namespace fs = std::filesystem;

FilesSent sendFiles(net::Archive& archive, std::span<const fs::path> files, Progress& progress) {
    FilesSent outcome;
    auto sent = archive.send(files, progress);
    if (!sent) {
        outcome.left.assign(files.begin(), files.end());
        outcome.trouble = sent.error();
        return outcome;
    }
    outcome.stored = sent->stored;
    for (net::NotSent& each : sent->notSent) {
        if (each.isRefused) {
            outcome.refused.push_back(std::move(each));
            continue;
        }
        if (!outcome.trouble) outcome.trouble = Error{ErrorCode::archiveNotUsable, each.why, {}, each.advice};
        outcome.left.push_back(std::move(each.file));
    }
    return outcome;
}

net::Sent inOneList(const FilesSent& sent) {
    net::Sent all{.stored = sent.stored, .notSent = sent.refused};
    for (const fs::path& file : sent.left)
        all.notSent.push_back({file, sent.trouble->message, sent.trouble->hint, false});
    return all;
}

Reason reasonOf(const Error& error) {
    return {error.message, error.hint};
}

}  // namespace macula::study

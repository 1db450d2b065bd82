#include "study/outbox/sending.h"

#include <utility>

namespace macula::study {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> filesOf(std::span<const net::NotSent> notSent) {
    std::vector<fs::path> files;
    for (const net::NotSent& each : notSent) files.push_back(each.file);
    return files;
}

}  // namespace

FilesSent sendFiles(net::Archive& archive, std::span<const fs::path> files, Progress& progress) {
    FilesSent outcome;
    const auto leave = [&](std::vector<fs::path> left, const Error& trouble) {
        outcome.left = std::move(left);
        outcome.trouble = trouble;
    };
    for (std::vector<fs::path> toSend(files.begin(), files.end()); !toSend.empty();) {
        auto sent = archive.send(toSend, progress);
        if (!sent) {
            leave(std::move(toSend), sent.error());
            break;
        }
        outcome.stored += sent->stored;
        if (sent->notSent.empty()) break;
        // Files are sent in turn: where the connection was lost for good, this one came after that.
        const fs::path last = sent->notSent.back().file;
        const auto again = archive.send({&last, 1}, progress);
        if (!again) {
            leave(filesOf(sent->notSent), again.error());
            break;
        }
        if (again->stored == 0) {
            outcome.refused = std::move(sent->notSent);
            break;
        }
        ++outcome.stored;
        sent->notSent.pop_back();
        toSend = filesOf(sent->notSent);
    }
    return outcome;
}

Reason reasonOf(const Error& error) {
    return {error.message, error.hint};
}

}  // namespace macula::study

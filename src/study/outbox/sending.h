// Sends files, and tells those that the archive refused from those that it was never asked about.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "net/archive/archive.h"
#include "study/outbox/reason.h"

namespace macula::study {

struct FilesSent {
    std::size_t stored = 0;
    std::vector<net::NotSent> refused;        // sending them again as they are would end the same way
    std::vector<std::filesystem::path> left;  // may be stored already, where this was cancelled
    std::optional<Error> trouble;             // why files are left
};

// An archive that goes away in the middle refuses only what it refused before.
FilesSent sendFiles(net::Archive& archive, std::span<const std::filesystem::path> files, Progress& progress);

// All that is not stored, with the reasons.
net::Sent inOneList(const FilesSent& sent);

Reason reasonOf(const Error& error);

}  // namespace macula::study

// Fetches studies from an archive into the spool.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "base/progress.h"
#include "base/result.h"
#include "net/archive/archive.h"
#include "study/spool/spool.h"

namespace macula::study {

struct FetchRequest {
    std::string studyInstanceUid;
    std::vector<std::string> seriesInstanceUids = {};  // empty: all
    // Whose study a person chose from a list, if there was one.
    std::optional<Identity> chosen = {};
};

struct FetchedStudy {
    std::filesystem::path folder;
    net::Fetched counts;
    // Of a whole study: all that the archive has is there. Of some series: all that it has of these.
    bool isComplete = false;
    std::vector<Message> messages;  // what never came, may be missing, or was refused: shown with the study
};

// Told by the threads that receive, after each instance.
struct Arrival {
    std::filesystem::path folder;
    std::size_t instances = 0;  // of this study in the spool
};
using ArrivalListener = std::function<void(const Arrival&)>;

// Asks the archive whose study it is, makes room, fetches what is missing, and notes the result beside the
// files. What came stays also after an error or a cancellation: the next fetch goes on from there. Fails with
// archiveNotUsable where the archive has no such study, or names another patient than the one that was
// chosen.
Result<FetchedStudy> fetchStudy(net::Archive& archive, const std::string& source, const FetchRequest& request,
                                Spool& spool, Progress& progress, const ArrivalListener& arrived = {});

// Of the patient that the archive names.
Identity identityOf(const net::FoundStudy& study);

}  // namespace macula::study

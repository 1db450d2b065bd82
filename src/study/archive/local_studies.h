// Studies on this machine, named as archives name theirs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"
#include "net/archive/query.h"
#include "study/spool/spool.h"

namespace macula::study {

// Names a patient: for the screen only.
struct LocalStudy {
    net::FoundStudy study;
    std::filesystem::path folder;  // opens it; a file of it, where other studies lie in its folder too
    std::string archive;           // whence it was fetched; empty: it was not
    bool isWhole = true;           // as far as anybody said how many images it has
};

// Those in the spool, last used first. Reads the notes beside each study; where these do not name the
// patient, the header of one file.
std::vector<LocalStudy> studiesInSpool(const Spool& spool, const CancelToken& cancel = {});

// Those in a folder, from the headers of all its files; none where it cannot be read, or after a
// cancellation.
std::vector<LocalStudy> studiesInFolder(const std::filesystem::path& folder, const CancelToken& cancel = {});

}  // namespace macula::study

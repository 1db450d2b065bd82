// Finds in the archives that are set up what a link asks for.
#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "net/archive/query.h"
#include "net/sources/source_list.h"
#include "study/link/study_link.h"

namespace macula::study {

struct LinkedStudy {
    std::string archive;  // the name of the first that has it
    net::FoundStudy study;
};

struct LinkedStudies {
    std::vector<LinkedStudy> studies;  // newest first; not empty
    std::vector<Text> remarks;         // archives that could not be asked, answers that were left out
};

// The archive that the link names, or all. Fails with usage where there is none of that name, or none at all.
Result<std::vector<net::Source>> sourcesFor(const StudyLink& link, const net::SourceList& sources);

// Asks all archives at once. Where one does not answer and another has the study, a remark says so. An answer
// counts only if it is what was asked for, since archives read keys in their own ways. Fails with
// archiveNotUsable where nothing fits.
Result<LinkedStudies> findLinked(const StudyLink& link, const net::SourceList& sources, Progress& progress);

}  // namespace macula::study

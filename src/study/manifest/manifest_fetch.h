// Fetches what an imaging manifest names, and compares what came with it.
#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "dicom/manifest/imaging_manifest.h"
#include "net/sources/source_list.h"
#include "study/archive/fetched_study.h"
#include "study/spool/spool.h"

namespace macula::study {

// Whose images the manifest says that it names.
Identity identityOf(const dicom::ImagingManifest& manifest);

// Each of its studies whole, in the order of the manifest: from the archive of that name, or where it is
// empty from where the manifest says (sourceOf). Images that the manifest names and that did not come are
// told by a message, and noted beside the study; so are references that cannot be read. Fails as sourceOf,
// before anything is fetched, and as fetchStudy, also where the archive names another patient than the
// manifest.
Result<std::vector<FetchedStudy>> fetchManifest(const dicom::ImagingManifest& manifest,
                                                const net::SourceList& sources, const std::string& archive,
                                                Spool& spool, Progress& progress);

}  // namespace macula::study

// Which volumes of a folder were opened before, according to the study store.
#pragma once

#include <cstddef>
#include <set>

#include "base/result.h"
#include "session/store.h"
#include "study/open/found_volumes.h"

namespace macula::live {

// Returns indices into FoundVolumes::volumes(). A volume's digest is unknown until its voxels are read, so
// the volumes of a series count as seen only once as many were opened as the series has. Waits for the disk.
Result<std::set<std::size_t>> volumesSeenBefore(session::Store& store, const study::FoundVolumes& found);

}  // namespace macula::live

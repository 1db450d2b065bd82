// Which volumes of a folder somebody has opened before, as the store of sessions knows it.
#pragma once

#include <cstddef>
#include <set>

#include "base/result.h"
#include "session/store.h"
#include "study/open/found_volumes.h"

namespace macula::app {

// In FoundVolumes::volumes(). Nobody knows the digest of a volume before its voxels are read: of a series
// with several volumes all are named once as many of it were opened, and none before. Waits for the disk.
Result<std::set<std::size_t>> volumesSeenBefore(session::Store& store, const FoundVolumes& found);

}  // namespace macula::app

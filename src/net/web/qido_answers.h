// What an archive answers to a search (QIDO-RS, PS3.18 10.6), from its JSON.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "net/archive/query.h"

namespace macula::net {

// Of one answer, which may be a page of several. Each UID once; `unusable` are those without a valid one.
template <class Found>
struct QidoPage {
    std::vector<Found> found;
    std::size_t unusable = 0;
    std::size_t datasets = 0;  // all that the archive sent, usable or not
};

// Fail with archiveNotUsable where the text is not the JSON of DICOM. An empty text is an empty page.
Result<QidoPage<FoundStudy>> studiesInJson(std::string_view text);
Result<QidoPage<FoundSeries>> seriesInJson(std::string_view text);
Result<QidoPage<FoundInstance>> instancesInJson(std::string_view text);

}  // namespace macula::net

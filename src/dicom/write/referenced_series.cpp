#include "dicom/write/referenced_series.h"

#include <algorithm>

#include "dicom/messages/messages.h"
#include "dicom/write/uid.h"

namespace macula::dicom {

Result<void> checkReferable(const Series& series) {
    if (std::ranges::none_of(series.messages, [](const Message& m) { return m.key == key::kJoined; }))
        return {};
    return Error{ErrorCode::usage,
                 Text("Each image of this volume says that it is a series of its own, so an object for the "
                      "archive would refer to the wrong one."),
                 {},
                 Text("Save a view or a table instead, or ask for images with the right identifiers.")};
}

PresentedSeries withStandIns(PresentedSeries series, const InstallationKey& key) {
    series.seriesInstanceUid = standInUid(key, series.seriesInstanceUid);
    if (!series.frameOfReferenceUid.empty())
        series.frameOfReferenceUid = standInUid(key, series.frameOfReferenceUid);
    for (ReferencedImage& image : series.images) image.sopInstanceUid = standInUid(key, image.sopInstanceUid);
    return series;
}

}  // namespace macula::dicom

#include "dicom/write/referenced_series.h"

#include "dicom/write/uid.h"

namespace macula::dicom {

PresentedSeries withStandIns(PresentedSeries series, const InstallationKey& key) {
    series.seriesInstanceUid = standInUid(key, series.seriesInstanceUid);
    if (!series.frameOfReferenceUid.empty())
        series.frameOfReferenceUid = standInUid(key, series.frameOfReferenceUid);
    for (ReferencedImage& image : series.images) image.sopInstanceUid = standInUid(key, image.sopInstanceUid);
    return series;
}

}  // namespace macula::dicom

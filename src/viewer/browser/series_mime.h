// A series of images that a person drags from the list of studies: as text "list/study/series/stack", places
// in the scan of the list. Another list is of another folder, and perhaps of another patient.
#pragma once

#include <QByteArray>
#include <optional>

#include "study/planar/planar_images.h"

namespace macula::viewer {

inline constexpr char kSeriesMime[] = "application/x-macula-series";

QByteArray seriesText(const study::FoundVolumes& found, const dicom::Stack& stack);  // empty: not in there
// stack is null for a text that names nothing in `found`.
study::PlanarSeries seriesOfText(const QByteArray& text, const study::FoundVolumes& found);

}  // namespace macula::viewer

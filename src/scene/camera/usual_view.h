// The default view direction of a volume, chosen by the body part and the shape of the scan.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "base/frames.h"
#include "base/text.h"
#include "base/volume.h"

namespace macula::scene {

// Why usualView chose its direction.
enum class ViewReason {
    headByCode,   // Body Part Examined (0018,0015) names the head; 60 mm high or more
    headByShape,  // no body part is given, and the matter in the volume has the size of a head
    shortScan,    // less than half as high as it is wide or deep: a thin band from the front
    body,         // anything else
};

// The names in records: "head-by-code", "head-by-shape", "short-scan", "body".
std::string_view nameOf(ViewReason reason);

struct UsualView {
    ViewDirection from = ViewDirection::turned;
    ViewReason why = ViewReason::body;

    bool operator==(const UsualView&) const = default;
};

// Less than half as high as it is wide or deep.
bool isShort(const Volume& volume);

// Heads: three-quarter view; short scans: oblique; all others: from the front, slightly turned. Without a
// body part it reads a grid of voxels, at most 95 along each axis.
UsualView usualView(const Volume& volume);

// The direction `asked` for, otherwise that of usualView.
ViewDirection firstDirection(std::optional<ViewDirection> asked, const Volume& volume);

// A sentence for the user: the direction of the view, and why.
Text sentenceOf(const UsualView& view);

// Whether a code of Body Part Examined names a part of the head (PS3.16 Annex L), in upper or lower case;
// looks only at its letters.
bool isOfHead(std::string_view bodyPart);

// The extent of the matter in a volume along the patient's axes, in mm: from the 1st to the 99th percentile
// of the voxels above -300 HU, or of raw values above their mean. `cutAside` is the share of matter among the
// voxels at the four sides (not above and below): where it is high, the patient reaches beyond the volume.
// Nothing if values cannot tell matter from air (PET), or there is no matter.
struct MatterExtent {
    glm::dvec3 sizeMm{0.0};
    double cutAside = 0.0;
};
std::optional<MatterExtent> matterExtent(const Volume& volume);

}  // namespace macula::scene

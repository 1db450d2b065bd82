// From where a patient is looked at when nobody chose: by what was scanned, as far as that is known.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "base/frames.h"
#include "base/volume.h"

namespace macula::app {

// Why it is that one.
enum class ViewReason {
    headByCode,   // Body Part Examined (0018,0015) is a code of the head
    headByShape,  // no body part is said, and what lies in the volume is as large as a head
    shortScan,    // less than half as high as it is wide or deep: a thin band from the front
    body,         // anything else
};

// As in records: "head-by-code", "head-by-shape", "short-scan", "body".
std::string_view nameOf(ViewReason reason);

struct UsualView {
    ViewDirection from = ViewDirection::turned;
    ViewReason why = ViewReason::body;

    bool operator==(const UsualView&) const = default;
};

// Less than half as high as it is wide or deep.
bool isShort(const Volume& volume);

// Shows heads from the three-quarter view, short scans obliquely, all else from the front, slightly turned.
// Where the body part is not said, it looks at some 100 000 of the values.
UsualView usualView(const Volume& volume);

// The direction that was asked for, or else the usual one: what all who show a volume first ask.
ViewDirection firstDirection(std::optional<ViewDirection> asked, const Volume& volume);

// What there is to tell of a picture from there: from where, and why.
std::string sentenceOf(const UsualView& view);

// Whether a code of Body Part Examined is of the head, as PS3.16 L lists them; blanks and small letters as
// they may be.
bool isOfHead(std::string_view bodyPart);

// How far what lies in a volume reaches along the patient's axes, in mm: from the 1st to the 99th percentile
// of the voxels above -300 HU, or of raw values above their mean. `cutAside`: the share of the voxels at its
// four sides (not above and below) that are of it, so that more lies beside the volume. Nothing where values
// do not tell matter from air (PET), or none is.
struct MatterExtent {
    glm::dvec3 sizeMm{0.0};
    double cutAside = 0.0;
};
std::optional<MatterExtent> matterExtent(const Volume& volume);

}  // namespace macula::app

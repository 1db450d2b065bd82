// How a second volume is shown with the study: a prior, or another kind of picture.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/volume.h"
#include "pipeline/volume/transfer_function.h"
#include "slices/colour_table.h"

namespace macula::app {

// What takes a point of the study to the point of the second volume.
enum class BesideLink {
    byHand,      // middle on middle, or wherever somebody moved it: positions cannot be compared
    sameFrame,   // both name one frame of reference
    registered,  // registration::registerRigid
};
inline constexpr std::array kBesideLinks{BesideLink::byHand, BesideLink::sameFrame, BesideLink::registered};

enum class BesideView {
    hidden,   // the study alone
    beside,   // two columns: the study at the left
    instead,  // the second volume in the place of the study
    over,     // in colours over the study
};
inline constexpr std::array kBesideViews{BesideView::hidden, BesideView::beside, BesideView::instead,
                                         BesideView::over};

// As in files.
constexpr std::string_view nameOf(BesideLink link) {
    switch (link) {
        case BesideLink::byHand:
            return "byHand";
        case BesideLink::sameFrame:
            return "sameFrame";
        case BesideLink::registered:
            return "registered";
    }
    return {};
}
constexpr std::string_view nameOf(BesideView view) {
    switch (view) {
        case BesideView::hidden:
            return "hidden";
        case BesideView::beside:
            return "beside";
        case BesideView::instead:
            return "instead";
        case BesideView::over:
            return "over";
    }
    return {};
}

inline constexpr double kUsualOpacity = 0.6;

struct BesideState {
    std::string seriesDigest = {};  // of the second volume: see StudyInput::seriesDigest
    // Which of the volumes of the series, from 0; nothing: its only one. Views of before this was kept name
    // none. Counts only where there is no key: another file in the folder may move it.
    std::optional<std::size_t> volume = {};
    std::string volumeKey = {};  // FoundVolumes::key; empty in views of before, and where there is no series
    // Of the voxels and the geometry of both volumes (pairDigest): the place below is of these, and of no
    // others under the same UIDs. Empty in views of before, whose place is no longer taken for true.
    std::string pair = {};
    BesideLink link = BesideLink::byHand;
    glm::dmat4 secondFromStudy{1.0};  // mm LPS; rigid
    double boundMm = 0.0;             // of a registration: RigidRegistration::boundMm
    bool isDoubtful = false;          // the same: RigidRegistration::isDoubtful
    double rivalMm = 0.0;             // the same, where it has a rival: RigidRegistration::rivalMm; else 0
    BesideView view = BesideView::beside;
    std::optional<DisplayWindow> window = {};  // nothing: that of the series (seriesWindow)
    bool linksWindow = false;                  // on slices the study's, whatever `window` is
    double opacity = kUsualOpacity;            // over the study, 0 to 1
    slices::ColourTable colours = slices::ColourTable::hotIron;
    bool in3d = false;  // and in the 3D picture, in one with the study
    // That it has there; nothing: window, colours and opacity from above (secondCurve).
    std::shared_ptr<const TransferFunction> preset = {};

    // Whether a point of the study is a point of the second volume.
    bool isLinked() const { return link != BesideLink::byHand; }
    bool operator==(const BesideState& b) const;  // by value, the preset too
};

}  // namespace macula::app

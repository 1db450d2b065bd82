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
#include "scene/second/isodoses.h"
#include "slices/colour_table.h"

namespace macula::scene {

// How points of the study are mapped to the second volume.
enum class SecondVolumeLink {
    byHand,      // middle on middle, or moved by hand: positions are not comparable
    sameFrame,   // both name one frame of reference
    registered,  // registration::registerRigid
};
inline constexpr std::array kSecondVolumeLinks{SecondVolumeLink::byHand, SecondVolumeLink::sameFrame,
                                               SecondVolumeLink::registered};

enum class SecondVolumePlace {
    hidden,   // the study alone
    beside,   // two columns: the study on the left
    instead,  // the second volume in the place of the study
    over,     // in colours over the study
};
inline constexpr std::array kSecondVolumePlaces{SecondVolumePlace::hidden, SecondVolumePlace::beside,
                                                SecondVolumePlace::instead, SecondVolumePlace::over};

// The names in files.
constexpr std::string_view nameOf(SecondVolumeLink link) {
    switch (link) {
        case SecondVolumeLink::byHand:
            return "byHand";
        case SecondVolumeLink::sameFrame:
            return "sameFrame";
        case SecondVolumeLink::registered:
            return "registered";
    }
    return {};
}
constexpr std::string_view nameOf(SecondVolumePlace view) {
    switch (view) {
        case SecondVolumePlace::hidden:
            return "hidden";
        case SecondVolumePlace::beside:
            return "beside";
        case SecondVolumePlace::instead:
            return "instead";
        case SecondVolumePlace::over:
            return "over";
    }
    return {};
}

inline constexpr double kUsualOpacity = 0.6;

struct SecondVolumeState {
    std::string seriesDigest = {};  // of the second volume: see LoadedStudy::seriesDigest
    // Index among the volumes of the series; none: the only one. Views of older versions have none. Used only
    // without volumeKey, because another file in the folder may shift it.
    std::optional<std::size_t> volume = {};
    std::string volumeKey = {};  // FoundVolumes::key; empty in older views, and without a series
    // pairDigest of the voxels and geometry of both volumes. secondFromStudy holds for these alone, not for
    // others with the same UIDs. Empty in older views, whose secondFromStudy is not trusted.
    std::string pair = {};
    SecondVolumeLink link = SecondVolumeLink::byHand;
    glm::dmat4 secondFromStudy{1.0};  // mm LPS; rigid
    double boundMm = 0.0;             // of a registration: RigidRegistration::boundMm
    bool isDoubtful = false;          // RigidRegistration::isDoubtful
    double rivalMm = 0.0;             // RigidRegistration::rivalMm if it has a rival, otherwise 0
    SecondVolumePlace view = SecondVolumePlace::beside;
    std::optional<DisplayWindow> window = {};  // nothing: that of the series (seriesWindow)
    bool linksWindow = false;                  // slices use the study's window instead of `window`
    double opacity = kUsualOpacity;            // over the study, 0 to 1
    slices::ColourTable colours = slices::ColourTable::hotIron;
    bool in3d = false;  // also drawn in the study's 3D picture
    // For 3D; null: secondCurve of `window`, `colours` and `opacity`.
    std::shared_ptr<const TransferFunction> preset = {};
    std::optional<Isodoses> isodoses = {};  // of a dose, over the study; nothing: no lines

    // Whether positions in both volumes are comparable.
    bool isLinked() const { return link != SecondVolumeLink::byHand; }
    bool operator==(const SecondVolumeState& b) const;  // by value, the preset too
};

}  // namespace macula::scene

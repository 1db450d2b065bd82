// The study, second volume, slice and display window that a pane of slices is to show.
#pragma once

#include <QString>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "slices/slice_plane.h"
#include "viewer/editor/study_editor.h"
#include "viewer/overlay/slice_steps.h"
#include "viewer/slices/second_volume_texts.h"

namespace macula::viewer {

// Zoom and position of a pane in its plane.
struct PaneView {
    glm::dvec3 centreMm{0.0};  // in the middle of the pane; may be off the plane along the normal
    double mmPerPx = 1.0;      // logical pixels, as below

    bool operator==(const PaneView&) const = default;
};

// Fits the slice through the middle of the volume, so that all slices keep one scale.
PaneView fittedView(const Volume& volume, const SliceSteps& steps, const glm::ivec2& sizePx);

// Where a volume lies in the space of a pane: paneFromVoxel is an affine transform of voxel indices.
struct PlacedGrid {
    glm::dmat4 paneFromVoxel{1.0};
    glm::ivec3 size{1};
};

// Moves the view in its plane until the middle of the pane lies in the nearest volume that the plane meets.
// So a drag cannot move the picture out of its pane.
PaneView withinReach(const PaneView& view, const slices::SlicePlane& plane,
                     std::span<const PlacedGrid> volumes);

// Moves the picture by `byPx` logical pixels.
PaneView panned(const PaneView& view, const slices::SlicePlane& plane, const glm::dvec2& byPx);

// Magnifies by `factor`. The point `fromMiddlePx` off the middle of the pane stays fixed. Limits the
// magnification to 1/4 to 64 times that of `fittedMmPerPx`.
PaneView zoomed(const PaneView& view, const slices::SlicePlane& plane, const glm::dvec2& fromMiddlePx,
                double factor, double fittedMmPerPx);

// The frame of that slice on a screen with `pixelRatio` device pixels to a logical one.
slices::SliceFrame frameOf(const PaneView& view, const SliceSteps& steps, int slice, const glm::ivec2& sizePx,
                           double pixelRatio);

// Whether a pane shows the second volume when it is beside the study.
enum class PaneRole { study, second };

// Reads the session's state, and knows nothing of the picture on screen. The session outlives it. Only
// hasStudy(), the second volume, orientation() and role() can be read without a study.
class PaneContent {
  public:
    PaneContent(const StudyEditor& session, slices::Orientation orientation, PaneRole role);

    slices::Orientation orientation() const { return orientation_; }
    PaneRole role() const { return role_; }

    void clear();       // no study until takeStudy()
    void takeStudy();   // takes over the session's study
    void turnPlanes();  // straight, as acquired, or by hand, as the state says
    bool hasStudy() const { return steps_.has_value(); }
    // Another phase of the study, on its grid, that is shown in its place, and a text that says which; null:
    // the study. `ofDifference`: the volume is a difference of two phases, which has this window.
    void setPhase(std::shared_ptr<const study::OpenedStudy> phase, const QString& text,
                  std::optional<DisplayWindow> ofDifference = std::nullopt);
    bool showsOtherPhase() const { return phase_ != nullptr; }
    bool showsDifference() const { return phase_ && ofDifference_; }
    const QString& phaseText() const { return phaseText_; }
    const study::OpenedStudy& study() const { return phase_ ? *phase_ : session_.study(); }
    const scene::StudyState& state() const { return session_.state(); }
    const Volume& volume() const { return *study().measured(); }
    const SliceSteps& steps() const { return *steps_; }

    // Whether turnPlanes() would change the steps, if the state was that before.
    bool wantsTurn(const scene::SliceState& before) const;
    // The normal of another pane's plane, in the directions of steps().
    glm::dvec3 normalOf(slices::Orientation orientation) const;

    // The middle of the volume until a person chooses another point.
    glm::dvec3 crosshairMm() const;
    int slice() const { return steps_->nearest(crosshairMm()); }
    // The cross-hair moved along the normal to that slice, or to the first or last one.
    glm::dvec3 crosshairOn(int slice) const;
    DisplayWindow studyWindow() const;

    // Null: no second volume.
    void setSecond(std::shared_ptr<const SecondVolumeTexts> second);
    const SecondVolumeTexts* second() const { return second_.get(); }
    // Null unless the state describes this second volume. secondWindow() needs it.
    const scene::SecondVolumeState* secondState() const;
    DisplayWindow secondWindow() const;
    // Whether the pane shows the second volume instead of the study; false without one.
    bool wantsSecond() const;

    const Volume& wantedVolume() const;  // study or second volume, as wantsSecond() says
    DisplayWindow wantedWindow() const;
    std::vector<PlacedGrid> placedVolumes() const;  // both, in the space of the pane

  private:
    DisplayWindow valueWindow() const;

    const StudyEditor& session_;
    slices::Orientation orientation_;
    PaneRole role_;
    DisplayWindow usualWindow_;  // the study's seriesWindow
    std::optional<SliceSteps> steps_;
    std::shared_ptr<const study::OpenedStudy> phase_;
    QString phaseText_;
    std::optional<DisplayWindow> ofDifference_;
    std::shared_ptr<const SecondVolumeTexts> second_;
};

}  // namespace macula::viewer

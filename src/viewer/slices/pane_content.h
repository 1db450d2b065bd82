// The study, second volume, slice and display window that a pane of slices is to show.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "slices/slice_plane.h"
#include "viewer/editor/study_editor.h"
#include "viewer/overlay/slice_steps.h"
#include "viewer/slices/pane_view.h"
#include "viewer/slices/second_volume_texts.h"

namespace macula::viewer {

// Whether a pane shows the second volume when it is beside the study.
enum class PaneRole { study, second };

// Reads the session's state, and knows nothing of the picture on screen. The session outlives it. Only
// hasStudy(), the second volume, orientation() and role() can be read without a study.
class PaneContent {
  public:
    PaneContent(const StudyEditor& session, slices::Orientation orientation, PaneRole role);

    slices::Orientation orientation() const { return orientation_; }
    PaneRole role() const { return role_; }

    void clear() { steps_.reset(); }  // no study until takeStudy()
    void takeStudy();                 // takes over the session's study
    void turnPlanes();                // straight or as acquired, as the state says
    bool hasStudy() const { return steps_.has_value(); }
    const study::OpenedStudy& study() const { return session_.study(); }
    const scene::StudyState& state() const { return session_.state(); }
    const Volume& volume() const { return *study().measured(); }
    const SliceSteps& steps() const { return *steps_; }

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
    const StudyEditor& session_;
    slices::Orientation orientation_;
    PaneRole role_;
    DisplayWindow usualWindow_;  // the study's seriesWindow
    std::optional<SliceSteps> steps_;
    std::shared_ptr<const SecondVolumeTexts> second_;
};

}  // namespace macula::viewer

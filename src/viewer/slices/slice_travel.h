// Moves a pane of slices through the volume: slice by slice, in a cine, or with the cross-hair to a point.
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <glm/glm.hpp>

#include "viewer/editor/study_editor.h"
#include "viewer/slices/pane_content.h"
#include "viewer/slices/pane_zoom.h"
#include "viewer/slices/slice_sampler.h"

namespace macula::viewer {

// Steps through the slices back and forth. A run is one undo step.
class SliceCine : public QObject {
    Q_OBJECT

  public:
    // `isSeen`: whether the current slice is on screen. Cine waits for it, so a slow machine shows all
    // slices, more slowly.
    SliceCine(StudyEditor& session, const PaneContent& content, std::function<bool()> isSeen);

    bool isOn() const { return timer_.isActive(); }
    void start();  // needs a study
    void stop();

  Q_SIGNALS:
    void changed(bool on);

  private:
    void step();

    StudyEditor& session_;
    const PaneContent& content_;
    std::function<bool()> isSeen_;
    QTimer timer_;
    bool goesBack_ = false;
};

// Proposes changes of the session's cross-hair, or of the position of a second volume that is not linked.
// Steps in quick succession are one undo step.
class SliceTravel : public QObject {
    Q_OBJECT

  public:
    SliceTravel(StudyEditor& session, const PaneContent& content, const PaneZoom& zoom);  // all outlive this

    void moveBy(int slices);  // along the normal: for axial slices, towards the head
    void goToFirst() { goTo(0); }
    void goToLast() { goTo(content_.steps().count() - 1); }
    // By the wheel: eighths of a degree, as QWheelEvent has them; `fast`: several slices for a notch.
    void turnWheel(int eighths, bool fast);
    // Moves the cross-hair to a point, in a drag on a picture that shows `shows`.
    void pointAt(const glm::dvec3& mm, SliceShows shows);

    static constexpr int kNotch = 120;     // eighths of a degree
    static constexpr int kManySlices = 5;  // steps with Shift, or with the page keys

  private:
    void goTo(int slice);
    void moveSecond(int slices);
    void endOwnDrag(const QString& what);

    StudyEditor& session_;
    const PaneContent& content_;
    const PaneZoom& zoom_;
    int wheelRest_ = 0;  // eighths of a degree, less than a notch
    QTimer stepsEnd_;    // steps until then are one undo step
};

}  // namespace macula::viewer

// The measurements on a pane of slices: the visible ones, the selected one, and the one being drawn.
#pragma once

#include <QCoreApplication>
#include <QPointF>
#include <QString>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "slices/measurement.h"
#include "viewer/editor/study_editor.h"
#include "viewer/keys/slice_tool.h"
#include "viewer/overlay/measurement_handles.h"
#include "viewer/overlay/slice_overlay.h"
#include "viewer/slices/pane_content.h"
#include "viewer/slices/slice_sampler.h"

namespace macula::viewer {

// A measurement that a person is drawing. A distance has two points, its ends; an ellipse two opposite
// corners of its box; an angle three points. A press of the button sets a point; a release after a drag also
// sets the second. All points lie in `plane`, patient LPS mm.
class MeasurementDrawing {
  public:
    // `tool` must measure. Points within `leastMm` of each other count as one.
    MeasurementDrawing(SliceTool tool, const slices::SlicePlane& plane, const glm::dvec3& firstMm,
                       double leastMm);

    void press(const glm::dvec3& mm);
    void move(const glm::dvec3& mm) { pointerMm_ = mm; }
    void release(const glm::dvec3& mm);

    const slices::SlicePlane& plane() const { return plane_; }
    std::size_t pointsSet() const { return pointsMm_.size(); }
    bool isComplete() const { return pointsMm_.size() == pointsNeeded(); }
    // The measurement with the pointer as its next point; an angle with one point gives its first leg as a
    // distance. Nothing while it has no extent.
    std::optional<slices::Measurement> soFar() const;

  private:
    std::size_t pointsNeeded() const { return tool_ == SliceTool::angle ? 3 : 2; }
    bool isNew(const glm::dvec3& mm) const { return glm::distance(pointsMm_.back(), mm) > leastMm_; }
    std::optional<slices::Measurement> ellipse(const glm::dvec3& to) const;

    SliceTool tool_;
    slices::SlicePlane plane_;
    double leastMm_;
    std::vector<glm::dvec3> pointsMm_;
    glm::dvec3 pointerMm_;
};

// Caches the texts beside measurements: measuring an ellipse takes milliseconds, and a pane is painted often.
class MeasurementTexts {
  public:
    // Remembers the text of each measurement on each volume, as long as that lives.
    QString of(const slices::Measurement& measurement, const std::shared_ptr<const Volume>& volume);
    void forget() { known_.clear(); }

  private:
    struct Known {
        slices::Measurement measurement;
        std::weak_ptr<const Volume> volume;
        QString text;
    };
    std::vector<Known> known_;  // the latest is last
};

// Proposes changes of the session's measurements. `shown` is the request of the picture on screen; indices
// are into the state's measurements. Knows no widget: places are logical pixels of the pane.
class PaneMeasurements {
    Q_DECLARE_TR_FUNCTIONS(PaneMeasurements)

  public:
    PaneMeasurements(StudyEditor& session, const PaneContent& content);  // both outlive this

    void forget();  // drops selection and texts, for another study
    // Keeps the same measurement selected after a change of the state. Returns whether it is gone.
    bool follow(const scene::StudyState& before);

    std::optional<std::size_t> selected() const { return selected_; }
    void deselect() { selected_.reset(); }
    // Selects the measurement that is visible at `place`; if there is none, keeps the selection.
    std::optional<Hit> selectAt(const QPointF& place, const SliceRequest& shown);
    void moveHandle(std::size_t handle, const glm::dvec3& mm);  // of the selected measurement, in a drag
    void removeSelected();

    bool isDrawing() const { return drawing_.has_value(); }
    bool isBeyondFirstPoint() const { return drawing_ && drawing_->pointsSet() > 1; }
    // Whether drawing can continue on `shown`: it shows the study, in the plane of the drawing.
    bool goesOnOver(const SliceRequest& shown) const;
    void beginDrawing(SliceTool tool, const QPointF& place, const SliceRequest& shown);
    void moveDrawing(const glm::dvec3& mm);
    // The button went down or up at `mm`. The last point adds the measurement to the state and selects it.
    void pressDrawing(const glm::dvec3& mm);
    void releaseDrawing(const glm::dvec3& mm);
    void dropDrawing() { drawing_.reset(); }

    // The measurements to draw over the picture.
    std::vector<ShownMeasurement> seenOn(const SliceRequest& shown);

  private:
    bool isSeen(const slices::Measurement& measurement, const SliceRequest& shown) const;
    void finishIfComplete();
    QString textOf(const slices::Measurement& measurement, const SliceRequest& shown);
    QString textWhileDrawn(const slices::Measurement& measurement, const SliceRequest& shown);

    StudyEditor& session_;
    const PaneContent& content_;
    std::optional<MeasurementDrawing> drawing_;
    std::optional<std::size_t> selected_;
    MeasurementTexts texts_;
};

}  // namespace macula::viewer

// The measurements on a pane of slices: the visible ones, the selected one, and the one being drawn.
#pragma once

#include <QCoreApplication>
#include <QPointF>
#include <QString>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "slices/measurement.h"
#include "viewer/editor/study_editor.h"
#include "viewer/overlay/measurement_handles.h"
#include "viewer/overlay/slice_overlay.h"
#include "viewer/slices/measurement_drawing.h"
#include "viewer/slices/pane_content.h"
#include "viewer/slices/slice_sampler.h"

namespace macula::viewer {

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
    void moveDrawing(const glm::dvec3& mm, bool isHeld);
    // The button went down or up at `mm`. The last point adds the measurement to the state and selects it.
    void pressDrawing(const glm::dvec3& mm);
    void releaseDrawing(const glm::dvec3& mm);
    void dropDrawing() { drawing_.reset(); }
    // The index of an arrow that was finished since the last call, whose words are to be asked for.
    std::optional<std::size_t> takeFinishedArrow() { return std::exchange(finishedArrow_, std::nullopt); }
    void setNode(std::size_t measurement, bool isNode);  // of a lesion with both axes; else does nothing

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
    std::optional<std::size_t> finishedArrow_;
    MeasurementTexts texts_;
};

}  // namespace macula::viewer

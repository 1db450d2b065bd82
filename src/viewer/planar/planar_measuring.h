// Measurements on an image: drawn, moved by their handles, labelled, removed; with steps to undo.
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "study/planar/image_measurement.h"
#include "viewer/editor/undo_steps.h"
#include "viewer/planar/planar_layer.h"

namespace macula::viewer {

// The frame on screen; header and pixels are null while there is none.
struct MeasuredFrame {
    std::string image;  // study::imageKey
    int frame = 0;      // of its file
    std::shared_ptr<const dicom::PlanarHeader> header;
    std::shared_ptr<const dicom::PlanarFrame> pixels;
};

// Those of one series. A frame shows its own. Lives on the UI thread.
class PlanarMeasuring : public QObject, public PlanarLayer, public UndoSteps {
    Q_OBJECT

  public:
    using Kind = study::ImageMeasurement::Kind;

    explicit PlanarMeasuring(PlanarView& view);

    const std::vector<study::ImageMeasurement>& all() const { return all_; }
    void setAll(std::vector<study::ImageMeasurement> all);  // nothing is left to undo
    // As another view of the same series has them now. Steps stay; emits nothing.
    void follow(const std::vector<study::ImageMeasurement>& all);
    void setFrame(const MeasuredFrame& frame);  // drops what is being drawn on another frame
    // What the left button draws; nothing: a window.
    void setTool(std::optional<Kind> tool);
    std::optional<Kind> tool() const { return tool_; }
    bool isDrawing() const { return !points_.empty(); }
    void dropDrawing();
    bool hasSelected() const { return selected_.has_value(); }
    void removeSelected();
    void removeAll();
    void editLabelOfSelected();
    void setLabel(std::size_t index, const QString& label);
    // Of the frame on screen, in lines: as beside each.
    QString textsOfFrame() const;
    QString textOf(const study::ImageMeasurement& measurement) const;  // without its label

    QString undoText() const override;
    QString redoText() const override;
    void undo() override;
    void redo() override;

    void paint(QPainter& painter, const QTransform& paneFromPicture, const QRectF& area) override;
    bool press(const QPointF& place) override;
    void drag(const QPointF& place) override;
    void release(const QPointF& place) override;
    void hover(const QPointF& place) override;
    bool doubleClick(const QPointF& place) override;

  Q_SIGNALS:
    void changed();   // the measurements, or what can be undone
    void stepMade();  // there is one more to undo, before `changed`
    void toolChanged();

  private:
    struct Step {
        QString what;
        std::vector<study::ImageMeasurement> before;
    };
    struct Held {
        std::size_t index = 0;
        std::optional<std::size_t> handle;  // nothing: its line, which moves the whole
    };
    struct Known {
        study::ImageMeasurement measurement;
        std::weak_ptr<const dicom::PlanarFrame> pixels;
        QString text;
    };
    bool isOnFrame(const study::ImageMeasurement& measurement) const;
    std::optional<Held> heldAt(const QPointF& place) const;
    glm::dvec2 pixelOf(const QPointF& place) const;  // within the picture
    bool isFarFromLast(const QPointF& place) const;
    void addPoint(const QPointF& place);
    std::optional<study::ImageMeasurement> drawn() const;
    void record(Step step);
    void change(const QString& what, std::vector<study::ImageMeasurement> next);
    void restore(std::vector<Step>& from, std::vector<Step>& to);
    void editLabel(std::size_t index, const QPointF& place);
    void paintOne(QPainter& painter, const study::ImageMeasurement& measurement, bool isSelected,
                  const QTransform& paneFromPicture) const;

    PlanarView& view_;
    MeasuredFrame frame_;
    std::vector<study::ImageMeasurement> all_;
    std::vector<Step> done_;
    std::vector<Step> undone_;
    std::optional<Kind> tool_;
    std::optional<std::size_t> selected_;
    std::optional<Held> held_;
    std::optional<Step> moving_;      // before the drag
    QPointF heldFrom_;                // where the drag was last
    std::vector<glm::dvec2> points_;  // of the measurement that is being drawn
    glm::dvec2 pointer_{0.0};
    mutable std::vector<Known> known_;  // to count the values of an ellipse takes longer than to paint
};

}  // namespace macula::viewer

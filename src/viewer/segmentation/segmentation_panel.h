// A panel that chooses which segmentations of the study are seen, and how.
#pragma once

#include <QColor>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTreeWidget>
#include <QWidget>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "viewer/editor/study_editor.h"
#include "viewer/segmentation/segmentation_keeper.h"

namespace macula::viewer {

// Shows the segmentations that the keeper found, as the session's state has them, and proposes other states.
// Both outlive it.
class SegmentationPanel : public QWidget {
    Q_OBJECT

  public:
    SegmentationPanel(StudyEditor& session, SegmentationKeeper& keeper, QWidget* parent = nullptr);

    void showNames(bool shown);         // a segmentation's texts may name the patient
    void setColour(const QColor& rgb);  // of the selected segment, if there is one

  private:
    // A row of the tree; without a number the segmentation itself. Number 0 is a segment.
    struct Row {
        std::string digest;
        std::optional<std::uint16_t> number = {};
        bool operator==(const Row&) const = default;
    };

    QWidget* makeControls();
    void makeTree();
    void fill();
    void addSegmentation(const study::FoundSegmentation& found, std::size_t place);
    void addSegment(QTreeWidgetItem& above, const std::string& digest, const Segment& segment);
    void showChoices();
    void showChoice(QTreeWidgetItem& item);
    void showControls();
    void onItemChanged(QTreeWidgetItem* item, int column);
    void setIn3d(scene::In3d in3d, bool on);
    void setColoured(bool on);
    void editIn3d(const QString& what, bool needsShown,
                  const std::function<void(scene::SegmentSettings&)>& edit);
    QSlider* makeOpacity(const char* name, const QString& text, double scene::SegmentSettings::*opacity,
                         QWidget* parent);
    void askForColour();
    void centre();
    void edit(const QString& what, const std::function<void(scene::SegmentSettings&)>& edit,
              bool isDrag = false);

    static Row rowOf(const QTreeWidgetItem& item);
    std::optional<Row> selected() const;  // a segment that can be shown
    scene::SegmentSettings choice(const Row& row) const;
    std::optional<Segment> segment(const Row& row) const;
    const study::LoadedSegment* loaded(const Row& row) const;  // null: not loaded yet
    bool isCalibrated() const;  // the volume, as in Provenance; also without one
    QColor colour(const Row& row) const;

    StudyEditor& session_;
    SegmentationKeeper& keeper_;
    bool namesShown_ = true;
    bool isFilling_ = false;
    QTreeWidget* tree_ = nullptr;
    QLabel* notes_ = nullptr;
    QPushButton* colour_ = nullptr;
    QSlider* opacity_ = nullptr;
    QPushButton* alone_ = nullptr;
    QPushButton* hide_ = nullptr;
    QPushButton* coloured_ = nullptr;
    QSlider* opacityIn3d_ = nullptr;
    QPushButton* centre_ = nullptr;
};

}  // namespace macula::viewer

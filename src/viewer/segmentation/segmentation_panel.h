// A panel that chooses which segmentations of the study are seen, and how.
#pragma once

#include <QColor>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTreeWidget>
#include <QWidget>
#include <optional>
#include <string>

#include "viewer/editor/study_editor.h"
#include "viewer/segmentation/segment_edits.h"
#include "viewer/segmentation/segmentation_keeper.h"

namespace macula::viewer {

// Shows the segmentations that the keeper found, with their settings in the session's state, and proposes
// changes to these. Both outlive it.
class SegmentationPanel : public QWidget {
    Q_OBJECT

  public:
    SegmentationPanel(StudyEditor& session, SegmentationKeeper& keeper, QWidget* parent = nullptr);

    void showNames(bool shown);                 // a segmentation's texts may name the patient
    void setColour(const QColor& rgb);          // colours the selected segment, if any
    std::optional<SegmentId> selected() const;  // a segment that can be shown
    void select(const SegmentId& id);           // does nothing for one that is not listed

  Q_SIGNALS:
    void selectionChanged();  // or the list

  private:
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
    QSlider* makeOpacity(const char* name, const QString& text, double scene::SegmentSettings::*opacity,
                         QWidget* parent);
    void askForColour();
    void centre();

    static SegmentId idOf(const QTreeWidgetItem& item);
    bool isSame(const SegmentId& a, const SegmentId& b) const;  // revisions of own segments are the same
    bool isCalibrated() const;                                  // whether the volume is; true without one

    StudyEditor& session_;
    SegmentationKeeper& keeper_;
    SegmentEdits edits_;
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

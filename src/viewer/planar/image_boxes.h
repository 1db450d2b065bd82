// The grid of image boxes: its rows and columns, what each box shows, and which one a person has chosen.
#pragma once

#include <QString>
#include <QWidget>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "study/planar/image_measurement.h"
#include "study/planar/planar_images.h"
#include "viewer/context/window_context.h"
#include "viewer/editor/undo_steps.h"
#include "viewer/planar/box_links.h"

class QGridLayout;
class QMenu;
class QStackedWidget;

namespace macula::live {
class StudyKeeper;
}

namespace macula::viewer {

class ImageBox;
class PlanarMeasuring;

struct BoxArrangement {
    struct Box {
        std::shared_ptr<const study::FoundVolumes> found;
        const dicom::Stack* stack = nullptr;  // of `found`; null: the box is empty
        std::optional<std::size_t> place;     // in Stack::frames; nothing: the first, or as it was left

        bool operator==(const Box&) const = default;
    };
    int rows = 1;
    int columns = 1;
    std::vector<Box> boxes = {};  // row by row; missing ones are empty
    bool isLinked = false;        // boxes scroll together

    bool operator==(const BoxArrangement&) const = default;
};

// There is always a chosen box. Steps to undo are arrangements and the measurements of all boxes, in the
// order in which a person made them. Lives on the UI thread.
class ImageBoxes : public QWidget, public UndoSteps {
    Q_OBJECT

  public:
    explicit ImageBoxes(const WindowContext& context, QWidget* parent = nullptr);

    QWidget& bars() const;  // the controls of the chosen box
    ImageBox& chosen() const { return *boxes_.at(chosen_); }
    std::vector<ImageBox*> boxes() const;  // those of the grid, row by row
    int rows() const { return rows_; }
    int columns() const { return columns_; }
    bool isAlone() const { return isAlone_; }  // only the chosen one is visible
    bool isLinked() const { return links_.isOn(); }
    bool isShown() const { return firstShown() != nullptr; }
    const ImageBox* firstShown() const;  // null: all are empty
    void choose(ImageBox& box);          // does nothing for one that is not in the grid

    void keepIn(const std::shared_ptr<live::StudyKeeper>& keeper);
    void showNames(bool shown);
    void stopPlaying();

    BoxArrangement arrangement() const;
    void begin(const BoxArrangement& first);  // another study: nothing to undo is left
    void arrange(const QString& what, const BoxArrangement& next);
    // No step to undo: what a person opened stays chosen, and what was drawn meanwhile stays.
    void hang(const BoxArrangement& next);
    // Boxes keep what they show, as far as there is room; the chosen one always. New ones show what follows
    // in the study of the chosen one.
    void setGrid(int rows, int columns);
    void showInChosen(std::shared_ptr<const study::FoundVolumes> found, const study::PlanarSeries& series);
    void setLinked(bool linked);
    void setAlone(bool alone);
    void setMenu(QMenu* menu);  // of the grid, in the bar of each box; outlives this
    void clear();

    QString undoText() const override;
    QString redoText() const override;
    void undo() override;
    void redo() override;

  Q_SIGNALS:
    void shownChanged();  // what boxes show, or which one is chosen
    void imageShown();    // in the chosen box
    void arranged();      // rows, columns, links, what boxes show
    void stepsChanged();  // what can be undone, or a measurement
    void scrolled();      // a person chose another image in a box
    void closeAsked();
    void saveAsked();  // the measurements of the chosen box

  private:
    struct Step {
        PlanarMeasuring* measuring = nullptr;  // null: an arrangement
        QString what;
        BoxArrangement before;
    };
    ImageBox& addBox();
    void connectBox(ImageBox& box);
    void onDrop(ImageBox& box, const QByteArray& series);
    void apply(const BoxArrangement& next);
    void layOut();
    void showLines();
    void shareMeasurements(const ImageBox& from);
    void forgetStepsOf(const PlanarMeasuring& measuring);
    void restore(std::vector<Step>& from, std::vector<Step>& to, bool isUndo);

    WindowContext context_;
    QGridLayout* grid_;
    QStackedWidget* bars_;
    std::vector<ImageBox*> boxes_;  // those beyond the grid are empty
    BoxLinks links_;
    std::shared_ptr<live::StudyKeeper> keeper_;
    QMenu* menu_ = nullptr;
    std::size_t chosen_ = 0;
    int rows_ = 1;
    int columns_ = 1;
    bool isAlone_ = false;
    bool namesShown_ = true;
    bool isApplying_ = false;
    bool isLayingOut_ = false;
    std::map<const dicom::Stack*, std::vector<study::ImageMeasurement>> measured_;  // of all that was shown
    std::vector<Step> done_;
    std::vector<Step> undone_;
};

}  // namespace macula::viewer

// The panel that lists the measurements of the open study.
#pragma once

#include <QTreeWidget>
#include <cstddef>
#include <vector>

#include "slices/measurement.h"
#include "viewer/editor/study_editor.h"
#include "viewer/slices/pane_measurements.h"

namespace macula::viewer {

// A row for each measurement of the state, in its order: label, values, slice. A click takes the cross-hair
// of all panes there, and turns their planes if none is parallel to the measurement. F2 or a double click
// edits the label, Delete removes the selected ones. Lives on the UI thread.
class MeasurementList : public QTreeWidget {
    Q_OBJECT

  public:
    explicit MeasurementList(StudyEditor& session, QWidget* parent = nullptr);  // `session` outlives it

  protected:
    void showEvent(QShowEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    // Labels alone can be typed.
    bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override;

  private:
    void refresh();
    void goTo(std::size_t index);
    void removeSelected();
    void takeLabel(const QTreeWidgetItem& item, int column);

    StudyEditor& session_;
    MeasurementTexts texts_;
    std::vector<slices::Measurement> listed_;
    bool isStale_ = true;
    bool fills_ = false;  // items change because of refresh()
};

}  // namespace macula::viewer

// The studies that fit a link, to choose one from.
#pragma once

#include <QDialog>
#include <optional>
#include <vector>

#include "study/link/linked_studies.h"

class QLabel;
class QPushButton;
class QTreeView;

namespace macula::viewer {

class FoundStudyModel;

// Lives on the UI thread.
class LinkChoice : public QDialog {
    Q_OBJECT

  public:
    LinkChoice(study::LinkedStudies found, bool showsNames, QWidget* parent = nullptr);

  Q_SIGNALS:
    void chosen(const macula::study::LinkedStudy& study);

  private:
    void choose();
    void showArchive();
    std::optional<std::size_t> selected() const;

    study::LinkedStudies found_;
    FoundStudyModel* model_;
    QTreeView* list_;
    QLabel* archive_;
    QPushButton* open_;
};

}  // namespace macula::viewer

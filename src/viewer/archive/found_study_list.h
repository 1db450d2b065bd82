// A list of studies that a search found, and what can be done with the selected one.
#pragma once

#include <QList>
#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

#include "study/archive/study_search.h"
#include "viewer/archive/found_study_model.h"

class QAction;
class QPushButton;
class QSortFilterProxyModel;
class QTreeView;

namespace macula::viewer {

class ReadMarks;

// Lives on the UI thread.
class FoundStudyList : public QWidget {
    Q_OBJECT

  public:
    // `name` is the object name of the list; its buttons' begin with it.
    FoundStudyList(const QString& name, const QString& title, QWidget* parent = nullptr);

    // Keeps the selected study, or none if it is gone; without one before, selects the first.
    void setStudies(std::vector<study::ListedStudy> studies);
    void showNames(bool shown);
    void hideColumns(const QList<FoundStudyModel::Column>& columns);
    void setCanOpenBeside(bool can);  // whether a study is open
    void setMarks(ReadMarks* marks);  // outlives this
    std::optional<study::ListedStudy> selected() const;
    QTreeView& view() const { return *list_; }

    // Widths, order and choice of columns as text; an invalid text changes nothing.
    QString columns() const;
    void setColumns(const QString& columns);

  Q_SIGNALS:
    void openAsked(const macula::study::ListedStudy& study);
    void besideAsked(const macula::study::ListedStudy& study);
    void fetchAsked(const macula::study::ListedStudy& study);
    void columnsChanged();
    void selectionChanged();

  private:
    void makeButtons(QWidget& row, const QString& name);
    void makeMenuOfColumns();
    int rowOf(const study::ListedStudy& study) const;
    void fitColumns();
    void showButtons();
    void toggleMark();

    FoundStudyModel* model_;
    QSortFilterProxyModel* sorted_;
    QTreeView* list_;
    QPushButton* open_ = nullptr;
    QPushButton* beside_ = nullptr;
    QPushButton* fetch_ = nullptr;
    ReadMarks* marks_ = nullptr;
    QAction* mark_ = nullptr;
    bool canOpenBeside_ = false;
    bool hasOwnColumns_ = false;  // those that a person chose are not fitted to their contents
};

}  // namespace macula::viewer

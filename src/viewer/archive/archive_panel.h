// Searches an archive, and lists the studies that match.
#pragma once

#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "net/archive/query.h"
#include "net/archive/source.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSortFilterProxyModel;
class QTreeView;

namespace macula::viewer {

class FoundStudyModel;

// Lives on the UI thread.
class ArchivePanel : public QWidget {
    Q_OBJECT

  public:
    explicit ArchivePanel(QWidget* parent = nullptr);

    void setSources(const std::vector<net::Source>& sources);  // keeps the chosen one if it is still there
    QString source() const;                                    // its name; empty without any
    void setAnswers(const net::StudyAnswers& answers);
    void setRemark(const QString& text);  // below the list
    void setSearching(bool searching);
    void showNames(bool shown);
    void focusSearch();

  Q_SIGNALS:
    void searchAsked(const macula::net::StudyQuery& query);
    void openAsked(const macula::net::FoundStudy& study);
    void setUpAsked();

  private:
    QWidget* makeForm();
    QWidget* makeList();
    QWidget* makeButtons();
    QLineEdit* addField(QFormLayout& form, const QString& label, const char* name, const QString& tip);
    std::optional<net::StudyQuery> query();  // nothing, with a remark, where a date is none
    void search();
    std::optional<net::FoundStudy> selected() const;

    QComboBox* sources_;
    QLineEdit* patient_ = nullptr;
    QLineEdit* patientId_ = nullptr;
    QLineEdit* accession_ = nullptr;
    QLineEdit* from_ = nullptr;
    QLineEdit* to_ = nullptr;
    QComboBox* modality_ = nullptr;
    QLineEdit* description_ = nullptr;
    QPushButton* search_ = nullptr;
    QPushButton* open_ = nullptr;
    FoundStudyModel* model_;
    QSortFilterProxyModel* sorted_;
    QTreeView* list_ = nullptr;
    QLabel* remark_ = nullptr;
};

}  // namespace macula::viewer

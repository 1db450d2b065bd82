// Searches archives and this machine, and lists the studies that match, and others of the open patient.
#pragma once

#include <QStringList>
#include <QWidget>
#include <optional>
#include <vector>

#include "net/archive/query.h"
#include "net/archive/source.h"
#include "study/archive/study_search.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSplitter;

namespace macula::viewer {

class FoundStudyList;
class SeriesStrip;

// Where to search.
struct SearchedPlaces {
    QStringList archives;
    bool isHereToo = false;
};

// Lives on the UI thread.
class ArchivePanel : public QWidget {
    Q_OBJECT

  public:
    explicit ArchivePanel(QWidget* parent = nullptr);

    void setSources(const std::vector<net::Source>& sources);  // keeps the chosen place if it is still there
    SearchedPlaces places() const;
    SearchedPlaces allPlaces() const;
    void setListing(const study::Listing& listing, bool isWhole);
    // The same search, of which there is more by now; the keyboard stays where it is.
    void renewListing(const study::Listing& listing);
    void setRemark(const QString& text);  // below the list
    void setSearching(bool searching);
    // Other studies of the open patient; hides the list without any, unless there is a remark.
    void setPriors(const std::vector<study::ListedStudy>& priors, const QString& remark);
    void showNames(bool shown);
    void focusSearch();
    FoundStudyList& found() const { return *found_; }
    SeriesStrip& series() const { return *series_; }  // of the selected study
    FoundStudyList& priors() const { return *priors_; }

  Q_SIGNALS:
    void searchAsked(const macula::net::StudyQuery& query);
    void priorsAsked();  // those of all places
    void cancelAsked();
    void setUpAsked();

  private:
    QWidget* makeForm();
    QWidget* makeFound();
    QWidget* makePriors();
    QLineEdit* addField(QFormLayout& form, const QString& label, const char* name, const QString& tip);
    std::optional<net::StudyQuery> query();  // nothing, with a remark, where a date is none
    void search();
    void showCount(const study::Listing& listing, bool isWhole);

    QComboBox* places_;
    QLineEdit* patient_ = nullptr;
    QLineEdit* patientId_ = nullptr;
    QLineEdit* accession_ = nullptr;
    QLineEdit* from_ = nullptr;
    QLineEdit* to_ = nullptr;
    QComboBox* modality_ = nullptr;
    QLineEdit* description_ = nullptr;
    QPushButton* search_ = nullptr;
    bool isSearching_ = false;
    bool isTypedIn_ = false;  // since the search began
    QLabel* remark_;
    QString count_;  // of the listing, as the remark says it
    FoundStudyList* found_ = nullptr;
    SeriesStrip* series_ = nullptr;
    QWidget* priorsBox_ = nullptr;
    QLabel* priorsRemark_ = nullptr;
    FoundStudyList* priors_ = nullptr;
};

}  // namespace macula::viewer

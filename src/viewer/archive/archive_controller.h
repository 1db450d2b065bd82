// Studies from archives and from this machine: the panel that searches them, and opening what it lists.
#pragma once

#include <QObject>
#include <QStringList>
#include <QTimer>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "net/archive/query.h"
#include "net/sources/source_list.h"
#include "study/archive/fetched_study.h"
#include "study/archive/study_search.h"
#include "study/open/opened_study.h"
#include "viewer/archive/study_fetcher.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"

class QAction;
class QMenu;

namespace macula::viewer {

class ArchivePanel;
class OpeningController;
class PriorsController;
class ReadMarks;
class RecentMenu;
class SeriesPictures;
class SettingsController;
class WorkBar;

// A study is shown as soon as there are enough images of it for a volume, again when there are twice as many,
// and at last whole.
// Lives on the UI thread.
class ArchiveController : public QObject {
    Q_OBJECT

  public:
    struct Parts {
        OpeningController& opening;
        SettingsController& settings;
        const RecentMenu& recent;
    };
    ArchiveController(const WindowContext& context, Parts parts);

    ArchivePanel& panel() const { return *panel_; }
    WorkBar* bar() const { return fetcher_->bar(); }          // while studies are fetched
    void setShownAction(QAction& shown) { shown_ = &shown; }  // shows and hides the panel
    // Opens a folder as the second volume.
    void setOpensBeside(std::function<void(const std::filesystem::path&)> opens) {
        opensBeside_ = std::move(opens);
    }
    void addAction(QMenu& file);
    void setMarks(ReadMarks* marks);  // of the studies in the lists, and of the open one; outlives this
    // Fetches a study that the archive of this name has, and opens it as it comes.
    void fetchFrom(const QString& from, const net::FoundStudy& study);
    void showNames(bool shown);
    // Others sent images to this machine.
    void onStudiesReceived();
    bool fetching() const { return fetcher_->running(); }
    void onStudyShown();
    // Images that are no volume hide the open study; nothing: none do.
    void onImagesShown(const std::optional<study::Identity>& identity);

  Q_SIGNALS:
    void answered(const QString& archive);  // its name: it can be reached

  private:
    // A study that comes to be shown, or came last.
    struct Coming {
        std::string studyInstanceUid;
        study::StudySource openBefore;  // what was open when it began
        std::filesystem::path folder;   // once something came
        std::size_t lookedAt = 0;       // instances
    };

    void connectPanel();
    void showReadMark();
    const std::string& uidOnScreen() const;
    void connectFetcher();
    void showSeries();
    void readSources();
    void setUp();
    void search(const net::StudyQuery& query);
    void renewListing();
    void tellWhoAnswered(const study::Listing& listing);
    std::vector<std::filesystem::path> foldersHere() const;
    void open(const study::ListedStudy& listed);
    void openBeside(const study::ListedStudy& listed);
    void fetch(const study::ListedStudy& listed, FetchFor purpose);
    void lookAt(const FetchOrder& order, const study::Arrival& arrival);
    void showPart(const std::filesystem::path& folder);
    void finish(const FetchOrder& order, const Result<study::FetchedStudy>& fetched);
    void showWhole(const study::FetchedStudy& fetched, QStringList told);
    bool isOtherOpen() const;  // a person opened another study since the fetch began
    QStringList notes() const;

    WindowContext context_;
    Parts parts_;
    ArchivePanel* panel_;
    StudyFetcher* fetcher_;
    PriorsController* priors_;
    SeriesPictures* series_;
    QAction* shown_ = nullptr;
    QAction* read_ = nullptr;  // marks the open study
    ReadMarks* marks_ = nullptr;
    std::function<void(const std::filesystem::path&)> opensBeside_;
    std::optional<net::SourceList> sources_;
    QStringList searched_;                        // archives
    std::optional<net::StudyQuery> query_;        // of the last search, if it looked on this machine too
    std::optional<study::Listing> shownListing_;  // once that was done
    QTimer renewalTimer_;
    std::uint64_t searches_ = 0;
    Coming coming_;
    study::StudySource shownSource_;  // of the study on screen
    std::string shownUid_;
    std::string uidOfImages_;
    BackgroundJob<study::Listing> search_;
    BackgroundJob<study::Listing> renewal_;      // of what is on this machine
    BackgroundJob<std::filesystem::path> look_;  // whether what has come can be shown; its folder
};

}  // namespace macula::viewer

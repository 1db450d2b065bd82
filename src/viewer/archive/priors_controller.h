// Finds other studies of the open patient, lists them, and fetches those to compare with.
#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "net/sources/source_list.h"
#include "study/archive/priors.h"
#include "study/archive/study_search.h"
#include "viewer/archive/archive_panel.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

class SettingsController;
class StudyFetcher;

// When a study from an archive is shown, that archive is asked, and no other: who reads a study may see what
// its archive has of the patient. All places are asked only on demand. Lives on the UI thread.
class PriorsController : public QObject {
    Q_OBJECT

  public:
    struct Parts {
        ArchivePanel& panel;
        const SettingsController& settings;
        StudyFetcher& fetcher;
        // Null while the list of archives cannot be read.
        std::function<const net::SourceList*()> sources;
        std::function<std::vector<std::filesystem::path>()> folders;  // opened before
    };
    PriorsController(const WindowContext& context, Parts parts);

    // `folder`: of the study on screen.
    void onStudyShown(const std::optional<std::filesystem::path>& folder);
    // Looks again which of those listed are on this machine by now.
    void refresh();
    void searchEverywhere();

  private:
    void search(study::PlacesToSearch places);
    void show(const study::Listing& listing);
    void fetchSome(const std::vector<study::ListedStudy>& priors);

    WindowContext context_;
    Parts parts_;
    study::Identity patient_;                          // of the study on screen
    std::string archive_;                              // whence it came; empty: from none
    std::vector<std::string> modalities_;              // of the study on screen
    std::optional<study::PlacesToSearch> lastPlaces_;  // of the study on screen
    bool isAsked_ = false;                             // a person asked for the list
    bool isNew_ = false;  // nothing was found yet for this study, told or fetched
    BackgroundJob<study::Listing> search_;
};

}  // namespace macula::viewer

#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/links/manifests_controller.h"

#include <QMainWindow>
#include <utility>

#include "dicom/manifest/imaging_manifest.h"
#include "net/sources/source_list.h"
#include "study/manifest/manifest_fetch.h"
#include "viewer/language/window_language.h"
#include "viewer/status/notifications.h"
#include "viewer/status/status_widgets.h"
#include "viewer/volume/opening_controller.h"

namespace macula::viewer {

namespace {

using Fetched = std::vector<study::FetchedStudy>;

Result<Fetched> fetchNamed(const std::filesystem::path& file, Progress& progress) {
    MACULA_TRY(const dicom::ImagingManifest manifest, dicom::readImagingManifest(file));
    MACULA_TRY(const net::SourceList sources, net::SourceList::read(net::SourceFiles::ofUser()));
    MACULA_TRY(study::Spool spool, study::Spool::open());
    return study::fetchManifest(manifest, sources, {}, spool, progress);
}

}  // namespace

ManifestsController::ManifestsController(const WindowContext& context, OpeningController& opening)
    : QObject(&context.window),
      context_(context),
      opening_(opening),
      bar_(new WorkBar),
      fetch_(this, {.progressed =
                        [this](const ProgressUpdate& update) {
                            bar_->setProgress(inWindowsLanguage(update.stage), update.fraction);
                        },
                    .ended = [this](const Result<Fetched>& fetched) { show(fetched); }}) {
    connect(&opening_.loader(), &StudyLoader::foundManifest, this, &ManifestsController::open);
    connect(bar_, &WorkBar::cancelClicked, this, [this] {
        fetch_.cancel();
        bar_->hide();
        context_.notifications.showNote(
            tr("Fetching was cancelled. What came is kept; opening the manifest again goes on from there."));
    });
}

void ManifestsController::open(const QString& manifest) {
    openBefore_ = opening_.loader().source();
    bar_->begin(tr("Fetching what the manifest names"));
    fetch_.start([file = std::filesystem::path(manifest.toStdString())](Progress& progress) {
        return fetchNamed(file, progress);
    });
}

void ManifestsController::show(const Result<Fetched>& fetched) {
    bar_->hide();
    if (!fetched) return context_.notifications.failUnlessCancelled(fetched.error());
    told_.clear();
    if (fetched->size() > 1)
        told_.append(
            tr("The manifest names %n studies, which were all fetched. The first one is shown; macula "
               "pacs fetched lists them all.",
               nullptr, int(fetched->size())));
    for (const study::FetchedStudy& each : *fetched) {
        for (const Message& message : each.messages) told_.append(inWindowsLanguage(message));
    }
    if (opening_.loader().source() != openBefore_)
        return context_.notifications.showNote(
            tr("What the manifest names was fetched. Another study was opened meanwhile; open the manifest "
               "again "
               "to show it."));
    shown_ = fetched->front().folder;
    opening_.open(shown_);
}

void ManifestsController::onStudyShown() {
    const bool isOurs = !shown_.empty() && opening_.loader().source() == study::StudySource(shown_);
    const QStringList told = std::exchange(told_, {});
    if (isOurs && !told.isEmpty()) context_.notifications.showNote(told.join(QLatin1Char(' ')));
}

}  // namespace macula::viewer

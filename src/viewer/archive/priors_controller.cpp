#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/archive/priors_controller.h"

#include <QMainWindow>
#include <QStringList>
#include <utility>

#include "study/spool/spool.h"
#include "viewer/archive/archive_way.h"
#include "viewer/archive/found_study_list.h"
#include "viewer/archive/study_fetcher.h"
#include "viewer/editor/study_editor.h"
#include "viewer/language/window_language.h"
#include "viewer/settings/settings_controller.h"
#include "viewer/status/notifications.h"

namespace macula::viewer {

PriorsController::PriorsController(const WindowContext& context, Parts parts)
    : QObject(&context.window),
      context_(context),
      parts_(std::move(parts)),
      search_(this, {.ended = [this](const Result<study::Listing>& listing) {
                  if (listing) show(*listing);
              }}) {
    connect(&parts_.panel, &ArchivePanel::priorsAsked, this, &PriorsController::searchEverywhere);
}

void PriorsController::onStudyShown(const std::optional<std::filesystem::path>& folder) {
    parts_.panel.priors().setCanOpenBeside(true);
    const study::OpenedStudy& opened = context_.session.study();
    const auto record = folder ? study::useSpooled(*folder) : std::nullopt;
    study::Identity patient = opened.identity;
    patient.series = {};
    // A study that is shown again, as while it arrives, has the same others.
    if (patient == patient_ && !patient.studyInstanceUid.empty()) return;
    search_.cancel();
    patient_ = std::move(patient);
    archive_ = record ? record->source : std::string();
    modalities_ = {opened.volume->modality()};
    if (record && record->asFound && !record->asFound->modalities.empty())
        modalities_ = record->asFound->modalities;
    isAsked_ = false;
    isNew_ = true;
    lastPlaces_.reset();
    parts_.panel.setPriors({}, {});
    if (parts_.settings.settings().priors == PriorSearch::none || patient_.isOfNobody) return;
    study::PlacesToSearch places{.archives = {}, .isHereToo = true, .folders = {}};
    const net::SourceList* sources = parts_.sources();
    if (!archive_.empty() && sources != nullptr && sources->find(archive_))
        places.archives.push_back(namedArchive(*sources, QString::fromStdString(archive_)));
    search(std::move(places));
}

void PriorsController::refresh() {
    if (lastPlaces_ && !search_.running()) search(*lastPlaces_);
}

void PriorsController::searchEverywhere() {
    const net::SourceList* sources = parts_.sources();
    if (sources == nullptr) return;
    study::PlacesToSearch places{.archives = {}, .isHereToo = true, .folders = parts_.folders()};
    for (const net::Source& source : sources->all())
        places.archives.push_back(namedArchive(*sources, QString::fromStdString(source.name)));
    isAsked_ = true;
    isNew_ = false;
    search(std::move(places));
}

void PriorsController::search(study::PlacesToSearch places) {
    const auto query = study::queryForPriors(patient_);
    if (!query) {
        if (isAsked_)
            parts_.panel.setPriors({}, tr("The images name neither an ID nor a name and a date of birth, by "
                                          "which others of this patient could be found."));
        return;
    }
    if (isAsked_) parts_.panel.setPriors({}, tr("Searching…"));
    lastPlaces_ = places;
    search_.start([places = std::move(places), query = *query](Progress& progress) -> Result<study::Listing> {
        return study::searchStudies(places, query, progress);
    });
}

void PriorsController::show(const study::Listing& listing) {
    const std::vector<study::ListedStudy> priors = study::priorsOf(patient_, listing);
    QStringList lines;
    if (!priors.empty())
        lines.append(tr("%n other studies of this patient", nullptr, int(priors.size())));
    else if (isAsked_ || !archive_.empty())
        lines.append(tr("No other study of this patient was found."));
    else
        lines.append(tr("No other study of this patient is on this machine."));
    if (listing.isCutShort) lines.append(tr("The archive has more of them."));
    for (const study::SilentArchive& silent : listing.silent)
        lines.append(
            QStringLiteral("%1: %2").arg(QString::fromStdString(silent.name), inWindowsLanguage(silent.why)));
    parts_.panel.setPriors(priors, lines.join(QLatin1Char('\n')));
    if (!std::exchange(isNew_, false)) return;
    if (!priors.empty() && !isAsked_ && !parts_.panel.isVisible())
        context_.notifications.showNote(
            tr("%n other studies of this patient are listed in the panel Archive.", nullptr,
               int(priors.size())));
    if (parts_.settings.settings().priors == PriorSearch::fetch && !archive_.empty()) fetchSome(priors);
}

void PriorsController::fetchSome(const std::vector<study::ListedStudy>& priors) {
    const net::SourceList* sources = parts_.sources();
    if (sources == nullptr) return;
    for (const study::ListedStudy& prior : study::priorsToFetch({}, patient_, modalities_, priors)) {
        if (prior.archive != archive_) continue;
        auto way = wayTo(*sources, QString::fromStdString(prior.archive));
        if (way) parts_.fetcher.fetch({prior.study, *std::move(way), FetchFor::keep});
    }
}

}  // namespace macula::viewer

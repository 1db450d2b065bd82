#include "viewer/followup/follow_up_controller.h"

#include <QMainWindow>
#include <QMenu>
#include <memory>
#include <set>
#include <utility>

#include "base/log.h"
#include "live/store/study_keeper.h"
#include "session/model_key.h"
#include "study/open/found_volumes.h"
#include "study/open/same_patient.h"
#include "viewer/editor/study_editor.h"
#include "viewer/followup/follow_up_dialog.h"
#include "viewer/jobs/post.h"
#include "viewer/menus/controls.h"
#include "viewer/second/second_volume_loader.h"
#include "viewer/status/notifications.h"

namespace macula::viewer {

FollowUpController::FollowUpController(const WindowContext& context, const SecondVolumeLoader& second,
                                       live::StudyKeeper* keeper)
    : QObject(&context.window), context_(context), second_(second), keeper_(keeper) {}

void FollowUpController::addAction(QMenu& edit) {
    QAction* action = edit.addAction(tr("Follow-up of &Lesions…"), this, &FollowUpController::ask);
    describe(
        *action, "follow-up",
        tr("Sizes of lesions with the same label in the studies of this patient, sums and their changes"));
}

std::vector<FollowUpController::Known> FollowUpController::studies() const {
    const study::OpenedStudy& open = context_.session.study();
    std::vector<Known> known;
    std::set<std::string> uids{open.identity.studyInstanceUid};
    const auto identityOfUid = [](const std::string& uid) {
        return uid.empty() ? std::string() : session::studyIdentity(uid);
    };
    known.push_back({study::studyDay(open.identity), {identityOfUid(open.identity.studyInstanceUid)}});
    const auto addFrom = [&](const std::shared_ptr<const study::FoundVolumes>& found) {
        if (!found) return;
        for (const study::FoundVolume& volume : found->volumes()) {
            const study::Identity identity = study::identityOf(*volume.study);
            const std::string& uid = identity.studyInstanceUid;
            if (uid.empty() || study::samePatient(open.identity, identity) != study::SamePatient::yes)
                continue;
            if (uids.insert(uid).second) known.push_back({study::studyDay(identity), {identityOfUid(uid)}});
        }
    };
    addFrom(open.found);
    if (second_.second()) addFrom(second_.second()->study.found);
    return known;
}

void FollowUpController::ask() {
    if (!context_.session.hasStudy())
        return context_.notifications.refuse(tr("No study is open."), tr("Open a study first."));
    if (auto* open = context_.window.findChild<FollowUpDialog*>()) {
        open->raise();
        return open->activateWindow();
    }
    const std::vector<Known> known = studies();
    if (keeper_ == nullptr) return show(known, std::vector<live::KeptMeasurements>(known.size()));
    keeper_->withStore([this, known, keeper = keeper_, home = &context_.window,
                        volume = context_.session.study().volume](session::Store* store) {
        std::vector<live::StudyToRead> reads;
        for (const Known& each : known) reads.push_back(each.read);
        // What is measured on the open volume is on screen, and may not be kept yet.
        reads.front().exceptVolume = keeper->digests().of(volume);
        auto kept = std::make_shared<std::vector<live::KeptMeasurements>>(reads.size());
        std::shared_ptr<Error> error;
        if (store != nullptr) {
            auto read = live::keptMeasurements(*store, reads);
            if (read)
                *kept = std::move(*read);
            else
                error = std::make_shared<Error>(read.error());
        }
        post(home, [this, known, kept, error, volume] {
            // Another study may have been opened meanwhile.
            if (!context_.session.hasStudy() || context_.session.study().volume != volume) return;
            if (error) return context_.notifications.showError(*error);
            show(known, *kept);
        });
    });
}

void FollowUpController::show(const std::vector<Known>& studies,
                              const std::vector<live::KeptMeasurements>& kept) {
    FollowedStudies followed;
    std::size_t unreadable = 0;
    std::size_t undated = 0;
    for (std::size_t i = 0; i < studies.size(); ++i) {
        unreadable += kept[i].unreadable;
        FollowedStudy study{.exam = {.date = studies[i].date, .measurements = kept[i].measurements},
                            .study = studies[i].read.study,
                            .gone = kept[i].gone};
        if (i == 0) {
            followed.open = std::move(study);
            continue;
        }
        if (kept[i].volumes == 0) continue;  // nobody has opened it
        if (study.exam.date.empty()) {
            ++undated;
            continue;
        }
        followed.others.push_back(std::move(study));
    }
    if (followed.open.exam.date.empty() && !followed.others.empty()) {
        followed.others.clear();
        followed.notes << tr(
            "The open study has no date: others cannot be compared with it, and are left out.");
    }
    if (!followed.others.empty())
        followed.notes << tr("Whether the sizes of other studies are calibrated is not known here.");
    if (unreadable > 0)
        followed.notes << tr(
            "What was measured before could not be read everywhere; left out were %n states.", nullptr,
            int(unreadable));
    if (undated > 0)
        followed.notes << tr("%n studies have no date, and are left out.", nullptr, int(undated));
    auto* dialog = new FollowUpDialog(std::move(followed), context_);
    connect(dialog, &FollowUpDialog::goneChanged, this, &FollowUpController::keepGone);
    dialog->show();
}

void FollowUpController::keepGone(const std::string& study, const std::vector<std::string>& lesions) {
    if (keeper_ == nullptr || study.empty()) return;
    keeper_->withStore([study, lesions](session::Store* store) {
        if (store == nullptr) return;
        if (const auto done = live::keepGone(*store, study, lesions); !done)
            log::warning("which lesions are gone could not be stored");
    });
}

}  // namespace macula::viewer

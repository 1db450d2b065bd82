// Opens a second volume beside the study and registers it.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "live/model/part_digests.h"
#include "registration/rigid_registration.h"
#include "scene/second/second_volume_state.h"
#include "viewer/editor/study_editor.h"
#include "viewer/jobs/background_job.h"
#include "viewer/slices/second_volume_texts.h"
#include "viewer/volume/study_loader.h"

namespace macula::viewer {

// Holds at most one second volume while the study is open, and proposes its link and view to the session,
// which can undo them. A volume with the study's frame of reference is linked by it; any other is registered
// in the background and linked by hand until that succeeds; a dose is not. A volume of another patient is
// shown only after a person confirms it. Lives on the UI thread.
class SecondVolumeLoader : public QObject {
    Q_OBJECT

  public:
    // The session outlives it.
    explicit SecondVolumeLoader(StudyEditor& session, QObject* parent = nullptr);

    // Errors arrive by `failed`. Without a study the second overload does nothing.
    void open(study::StudySource source, bool join = false);
    void open(std::shared_ptr<const study::FoundVolumes> found, std::size_t index);
    // open() ends with this when it succeeds.
    void offer(const study::OpenedStudy& second);
    void close();   // also removes the second volume from the state
    void cancel();  // cancels reading or registering; an open volume stays
    bool isWorking() const { return loader_.loading() || registration_.running(); }
    bool isRegistering() const { return registration_.running(); }

    // Null without a second volume.
    const std::shared_ptr<const SecondVolumeTexts>& second() const { return second_; }
    // Null unless the state describes this second volume.
    const scene::SecondVolumeState* state() const;
    // Whether both show anatomy: a dose has none that a registration could match.
    bool canRegister() const;
    bool canShareFrame() const;  // both volumes name the same frame of reference
    // The stored link was for other voxels or positions under the same UIDs, and was discarded.
    bool isPlacedAnew() const { return isPlacedAnew_; }

    void registerNow();
    void linkByFrame();  // does nothing unless canShareFrame()
    void linkByHand();   // starts at its current position
    void setView(scene::SecondVolumePlace view);
    // Shows the second volume in the study's place, or returns to the view before that.
    void flip();

    void acceptPatient();  // answers askedAboutPatient
    void refusePatient();

  Q_SIGNALS:
    void began(const QString& stage);
    void progressed(const QString& stage, double fraction);
    void ended();  // after success, failure or cancellation
    void failed(const macula::Error& error);
    void askedAboutPatient(const QStringList& differs);
    void askedToJoin(const QString& path, const QString& question);  // open(path, true) is yes
    void secondChanged();                                            // second() is another volume, or null

  private:
    void onStudyShown();
    void openWhatStateNames();
    void show(study::OpenedStudy second);
    void drop();
    void onRegistered(const Result<registration::RigidRegistration>& found);
    void change(const QString& what, const std::function<void(scene::SecondVolumeState&)>& edit);
    void prepareWithStudy();
    std::string pairWith(const study::OpenedStudy& second) const;

    StudyEditor& session_;
    StudyLoader loader_;
    BackgroundJob<registration::RigidRegistration> registration_;
    std::shared_ptr<const SecondVolumeTexts> second_;
    bool isPlacedAnew_ = false;
    std::shared_ptr<live::PartDigests> digests_ = std::make_shared<live::PartDigests>();  // of both volumes
    std::optional<study::OpenedStudy> asked_;  // a volume of another patient, awaiting an answer
    scene::SecondVolumePlace before_ = scene::SecondVolumePlace::beside;  // the view before the last flip
};

}  // namespace macula::viewer

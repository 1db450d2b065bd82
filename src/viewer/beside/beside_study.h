// Opens a second volume for the study that is shown, and finds out where it lies.
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
#include "scene/second/beside_state.h"
#include "viewer/jobs/background_job.h"
#include "viewer/session/viewer_session.h"
#include "viewer/slices/second_series.h"
#include "viewer/volume/study_loader.h"

namespace macula::viewer {

// Holds one second volume, for as long as the study is open. How it is linked and shown is the session's
// state, and can be undone; this proposes it. A volume of the same frame of reference lies where it is; any
// other is registered in the background, and until then, or when that fails, is linked by hand. Of another
// patient it is shown only when somebody says so. Lives on the UI thread.
class BesideStudy : public QObject {
    Q_OBJECT

  public:
    // The session outlives it.
    explicit BesideStudy(ViewerSession& session, QObject* parent = nullptr);

    // Errors come by `failed`: there has to be a study.
    void open(app::StudySource source, bool join = false);
    void open(std::shared_ptr<const app::FoundVolumes> found, std::size_t index);
    // What open() ends with when all went well.
    void offer(const app::OpenedStudy& second);
    void close();   // and take it out of the state
    void cancel();  // reading or registering; what was opened stays
    bool isWorking() const { return loader_.loading() || registration_.running(); }
    bool isRegistering() const { return registration_.running(); }

    // Null: there is none.
    const std::shared_ptr<const SecondSeries>& second() const { return second_; }
    // Null unless the second volume is the one that the state is about.
    const app::BesideState* state() const;
    bool canShareFrame() const;  // both name one frame of reference
    // How it was left was of other voxels or positions under the same UIDs: it was placed anew.
    bool isPlacedAnew() const { return isPlacedAnew_; }

    void registerNow();
    void linkByFrame();  // nothing where they do not share one
    void linkByHand();   // from where it is
    void setView(app::BesideView view);
    // The second volume in the place of the study, and back to how it was shown.
    void flip();

    void acceptPatient();  // answers askedAboutPatient
    void refusePatient();

  signals:
    void began(const QString& stage);
    void progressed(const QString& stage, double fraction);
    void ended();  // whatever became of it
    void failed(const macula::Error& error);
    void askedAboutPatient(const QStringList& differs);
    void askedToJoin(const QString& path, const QString& question);  // open(path, true) is yes
    void secondChanged();                                            // another one, or none

  private:
    void onStudyShown();
    void openWhatStateNames();
    void show(app::OpenedStudy second);
    void drop();
    void onRegistered(const Result<registration::RigidRegistration>& found);
    void change(const QString& what, const std::function<void(app::BesideState&)>& edit);
    void prepareWithStudy();
    std::string pairWith(const app::OpenedStudy& second) const;

    ViewerSession& session_;
    StudyLoader loader_;
    BackgroundJob<registration::RigidRegistration> registration_;
    std::shared_ptr<const SecondSeries> second_;
    bool isPlacedAnew_ = false;
    std::shared_ptr<app::PartDigests> digests_ = std::make_shared<app::PartDigests>();  // of both volumes
    std::optional<app::OpenedStudy> asked_;             // of another patient: nobody has answered yet
    app::BesideView before_ = app::BesideView::beside;  // the last flip
};

}  // namespace macula::viewer

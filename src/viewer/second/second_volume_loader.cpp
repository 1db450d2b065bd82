#include "viewer/second/second_volume_loader.h"

#include <utility>

#include "scene/second/second_study.h"
#include "study/open/same_place.h"

namespace macula::viewer {

namespace {

scene::Layout layoutOf(slices::Orientation orientation) {
    switch (orientation) {
        case slices::Orientation::axial:
            return scene::Layout::axial;
        case slices::Orientation::coronal:
            return scene::Layout::coronal;
        case slices::Orientation::sagittal:
            break;
    }
    return scene::Layout::sagittal;
}

}  // namespace

SecondVolumeLoader::SecondVolumeLoader(StudyEditor& session, QObject* parent)
    : QObject(parent),
      session_(session),
      registration_(this, {.progressed =
                               [this](const ProgressUpdate& update) {
                                   Q_EMIT progressed(tr("Registering the second volume"), update.fraction);
                               },
                           .ended = [this](const auto& found) { onRegistered(found); }}) {
    connect(&session_, &StudyEditor::studyShown, this, &SecondVolumeLoader::onStudyShown);
    // Opening a view, or an undo, may bring back another second volume.
    connect(&session_, &StudyEditor::changed, this, [this](const scene::StudyState& before) {
        const auto& now = session_.state().secondVolume;
        if (now &&
            (!before.secondVolume || before.secondVolume->seriesDigest != now->seriesDigest ||
             before.secondVolume->volume != now->volume || before.secondVolume->volumeKey != now->volumeKey ||
             before.secondVolume->pair != now->pair))
            openWhatStateNames();
    });
    connect(&loader_, &StudyLoader::began, this, [this] { Q_EMIT began(tr("Opening the second volume")); });
    connect(&loader_, &StudyLoader::progressed, this, &SecondVolumeLoader::progressed);
    connect(&loader_, &StudyLoader::loaded, this, [this](const study::OpenedStudy& second) {
        Q_EMIT ended();
        offer(second);
    });
    connect(&loader_, &StudyLoader::cancelled, this, &SecondVolumeLoader::ended);
    connect(&loader_, &StudyLoader::failed, this, [this](const Error& error) {
        Q_EMIT ended();
        Q_EMIT failed(error);
    });
    connect(&loader_, &StudyLoader::askedToJoin, this, [this](const QString& path, const QString& question) {
        Q_EMIT ended();
        Q_EMIT askedToJoin(path, question);
    });
}

void SecondVolumeLoader::open(study::StudySource source, bool join) {
    if (!session_.hasStudy())
        return Q_EMIT failed(
            {ErrorCode::usage,
             Text::verbatim(tr("There is no study that a second volume could be beside.").toStdString()),
             {},
             Text::verbatim(tr("Open a study first.").toStdString())});
    asked_.reset();
    registration_.cancel();
    prepareWithStudy();
    loader_.open(std::move(source), join);
}

void SecondVolumeLoader::open(std::shared_ptr<const study::FoundVolumes> found, std::size_t index) {
    if (!session_.hasStudy() || !found || index >= found->volumes().size()) return;
    asked_.reset();
    registration_.cancel();
    prepareWithStudy();
    loader_.open(study::PhaseSource{.found = std::move(found)}, index);
}

// Computes the digests of both volumes on the loading thread, so that they are known later.
void SecondVolumeLoader::prepareWithStudy() {
    const std::weak_ptr<const Volume> ofStudy = session_.study().volume;  // it may be closed meanwhile
    loader_.setPrepare([digests = digests_, ofStudy](const study::OpenedStudy& second) {
        if (const auto study = ofStudy.lock()) digests->of(study);
        digests->of(second.volume);
    });
}

std::string SecondVolumeLoader::pairWith(const study::OpenedStudy& second) const {
    return scene::pairDigest(digests_->of(session_.study().volume), digests_->of(second.volume));
}

void SecondVolumeLoader::onStudyShown() {
    cancel();
    drop();
    openWhatStateNames();
}

// Opens the second volume if it is in the folder of the study; a person must open any other.
void SecondVolumeLoader::openWhatStateNames() {
    const auto& named = session_.state().secondVolume;
    if (!session_.hasStudy() || !named || state() != nullptr || !session_.study().found) return;
    if (const auto index = scene::volumeOf(*session_.study().found, *named))
        open(session_.study().found, *index);
}

void SecondVolumeLoader::drop() {
    asked_.reset();
    before_ = scene::SecondVolumePlace::beside;
    isPlacedAnew_ = false;
    if (!std::exchange(second_, nullptr)) return;
    Q_EMIT secondChanged();
}

void SecondVolumeLoader::close() {
    cancel();
    session_.change(tr("Second volume closed"), [](scene::StudyState& next) { next.secondVolume.reset(); });
    drop();
}

void SecondVolumeLoader::cancel() {
    loader_.cancel();  // emits `ended` through `cancelled`
    if (registration_.cancel()) Q_EMIT ended();
}

const scene::SecondVolumeState* SecondVolumeLoader::state() const {
    const auto& state = session_.state().secondVolume;
    return second_ && state && scene::isPlacedFor(*state, second_->study, second_->pair) ? &*state : nullptr;
}

bool SecondVolumeLoader::canRegister() const {
    return second_ && !second_->study.dose && !session_.study().dose;
}

bool SecondVolumeLoader::canShareFrame() const {
    return second_ && study::shareFrameOfReference(session_.study(), second_->study);
}

void SecondVolumeLoader::offer(const study::OpenedStudy& second) {
    if (!session_.hasStudy() || !second.volume) return;
    const study::OpenedStudy& study = session_.study();
    if (second.volume->size() == study.volume->size() && second.seriesDigest == study.seriesDigest &&
        second.volumeIndex == study.volumeIndex &&
        digests_->of(second.volume) == digests_->of(study.volume))  // and was not exported again
        return Q_EMIT failed({ErrorCode::usage,
                              Text::verbatim(tr("This is the volume that is open already.").toStdString()),
                              {},
                              Text::verbatim(tr("Choose another series to stand beside it.").toStdString())});
    if (study::samePatient(study.identity, second.identity) != study::SamePatient::no) return show(second);
    asked_ = second;
    QStringList differs;
    for (const std::string& name : study::whatDiffers(study.identity, second.identity))
        differs << QString::fromStdString(name);
    Q_EMIT askedAboutPatient(differs);
}

void SecondVolumeLoader::acceptPatient() {
    if (asked_) show(*std::exchange(asked_, std::nullopt));
}

void SecondVolumeLoader::refusePatient() {
    asked_.reset();
}

// If the state was stored for these voxels and positions, keeps its link, without another registration.
void SecondVolumeLoader::show(study::OpenedStudy second) {
    if (registration_.cancel()) Q_EMIT ended();
    std::string pair = pairWith(second);
    second_ = std::make_shared<const SecondVolumeTexts>(
        secondSeries(session_.study(), std::move(second), std::move(pair)));
    const bool wasLeft = state() != nullptr;
    const std::optional<scene::SecondVolumeState> before = session_.state().secondVolume;
    isPlacedAnew_ = !wasLeft && before && scene::namesSecond(*before, second_->study);
    if (!wasLeft) {
        const slices::Orientation acquired = slices::acquiredOrientation(*session_.study().volume);
        session_.change(tr("Second volume"), [&](scene::StudyState& next) {
            next.secondVolume = scene::firstLink(session_.study(), second_->study, second_->pair);
            if (isPlacedAnew_) next.secondVolume = scene::withLookOf(*next.secondVolume, *before);
            // Two columns in a quarter of the window are too small to compare anything.
            const bool areBeside = next.secondVolume->view == scene::SecondVolumePlace::beside;
            if (areBeside && next.layout == scene::Layout::fourPanes) next.layout = layoutOf(acquired);
            if (next.layout == scene::Layout::volume) next.layout = layoutOf(acquired);
        });
    }
    Q_EMIT secondChanged();
    if (!wasLeft && state() != nullptr && !state()->isLinked() && canRegister()) registerNow();
}

void SecondVolumeLoader::registerNow() {
    if (state() == nullptr || !canRegister()) return;
    registration_.start(
        [fixed = session_.study().measured(), moving = second_->study.measured()](Progress& progress) {
            return registration::registerRigid(*fixed, *moving, progress);
        });
    Q_EMIT began(tr("Registering the second volume"));
}

void SecondVolumeLoader::onRegistered(const Result<registration::RigidRegistration>& found) {
    Q_EMIT ended();
    if (!found) {
        if (found.error().code != ErrorCode::cancelled) Q_EMIT failed(found.error());
        return;
    }
    change(tr("Registration"), [&](scene::SecondVolumeState& next) {
        next.link = scene::SecondVolumeLink::registered;
        next.secondFromStudy = found->movingFromFixed;
        next.boundMm = found->boundMm;
        next.isDoubtful = found->isDoubtful();
        next.rivalMm = found->hasRival() ? found->rivalMm : 0.0;
    });
}

void SecondVolumeLoader::linkByFrame() {
    if (!canShareFrame()) return;
    if (registration_.cancel()) Q_EMIT ended();
    change(tr("Same frame of reference"), [](scene::SecondVolumeState& next) {
        next.link = scene::SecondVolumeLink::sameFrame;
        next.secondFromStudy = glm::dmat4(1.0);
    });
}

void SecondVolumeLoader::linkByHand() {
    if (registration_.cancel()) Q_EMIT ended();
    change(tr("Linked by hand"), [](scene::SecondVolumeState& next) {
        next.link = scene::SecondVolumeLink::byHand;
        if (next.view == scene::SecondVolumePlace::over) next.view = scene::SecondVolumePlace::beside;
    });
}

// A volume whose position is unknown is never laid over the study.
void SecondVolumeLoader::setView(scene::SecondVolumePlace view) {
    if (state() == nullptr || (view == scene::SecondVolumePlace::over && !state()->isLinked())) return;
    change(tr("Second volume"), [view](scene::SecondVolumeState& next) { next.view = view; });
}

void SecondVolumeLoader::flip() {
    const scene::SecondVolumeState* now = state();
    if (now == nullptr) return;
    if (now->view == scene::SecondVolumePlace::instead) return setView(before_);
    before_ = now->view;
    setView(scene::SecondVolumePlace::instead);
}

void SecondVolumeLoader::change(const QString& what,
                                const std::function<void(scene::SecondVolumeState&)>& edit) {
    if (state() == nullptr) return;
    session_.change(what, [&](scene::StudyState& next) { edit(*next.secondVolume); });
}

}  // namespace macula::viewer

#include "viewer/beside/beside_study.h"

#include <utility>

#include "scene/second/second_study.h"
#include "study/open/same_place.h"

namespace macula::viewer {

namespace {

app::Layout layoutOf(slices::Orientation orientation) {
    switch (orientation) {
        case slices::Orientation::axial:
            return app::Layout::axial;
        case slices::Orientation::coronal:
            return app::Layout::coronal;
        case slices::Orientation::sagittal:
            break;
    }
    return app::Layout::sagittal;
}

}  // namespace

BesideStudy::BesideStudy(ViewerSession& session, QObject* parent)
    : QObject(parent),
      session_(session),
      registration_(this, {.progressed =
                               [this](const ProgressUpdate& update) {
                                   emit progressed(tr("Registering the second volume"), update.fraction);
                               },
                           .ended = [this](const auto& found) { onRegistered(found); }}) {
    connect(&session_, &ViewerSession::studyShown, this, &BesideStudy::onStudyShown);
    // A view that was opened may name another one, and so may what is undone.
    connect(&session_, &ViewerSession::changed, this, [this](const app::StudyState& before) {
        const auto& now = session_.state().beside;
        if (now && (!before.beside || before.beside->seriesDigest != now->seriesDigest ||
                    before.beside->volume != now->volume || before.beside->volumeKey != now->volumeKey ||
                    before.beside->pair != now->pair))
            openWhatStateNames();
    });
    connect(&loader_, &StudyLoader::began, this, [this] { emit began(tr("Opening the second volume")); });
    connect(&loader_, &StudyLoader::progressed, this, &BesideStudy::progressed);
    connect(&loader_, &StudyLoader::loaded, this, [this](const app::OpenedStudy& second) {
        emit ended();
        offer(second);
    });
    connect(&loader_, &StudyLoader::cancelled, this, &BesideStudy::ended);
    connect(&loader_, &StudyLoader::failed, this, [this](const Error& error) {
        emit ended();
        emit failed(error);
    });
    connect(&loader_, &StudyLoader::askedToJoin, this, [this](const QString& path, const QString& question) {
        emit ended();
        emit askedToJoin(path, question);
    });
}

void BesideStudy::open(app::StudySource source, bool join) {
    if (!session_.hasStudy())
        return emit failed({ErrorCode::usage,
                            tr("There is no study that a second volume could be beside.").toStdString(),
                            {},
                            tr("Open a study first.").toStdString()});
    asked_.reset();
    registration_.cancel();
    prepareWithStudy();
    loader_.open(std::move(source), join);
}

void BesideStudy::open(std::shared_ptr<const app::FoundVolumes> found, std::size_t index) {
    if (!session_.hasStudy() || !found || index >= found->volumes().size()) return;
    asked_.reset();
    registration_.cancel();
    prepareWithStudy();
    loader_.open(std::move(found), index);
}

// Digests of both volumes are made where the second one is read: later they are known.
void BesideStudy::prepareWithStudy() {
    const std::weak_ptr<const Volume> ofStudy = session_.study().volume;  // it may be closed meanwhile
    loader_.setPrepare([digests = digests_, ofStudy](const app::OpenedStudy& second) {
        if (const auto study = ofStudy.lock()) digests->of(study);
        digests->of(second.volume);
    });
}

std::string BesideStudy::pairWith(const app::OpenedStudy& second) const {
    return app::pairDigest(digests_->of(session_.study().volume), digests_->of(second.volume));
}

void BesideStudy::onStudyShown() {
    cancel();
    drop();
    openWhatStateNames();
}

// Where it is in the folder of the study; what is elsewhere is for a person to open.
void BesideStudy::openWhatStateNames() {
    const auto& named = session_.state().beside;
    if (!session_.hasStudy() || !named || state() != nullptr || !session_.study().found) return;
    if (const auto index = app::volumeOf(*session_.study().found, *named))
        open(session_.study().found, *index);
}

void BesideStudy::drop() {
    asked_.reset();
    before_ = app::BesideView::beside;
    isPlacedAnew_ = false;
    if (!std::exchange(second_, nullptr)) return;
    emit secondChanged();
}

void BesideStudy::close() {
    cancel();
    session_.change(tr("Second volume closed"), [](app::StudyState& next) { next.beside.reset(); });
    drop();
}

void BesideStudy::cancel() {
    loader_.cancel();  // tells that it ended
    if (registration_.cancel()) emit ended();
}

const app::BesideState* BesideStudy::state() const {
    const auto& state = session_.state().beside;
    return second_ && state && app::isOf(*state, second_->study, second_->pair) ? &*state : nullptr;
}

bool BesideStudy::canShareFrame() const {
    return second_ && app::shareFrameOfReference(session_.study(), second_->study);
}

void BesideStudy::offer(const app::OpenedStudy& second) {
    if (!session_.hasStudy() || !second.volume) return;
    const app::OpenedStudy& study = session_.study();
    if (second.volume->size() == study.volume->size() && second.seriesDigest == study.seriesDigest &&
        second.volumeIndex == study.volumeIndex &&
        digests_->of(second.volume) == digests_->of(study.volume))  // and was not exported anew
        return emit failed({ErrorCode::usage,
                            tr("This is the volume that is open already.").toStdString(),
                            {},
                            tr("Choose another series to stand beside it.").toStdString()});
    if (app::samePatient(study.identity, second.identity) != app::SamePatient::no) return show(second);
    asked_ = second;
    QStringList differs;
    for (const std::string& name : app::whatDiffers(study.identity, second.identity))
        differs << QString::fromStdString(name);
    emit askedAboutPatient(differs);
}

void BesideStudy::acceptPatient() {
    if (asked_) show(*std::exchange(asked_, std::nullopt));
}

void BesideStudy::refusePatient() {
    asked_.reset();
}

// As it was left, when the state is of these voxels and positions: nobody has to register it again.
void BesideStudy::show(app::OpenedStudy second) {
    if (registration_.cancel()) emit ended();
    std::string pair = pairWith(second);
    second_ = std::make_shared<const SecondSeries>(
        secondSeries(session_.study(), std::move(second), std::move(pair)));
    const bool wasLeft = state() != nullptr;
    const std::optional<app::BesideState> before = session_.state().beside;
    isPlacedAnew_ = !wasLeft && before && app::names(*before, second_->study);
    if (!wasLeft) {
        session_.change(tr("Second volume"), [&](app::StudyState& next) {
            next.beside = app::firstLink(session_.study(), second_->study, second_->pair);
            if (isPlacedAnew_) next.beside = app::withLookOf(*next.beside, *before);
            // Two columns in a quarter of the window are too small to compare anything.
            if (next.layout == app::Layout::fourPanes || next.layout == app::Layout::volume)
                next.layout = layoutOf(slices::acquiredOrientation(*session_.study().volume));
        });
    }
    emit secondChanged();
    if (!wasLeft && state() != nullptr && !state()->isLinked()) registerNow();
}

void BesideStudy::registerNow() {
    if (state() == nullptr) return;
    registration_.start(
        [fixed = session_.study().measured(), moving = second_->study.measured()](Progress& progress) {
            return registration::registerRigid(*fixed, *moving, progress);
        });
    emit began(tr("Registering the second volume"));
}

void BesideStudy::onRegistered(const Result<registration::RigidRegistration>& found) {
    emit ended();
    if (!found) {
        if (found.error().code != ErrorCode::cancelled) emit failed(found.error());
        return;
    }
    change(tr("Registration"), [&](app::BesideState& next) {
        next.link = app::BesideLink::registered;
        next.secondFromStudy = found->movingFromFixed;
        next.boundMm = found->boundMm;
        next.isDoubtful = found->isDoubtful();
        next.rivalMm = found->hasRival() ? found->rivalMm : 0.0;
    });
}

void BesideStudy::linkByFrame() {
    if (!canShareFrame()) return;
    if (registration_.cancel()) emit ended();
    change(tr("Same frame of reference"), [](app::BesideState& next) {
        next.link = app::BesideLink::sameFrame;
        next.secondFromStudy = glm::dmat4(1.0);
    });
}

void BesideStudy::linkByHand() {
    if (registration_.cancel()) emit ended();
    change(tr("Linked by hand"), [](app::BesideState& next) {
        next.link = app::BesideLink::byHand;
        if (next.view == app::BesideView::over) next.view = app::BesideView::beside;
    });
}

// Nothing is laid over the study where nobody knows where it lies.
void BesideStudy::setView(app::BesideView view) {
    if (state() == nullptr || (view == app::BesideView::over && !state()->isLinked())) return;
    change(tr("Second volume"), [view](app::BesideState& next) { next.view = view; });
}

void BesideStudy::flip() {
    const app::BesideState* now = state();
    if (now == nullptr) return;
    if (now->view == app::BesideView::instead) return setView(before_);
    before_ = now->view;
    setView(app::BesideView::instead);
}

void BesideStudy::change(const QString& what, const std::function<void(app::BesideState&)>& edit) {
    if (state() == nullptr) return;
    session_.change(what, [&](app::StudyState& next) { edit(*next.beside); });
}

}  // namespace macula::viewer

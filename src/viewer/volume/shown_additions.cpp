#include "viewer/volume/shown_additions.h"

#include <new>
#include <utility>

#include "scene/second/second_curve.h"
#include "scene/second/second_study.h"
#include "viewer/segmentation/segmentation_keeper.h"

namespace macula::viewer {

ShownAdditions::ShownAdditions(StudyEditor& session, const SegmentationKeeper& segments, QObject* parent)
    : QObject(parent),
      session_(session),
      segments_(segments),
      joining_(this, {.ended = [this](const Result<DrawnSecondVolume>& outcome) { onSecond(outcome); }}),
      colouring_(this, {.ended = [this](const Result<std::shared_ptr<const TintBox>>& outcome) {
                     onTintBox(outcome);
                 }}) {
    connect(&session_, &StudyEditor::changed, this, &ShownAdditions::update);
    connect(&segments_, &SegmentationKeeper::listChanged, this, &ShownAdditions::update);
}

void ShownAdditions::forget() {
    joining_.cancel();
    colouring_.cancel();
    second_.reset();
    drawn_.reset();
    wantedSecond_.reset();
    wantedTints_.clear();
    madeTints_.clear();
    tintsOf_ = 0;
    wantedColours_.clear();
    makingGeometry_ = {};
    boxOf_ = {};
    box_.reset();
    made_ = {};
    additions_.reset();
    ofPhases_.reset();
}

void ShownAdditions::setSecond(std::shared_ptr<const SecondVolumeTexts> second) {
    if (second == second_) return;
    second_ = std::move(second);
    drawn_.reset();
    joining_.cancel();  // it was for the earlier second volume
    wantedSecond_.reset();
    if (made_.second) {  // made from the second volume before
        made_.second.reset();
        show();
    }
    update();
}

void ShownAdditions::update() {
    if (!session_.hasStudy()) return;
    updateSecond();
    updateTints();
}

void ShownAdditions::updateSecond() {
    const std::optional<scene::SecondVolumeState>& beside = session_.state().secondVolume;
    std::optional<scene::SecondVolumeState> wanted;
    if (beside && second_ && scene::isSecondIn3d(*beside) &&
        scene::isPlacedFor(*beside, second_->study, second_->pair) &&
        scene::maySecondBeIn3d(session_.study().identity, second_->study.identity))
        wanted = scene::secondPartIn3d(*beside);
    if (!wanted) {
        joining_.cancel();
        wantedSecond_.reset();
        if (!made_.second) return;
        made_.second.reset();
        return show();
    }
    if (!wanted->window && !wanted->preset) wanted->window = second_->usualWindow;
    if (wanted == wantedSecond_) return;
    wantedSecond_ = wanted;
    // A slider moves faster than this: when a job ends, the newest request is next.
    if (!joining_.running()) join();
}

void ShownAdditions::join() {
    joiningOf_ = *wantedSecond_;
    joining_.start([state = joiningOf_, volume = drawn_ ? drawn_ : second_->study.volume](
                       Progress&) -> Result<DrawnSecondVolume> {
        try {
            return scene::secondIn3d(state, in16Bits(volume));
        } catch (const std::bad_alloc&) {
            return Error{
                ErrorCode::outOfMemory,
                Text::verbatim(tr("There is not enough memory for the second volume in 3D.").toStdString()),
                {},
                Text::verbatim(tr("Close other programs, or look at it on slices.").toStdString())};
        }
    });
}

void ShownAdditions::onSecond(const Result<DrawnSecondVolume>& outcome) {
    const bool isOutdated = wantedSecond_ && *wantedSecond_ != joiningOf_;
    Result<void> usable;
    if (outcome) {
        Additions added;
        added.second = *outcome;
        usable = validate(added, *session_.study().volume);
    } else {
        usable = outcome.error();
    }
    if (!usable) {
        if (isOutdated) return join();  // a newer request has replaced the failed one
        made_.second.reset();
        session_.correct([](scene::StudyState& each) {
            if (each.secondVolume) each.secondVolume->in3d = false;
        });
        Q_EMIT failed(usable.error());
        return show();
    }
    made_.second = *outcome;
    drawn_ = made_.second->volume;
    madeOf_ = joiningOf_;
    if (isOutdated) join();
    show();
}

// Makes new tints only if the choices changed, or if more segmentations are loaded.
void ShownAdditions::updateTints() {
    std::vector<scene::ColouredIn3d> wanted = scene::colouredIn3dOf(session_.state().segmentations);
    const std::size_t loaded = segments_.allLoaded().size();
    if (wanted == wantedTints_ && (wanted.empty() || tintsOf_ == loaded)) return;
    wantedTints_ = std::move(wanted);
    tintsOf_ = loaded;
    makingTints_ = wantedTints_;
    std::erase_if(makingTints_, [this](const scene::ColouredIn3d& each) {
        return segments_.loaded(std::get<std::string>(each)) == nullptr;
    });
    if (wantedTints_.empty()) return showNoTints();
    auto planned = scene::plannedTints(session_.state().segmentations, segments_.allLoaded());
    if (!planned) {
        makingGeometry_ = {};
        // Fails asynchronously, like later errors: the caller has not finished its change of the state.
        return colouring_.start(
            [error = planned.error()](Progress&) -> Result<std::shared_ptr<const TintBox>> { return error; });
    }
    if (planned->geometry.parts.empty()) return showNoTints();
    wantedColours_ = std::move(planned->colours);
    if (box_ && planned->geometry == boxOf_) {
        colouring_.cancel();
        return showTints();
    }
    if (colouring_.running() && planned->geometry == makingGeometry_) return;  // it gets these colours
    makingGeometry_ = std::move(planned->geometry);
    colouring_.start([geometry = makingGeometry_, volume = session_.study().volume](Progress& progress) {
        return scene::tintBox(geometry, *volume, progress);
    });
}

void ShownAdditions::onTintBox(const Result<std::shared_ptr<const TintBox>>& outcome) {
    if (!outcome) {
        // The old colours stay, and the state is corrected to them: menus and panels agree with the picture.
        const std::vector<scene::ColouredIn3d> asked = std::exchange(wantedTints_, madeTints_);
        session_.correct([&](scene::StudyState& each) {
            if (scene::colouredIn3dOf(each.segmentations) == asked)
                each.segmentations = scene::withColoursIn3d(each.segmentations, madeTints_);
        });
        Q_EMIT failed(outcome.error());
        return;
    }
    box_ = *outcome;
    boxOf_ = std::move(makingGeometry_);
    makingGeometry_ = {};
    showTints();
}

void ShownAdditions::showTints() {
    madeTints_ = makingTints_;
    made_.tints = SegmentTints{box_, wantedColours_};
    show();
}

void ShownAdditions::showNoTints() {
    colouring_.cancel();
    madeTints_ = makingTints_;
    if (!made_.tints) return;
    made_.tints.reset();
    show();
}

void ShownAdditions::show() {
    std::vector<Text> remarks;
    if (made_.second && second_)
        remarks.push_back(
            scene::secondRemark(*made_.second->volume, madeOf_,
                                study::samePatient(session_.study().identity, second_->study.identity)));
    Additions ofPhases{.second = made_.second, .tints = {}, .remark = Text::joined(remarks, ", ")};
    if (ofPhases.isNothing())
        ofPhases_.reset();
    else if (!ofPhases_ || *ofPhases_ != ofPhases)
        ofPhases_ = std::make_shared<const Additions>(std::move(ofPhases));
    if (made_.tints) remarks.push_back(Text("coloured segments"));
    made_.remark = Text::joined(std::move(remarks), ", ");
    // Emitting the same additions again would restart the picture.
    if (made_.isNothing() ? additions_ == nullptr : additions_ && *additions_ == made_) return;
    additions_ = made_.isNothing() ? nullptr : std::make_shared<const Additions>(made_);
    Q_EMIT changed();
}

}  // namespace macula::viewer

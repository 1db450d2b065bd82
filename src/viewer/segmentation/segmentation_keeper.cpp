#include "viewer/segmentation/segmentation_keeper.h"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "scene/segments/own_segments.h"
#include "study/open/found_volumes.h"
#include "viewer/language/window_language.h"

namespace macula::viewer {

namespace {

using scene::SegmentationSettings;

}  // namespace

SegmentationKeeper::SegmentationKeeper(StudyEditor& session, QObject* parent)
    : QObject(parent),
      session_(session),
      finding_(this, {.ended = [this](const Result<Found>& outcome) { onFound(outcome); }}),
      loading_(this, {.progressed =
                          [this](const ProgressUpdate& update) {
                              Q_EMIT progressed(inWindowsLanguage(update.stage), update.fraction);
                          },
                      .ended = [this](const Result<Loaded>& outcome) { onLoaded(outcome); }}),
      masking_(this, {.ended = [this](const Result<std::optional<Mask>>& outcome) {
                   if (!outcome) {
                       Q_EMIT refused(outcome.error());
                       return;
                   }
                   made_ = making_;
                   Q_EMIT maskMade(*outcome);
               }}) {
    connect(this, &SegmentationKeeper::refused, this, &SegmentationKeeper::onRefused);
    connect(&session_, &StudyEditor::studyShown, this, &SegmentationKeeper::onStudyShown);
    connect(&session_, &StudyEditor::changed, this, &SegmentationKeeper::onChanged);
    onStudyShown();
}

const dicom::Stack* SegmentationKeeper::stack() const {
    const study::OpenedStudy& study = session_.study();
    if (!study.found || study.volumeIndex >= study.found->volumes().size()) return nullptr;
    return study.found->volumes()[study.volumeIndex].stack;
}

const study::LoadedSegmentation* SegmentationKeeper::loaded(std::string_view digest) const {
    const auto at = std::ranges::find_if(loaded_, [&](const Loaded& each) { return each->digest == digest; });
    return at == loaded_.end() ? nullptr : at->get();
}

QString SegmentationKeeper::trouble(std::string_view digest) const {
    const auto at = troubles_.find(digest);
    return at == troubles_.end() ? QString() : at->second;
}

void SegmentationKeeper::onStudyShown() {
    finding_.cancel();
    masking_.cancel();
    if (loading_.cancel()) Q_EMIT ended();
    found_.clear();
    opened_.clear();
    loaded_.clear();
    troubles_.clear();
    isBeingLoaded_.clear();
    masked_.clear();
    making_.clear();
    made_.clear();
    maskedOf_ = 0;
    shown_.reset();
    own_.clear();
    listedOwn_.clear();
    isOwnExpected_ = false;
    preview_.reset();
    if (stack() != nullptr) {
        finding_.start(
            [found = session_.study().found, index = session_.study().volumeIndex](Progress& progress) {
                return study::findSegmentations(*found, found->volumes().at(index), progress);
            });
    }
    Q_EMIT listChanged();
    Q_EMIT shownChanged();
}

void SegmentationKeeper::onFound(const Result<Found>& outcome) {
    if (outcome) {
        found_ = *outcome;
        found_.insert(found_.end(), opened_.begin(), opened_.end());
        listOwn();
    } else {
        Q_EMIT failed(outcome.error());
    }
    Q_EMIT listChanged();
    loadNext();
}

void SegmentationKeeper::onChanged(const scene::StudyState& before) {
    if (session_.state().segmentations == before.segmentations) return;
    const bool isOtherOwn = own_.follow(session_.state().segmentations);
    if (isOtherOwn) {
        listOwn();
        Q_EMIT listChanged();
    }
    // Retries a failed segmentation when a person shows it again.
    for (const SegmentationSettings& choice : session_.state().segmentations) {
        if (choice.isShown && !scene::choiceOf(before.segmentations, choice.digest).isShown)
            troubles_.erase(choice.digest);
    }
    if (isLoading() && !scene::choiceOf(session_.state().segmentations, isBeingLoaded_).isShown) {
        loading_.cancel();
        isBeingLoaded_.clear();
        Q_EMIT ended();
    }
    loadNext();
    showOnSlices();
    mask();
    if (isOtherOwn) Q_EMIT ownChanged();
}

// Puts the current revision in the place of the one that is listed.
void SegmentationKeeper::listOwn() {
    std::erase_if(found_, [](const study::FoundSegmentation& each) { return each.isOwn; });
    std::erase_if(loaded_, [this](const Loaded& each) { return each->digest == listedOwn_; });
    listedOwn_.clear();
    const Loaded& now = own_.current();
    if (!now || now->segments.empty()) return;
    found_.insert(found_.begin(), scene::foundOwn(*now, tr("Own segments").toStdString()));
    loaded_.push_back(now);
    listedOwn_ = now->digest;
}

void SegmentationKeeper::takeOwn(Loaded left) {
    own_.add(std::move(left));
    if (!own_.follow(session_.state().segmentations)) return;
    listOwn();
    Q_EMIT listChanged();
    showOnSlices();
    mask();
    Q_EMIT ownChanged();
}

void SegmentationKeeper::changeOwn(const QString& what, Loaded next) {
    // What an undo of the first change goes back to: named by the state like any other revision.
    if (!own()) {
        own_.add(scene::ownRevision({}, *session_.study().volume));
        session_.follow([this](scene::StudyState& state) {
            scene::choose(state.segmentations, SegmentationSettings{own_.newest()->digest, true, {}});
        });
    }
    const std::string before = own()->digest;
    own_.add(next);
    session_.change(
        what, [&](scene::StudyState& state) { scene::chooseRevision(state.segmentations, before, *next); });
}

void SegmentationKeeper::takeOpened(const study::OpenedLabelMap& opened) {
    const std::string& digest = opened.found.digest;
    for (Found* list : {&found_, &opened_}) {
        std::erase_if(*list, [&](const study::FoundSegmentation& each) { return each.digest == digest; });
        list->push_back(opened.found);
    }
    std::erase_if(loaded_, [&](const Loaded& each) { return each->digest == digest; });
    loaded_.push_back(opened.loaded);
    maskedOf_ = 0;  // its voxels may be others than before
    Q_EMIT listChanged();
    session_.change(tr("Open segmentation"), [&](scene::StudyState& next) {
        SegmentationSettings choice = scene::choiceOf(next.segmentations, digest);
        choice.isShown = true;
        scene::choose(next.segmentations, std::move(choice));
    });
    showOnSlices();
    mask();
}

void SegmentationKeeper::setPreview(std::optional<slices::ShownSegment> preview) {
    if (!preview && !preview_) return;
    preview_ = std::move(preview);
    showOnSlices();
}

// Loads the first segmentation that is shown but not loaded yet.
void SegmentationKeeper::loadNext() {
    if (isLoading() || isFinding() || stack() == nullptr) return;
    const auto isWanted = [this](const study::FoundSegmentation& each) {
        return each.canBeShown() && !loaded(each.digest) && trouble(each.digest).isEmpty() &&
               scene::choiceOf(session_.state().segmentations, each.digest).isShown;
    };
    const auto next = std::ranges::find_if(found_, isWanted);
    if (next == found_.end()) return;
    isBeingLoaded_ = next->digest;
    loading_.start([found = *next, volume = session_.study().volume, scanned = session_.study().found,
                    stack = stack()](Progress& progress) {
        return study::loadSegments(found, *volume, *stack, progress);
    });
    Q_EMIT began();
}

void SegmentationKeeper::onLoaded(const Result<Loaded>& outcome) {
    Q_EMIT ended();
    const std::string digest = std::exchange(isBeingLoaded_, {});
    if (outcome) {
        loaded_.push_back(*outcome);
    } else {
        troubles_[digest] = inWindowsLanguage(outcome.error());
        Q_EMIT failed(outcome.error());
    }
    Q_EMIT listChanged();
    showOnSlices();
    mask();
    loadNext();
}

void SegmentationKeeper::cancel() {
    if (!loading_.cancel()) return;
    isBeingLoaded_.clear();
    Q_EMIT ended();
    session_.change(tr("Segmentations"), [this](scene::StudyState& next) {
        for (const study::FoundSegmentation& each : found_) {
            SegmentationSettings choice = scene::choiceOf(next.segmentations, each.digest);
            if (!choice.isShown || loaded(each.digest)) continue;
            choice.isShown = false;
            scene::choose(next.segmentations, std::move(choice));
        }
    });
}

void SegmentationKeeper::showOnSlices() {
    auto shown = std::make_shared<slices::ShownSegments>();
    for (const study::FoundSegmentation& found : found_) {
        const SegmentationSettings choice = scene::choiceOf(session_.state().segmentations, found.digest);
        const study::LoadedSegmentation* there = choice.isShown ? loaded(found.digest) : nullptr;
        if (there == nullptr) continue;
        for (const study::LoadedSegment& segment : there->segments) {
            const scene::SegmentSettings how = scene::choiceOf(choice, segment.segment.number);
            if (!how.isVisible || !segment.isInVolume()) continue;
            slices::ShownSegment each;
            each.voxels = segment.voxels;
            each.label = segment.segment.label;
            each.rgb = how.rgb.value_or(study::usualRgb(segment.segment));
            each.opacity = how.opacity;
            each.isResampled = there->isResampled;
            each.hasFractions = there->hasFractions;
            shown->push_back(std::move(each));
        }
    }
    if (preview_) shown->push_back(*preview_);
    if (shown->empty() ? !shown_ : shown_ && *shown_ == *shown) return;
    shown_.reset();
    if (!shown->empty()) shown_ = std::move(shown);
    Q_EMIT shownChanged();
}

// Makes a new mask only if the choices changed, or if more segmentations are loaded.
void SegmentationKeeper::mask() {
    std::vector<scene::In3dOf> wanted = scene::in3dOf(session_.state().segmentations);
    if (wanted == masked_ && (wanted.empty() || maskedOf_ == loaded_.size())) return;
    masked_ = std::move(wanted);
    maskedOf_ = loaded_.size();
    making_ = masked_;
    std::erase_if(making_,
                  [this](const scene::In3dOf& each) { return !loaded(std::get<std::string>(each)); });
    if (masked_.empty()) {
        masking_.cancel();
        made_.clear();
        Q_EMIT maskMade(std::nullopt);
        return;
    }
    masking_.start([choices = session_.state().segmentations, loaded = loaded_,
                    volume = session_.study().volume](Progress& progress) {
        return scene::segmentMask(choices, loaded, *volume, progress);
    });
}

// Corrects the state to the old mask: picture and panel agree, and an undo does not request the failed one
// again.
void SegmentationKeeper::onRefused(const Error& error) {
    masking_.cancel();
    const std::vector<scene::In3dOf> asked = std::exchange(masked_, made_);
    session_.correct([&](scene::StudyState& each) {
        if (scene::in3dOf(each.segmentations) == asked)
            each.segmentations = scene::withIn3d(each.segmentations, made_);
    });
    Q_EMIT failed(error);
}

QString SegmentationKeeper::note() const {
    if (!session_.hasStudy() || isFinding() || isOwnExpected_) return {};
    const auto isThere = [this](const SegmentationSettings& choice) {
        return std::ranges::any_of(found_, [&](const study::FoundSegmentation& each) {
            return each.digest == choice.digest && each.canBeShown();
        });
    };
    for (const SegmentationSettings& choice : session_.state().segmentations) {
        if (choice.isShown && !isThere(choice) && !isOwn(choice.digest))
            return tr(
                "A segmentation that was shown with this study is not in the folder; nothing of it is "
                "shown or hidden.");
    }
    const auto count = std::ranges::count_if(
        found_, [](const study::FoundSegmentation& each) { return each.canBeShown() && !each.isOwn; });
    if (count == 0) return {};
    return tr("There are %n segmentations of this volume: F11.", nullptr, int(count));
}

}  // namespace macula::viewer

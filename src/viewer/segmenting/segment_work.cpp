#include "viewer/segmenting/segment_work.h"

#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <utility>

#include "scene/segments/own_segments.h"
#include "segment/voxel_sets.h"
#include "slices/sampled_slice.h"
#include "viewer/language/window_language.h"

namespace macula::viewer {

namespace {

constexpr std::array<std::uint8_t, 3> kPreviewRgb{255, 255, 0};
constexpr double kPreviewOpacity = 0.35;

QString mlText(double ml) {
    return QLocale().toString(ml, 'f', ml < 1.0 ? 3 : ml < 100.0 ? 2 : 1);
}

Error noMemory() {
    return {ErrorCode::outOfMemory,
            Text("There is not enough memory to change the segment."),
            {},
            Text("Close other programs, or make the segment smaller first.")};
}

// With what a hand or a program did to it now.
Segment madeBy(Segment segment, bool byHand) {
    const bool onlyByHand = byHand && (segment.algorithm.empty() || segment.algorithm == "MANUAL");
    segment.algorithm = onlyByHand ? "MANUAL" : "SEMIAUTOMATIC";
    segment.algorithmName = onlyByHand ? "" : "Macula";
    return segment;
}

}  // namespace

SegmentWork::SegmentWork(StudyEditor& session, SegmentationKeeper& keeper, QObject* parent)
    : QObject(parent),
      session_(session),
      keeper_(keeper),
      finding_(this, {.progressed =
                          [this](const ProgressUpdate& update) {
                              Q_EMIT progressed(inWindowsLanguage(update.stage), update.fraction);
                          },
                      .ended =
                          [this](const Result<Found>& outcome) {
                              Q_EMIT ended();
                              if (outcome) return showPreview(outcome->first, outcome->second);
                              Q_EMIT failed(outcome.error());
                          }}),
      editing_(this, {.progressed =
                          [this](const ProgressUpdate& update) {
                              Q_EMIT progressed(inWindowsLanguage(update.stage), update.fraction);
                          },
                      .ended =
                          [this](const Result<Voxels>& outcome) {
                              Q_EMIT ended();
                              if (!outcome) {
                                  Q_EMIT failed(outcome.error());
                                  return;
                              }
                              // An undo meanwhile counts.
                              if (keeper_.own() != editingOf_ || selected_ != editingNumber_) return;
                              commitVoxels(editingWhat_, **outcome, false);
                          }}),
      counting_(this, {.ended = [this](const Result<segment::Statistics>& outcome) {
                    if (outcome) statistics_ = *outcome;
                    Q_EMIT statisticsChanged();
                }}) {
    connect(&session_, &StudyEditor::studyShown, this, &SegmentWork::forget);
    connect(&keeper_, &SegmentationKeeper::ownChanged, this, [this] {
        if (selected_ && segment() == nullptr) select(std::nullopt);
        count();
    });
}

void SegmentWork::forget() {
    cancel();
    counting_.cancel();
    preview_.reset();
    previewText_.clear();
    selected_.reset();
    statistics_.reset();
    Q_EMIT selectionChanged();
    Q_EMIT previewChanged();
    Q_EMIT statisticsChanged();
}

void SegmentWork::cancel() {
    const bool wasFinding = finding_.cancel();
    const bool wasEditing = editing_.cancel();
    if (wasFinding || wasEditing) Q_EMIT ended();
}

const study::LoadedSegment* SegmentWork::segment() const {
    return selected_ && keeper_.own() ? keeper_.own()->segment(*selected_) : nullptr;
}

void SegmentWork::select(std::optional<std::uint16_t> number) {
    if (number == selected_) return;
    selected_ = number;
    Q_EMIT selectionChanged();
    count();
}

void SegmentWork::count() {
    counting_.cancel();
    statistics_.reset();
    if (const study::LoadedSegment* now = segment()) {
        counting_.start([voxels = now->voxels, volume = volume()](Progress& progress) {
            return segment::statisticsOf(*voxels, *volume, progress);
        });
    }
    Q_EMIT statisticsChanged();
}

std::vector<scene::OwnSegment> SegmentWork::ownSegments() const {
    return keeper_.own() ? scene::segmentsOf(*keeper_.own()) : std::vector<scene::OwnSegment>();
}

void SegmentWork::commit(const QString& what, std::vector<scene::OwnSegment> segments) {
    try {
        keeper_.changeOwn(what, scene::ownRevision(std::move(segments), *volume()));
    } catch (const std::bad_alloc&) {
        Q_EMIT failed(noMemory());
    }
}

void SegmentWork::addSegment(const QString& label) {
    if (!session_.hasStudy()) return;
    scene::OwnSegment own;
    own.segment.label = label.trimmed().toStdString();
    own.voxels = std::make_shared<const VoxelSet>();
    addSegments({std::move(own)}, tr("New segment"));
}

void SegmentWork::addSegments(std::vector<scene::OwnSegment> added, const QString& what) {
    std::vector<scene::OwnSegment> all = ownSegments();
    if (added.empty()) return;
    if (all.size() + added.size() > scene::kMostOwnSegments)
        return Q_EMIT failed({ErrorCode::usage,
                              Text("There can be at most {} segments of your own.", scene::kMostOwnSegments),
                              {},
                              Text("Delete some of them first.")});
    std::uint16_t number = 0;
    for (const scene::OwnSegment& each : all) number = std::max(number, each.segment.number);
    for (scene::OwnSegment& each : added) {
        each.segment.number = ++number;
        if (each.segment.label.empty()) each.segment.label = tr("Segment %1").arg(number).toStdString();
        each.segment.recommendedRgb = study::usualRgb(each.segment);
        all.push_back(std::move(each));
    }
    commit(what, std::move(all));
    select(number);
    Q_EMIT this->added(number);
}

void SegmentWork::rename(const QString& label) {
    if (segment() == nullptr || label.trimmed().isEmpty()) return;
    std::vector<scene::OwnSegment> all = ownSegments();
    for (scene::OwnSegment& each : all)
        if (each.segment.number == *selected_) each.segment.label = label.trimmed().toStdString();
    commit(tr("Name of the segment"), std::move(all));
}

void SegmentWork::removeSegment() {
    if (segment() == nullptr) return;
    std::vector<scene::OwnSegment> all = ownSegments();
    std::erase_if(all, [this](const scene::OwnSegment& each) { return each.segment.number == *selected_; });
    cancel();
    commit(tr("Delete segment"), std::move(all));
}

void SegmentWork::commitVoxels(const QString& what, VoxelSet voxels, bool byHand) {
    std::vector<scene::OwnSegment> all = ownSegments();
    const auto at = std::ranges::find_if(
        all, [this](const scene::OwnSegment& each) { return each.segment.number == selected_; });
    if (at == all.end() || voxels == *at->voxels) return;
    at->voxels = std::make_shared<const VoxelSet>(std::move(voxels));
    at->segment = madeBy(at->segment, byHand);
    commit(what, std::move(all));
}

void SegmentWork::refuseForMemory() {
    Q_EMIT failed(noMemory());
}

void SegmentWork::setBrush(const BrushChoice& choice) {
    brush_ = choice;
}

void SegmentWork::previewBetween(const ValueRange& range) {
    if (!session_.hasStudy()) return;
    const study::LoadedSegment* within = brush_.withinSegment ? segment() : nullptr;
    finding_.start([range, volume = volume(), within = within != nullptr ? within->voxels : nullptr](
                       Progress& progress) -> Result<Found> {
        MACULA_TRY(VoxelSet set, segment::voxelsBetween(*volume, range, within.get(), progress));
        return Found(std::make_shared<const VoxelSet>(std::move(set)), QString());
    });
    Q_EMIT began(tr("Threshold"));
}

void SegmentWork::growAt(const glm::dvec3& mm) {
    const auto at = slices::probe(*volume(), mm);
    if (!at) return;
    const study::LoadedSegment* within = brush_.withinSegment ? segment() : nullptr;
    const double voxelMl = segment::voxelMl(volume()->worldFromVoxel());
    segment::GrowRequest request{.seed = at->voxel,
                                 .tolerance = brush_.tolerance,
                                 .corners = brush_.overCorners,
                                 .mostVoxels = std::size_t(std::max(1.0, brush_.mostMl / voxelMl + 1e-6))};
    const QString cutShort = tr("Growing stopped at %1 ml: it may have leaked.").arg(mlText(brush_.mostMl));
    finding_.start(
        [request, cutShort, volume = volume(),
         within = within != nullptr ? within->voxels : nullptr](Progress& progress) mutable -> Result<Found> {
            request.within = within.get();
            MACULA_TRY(segment::Grown grown, segment::grownFrom(*volume, request, progress));
            return Found(std::make_shared<const VoxelSet>(std::move(grown.voxels)),
                         grown.isCutShort ? cutShort : QString());
        });
    Q_EMIT began(tr("Growing"));
}

void SegmentWork::showPreview(Voxels voxels, const QString& text) {
    preview_ = std::move(voxels);
    previewText_ = text;
    keeper_.setPreview(slices::ShownSegment{.voxels = preview_,
                                            .label = tr("Preview").toStdString(),
                                            .rgb = kPreviewRgb,
                                            .opacity = kPreviewOpacity});
    Q_EMIT previewChanged();
}

QString SegmentWork::previewText() const {
    if (!preview_) return {};
    if (preview_->isEmpty()) return tr("Nothing was found.");
    const double ml = double(preview_->count()) * segment::voxelMl(volume()->worldFromVoxel());
    const QString size = tr("Preview: %1 ml, in no segment yet.").arg(mlText(ml));
    return previewText_.isEmpty() ? size : size + QLatin1Char(' ') + previewText_;
}

void SegmentWork::dropPreview() {
    if (finding_.cancel()) Q_EMIT ended();
    if (!preview_) return;
    preview_.reset();
    previewText_.clear();
    keeper_.setPreview(std::nullopt);
    Q_EMIT previewChanged();
}

void SegmentWork::joinPreview(PreviewJoin how) {
    if (!preview_) return;
    if (segment() == nullptr) addSegment({});
    if (segment() == nullptr) return;
    const Voxels found = preview_;
    dropPreview();
    edit(how == PreviewJoin::takeAway ? tr("Take away") : tr("Add to the segment"),
         [found, how](const VoxelSet& before, Progress&) -> Result<VoxelSet> {
             if (how == PreviewJoin::add) return segment::united(before, *found);
             if (how == PreviewJoin::takeAway) return segment::without(before, *found);
             return *found;
         });
}

void SegmentWork::edit(const QString& what, const Change& change) {
    const study::LoadedSegment* now = segment();
    if (now == nullptr) return;
    editingWhat_ = what;
    editingOf_ = keeper_.own();
    editingNumber_ = *selected_;
    editing_.start([change, before = now->voxels](Progress& progress) -> Result<Voxels> {
        try {
            MACULA_TRY(VoxelSet after, change(*before, progress));
            return std::make_shared<const VoxelSet>(std::move(after));
        } catch (const std::bad_alloc&) {
            return noMemory();
        }
    });
    Q_EMIT began(what);
}

void SegmentWork::apply(SegmentFilter filter, double amount) {
    if (segment() == nullptr) return;
    const segment::SegmentGrid grid{volume()->size(), volume()->spacingMm()};
    const double voxelMl = segment::voxelMl(volume()->worldFromVoxel());
    edit(undoNameOf(filter), [=](const VoxelSet& before, Progress& progress) {
        return filtered(filter, amount, before, grid, voxelMl, progress);
    });
}

}  // namespace macula::viewer

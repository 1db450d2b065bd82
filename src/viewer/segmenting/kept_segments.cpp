#include "viewer/segmenting/kept_segments.h"

#include <QScopedValueRollback>
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "live/store/opened_record.h"
#include "live/store/study_keeper.h"
#include "scene/segments/own_segments.h"
#include "scene/segments/own_segments_json.h"
#include "viewer/jobs/post.h"

namespace macula::viewer {

namespace {

constexpr int kStoredAfterMs = 300;
constexpr std::int64_t kVersion = 1;

session::DocumentId idOf(const Volume& volume, const std::string& digest) {
    return {.kind = session::DocumentKind::studyState,
            .study = live::openedVolume(volume, digest).study,
            .name = digest + " own segments"};
}

}  // namespace

KeptSegments::KeptSegments(StudyEditor& session, SegmentationKeeper& keeper, live::StudyKeeper* store,
                           QObject* parent)
    : QObject(parent), session_(session), keeper_(keeper), store_(store) {
    soon_.setSingleShot(true);
    soon_.setInterval(kStoredAfterMs);
    connect(&soon_, &QTimer::timeout, this, &KeptSegments::flush);
    connect(&session_, &StudyEditor::studyShown, this, &KeptSegments::onStudyShown);
    connect(&keeper_, &SegmentationKeeper::ownChanged, this, &KeptSegments::onOwnChanged);
}

bool KeptSegments::hasVoxels(const Revision& revision) {
    return revision && std::ranges::any_of(revision->segments, &study::LoadedSegment::isInVolume);
}

void KeptSegments::onStudyShown() {
    flush();  // of the study before
    // Phases of a series are volumes of their own.
    series_ = session_.study().seriesDigest + " " + std::to_string(session_.study().volumeIndex);
    if (!session_.hasStudy()) return;
    const auto known = left_.find(series_);
    if (known != left_.end() && known->second.size == session_.study().volume->size()) {
        const QScopedValueRollback taking(isTaking_, true);
        keeper_.takeOwn(known->second.revision);
        return;
    }
    if (store_) look();
}

void KeptSegments::look() {
    keeper_.expectOwn(true);
    const auto answer = [this, of = session_.study().volume](Result<Revision> found) {
        post(this, [this, of, found] {
            if (session_.study().volume == of) onFound(found);
        });
    };
    // This outlives the store, which does all of its work before the window ends.
    store_->withStore([answer, keeper = store_, volume = session_.study().volume](session::Store* store) {
        if (store == nullptr) return answer(Revision());
        const auto document = store->getDocument(idOf(*volume, keeper->digests().of(volume)));
        if (!document) return answer(document.error());
        if (!*document) return answer(Revision());
        answer(scene::ownRevisionFromJson((*document)->json, *volume));
    });
}

void KeptSegments::onFound(const Result<Revision>& found) {
    keeper_.expectOwn(false);
    if (!found) {
        unread_.insert(series_);
        Q_EMIT failed(found.error());
    } else if (*found && !keeper_.own()) {
        const QScopedValueRollback taking(isTaking_, true);
        left_[series_] = {session_.study().volume->size(), *found, true};
        keeper_.takeOwn(*found);
    } else if (*found) {
        // A person was faster than the disk: both count.
        std::vector<scene::OwnSegment> all = scene::segmentsOf(*keeper_.own());
        std::uint16_t number = all.empty() ? 0 : all.back().segment.number;
        std::vector<scene::OwnSegment> stored = scene::segmentsOf(**found);
        for (scene::OwnSegment& each : stored) {
            each.segment.number = ++number;
            all.push_back(std::move(each));
        }
        keeper_.changeOwn(tr("Own segments"), scene::ownRevision(std::move(all), *session_.study().volume));
    }
    Q_EMIT looked();
}

void KeptSegments::onOwnChanged() {
    if (isTaking_ || !session_.hasStudy()) return;
    const Revision& now = keeper_.own();
    if (!now) return;
    left_[series_] = {session_.study().volume->size(), now, !hasVoxels(now)};
    waiting_ = session_.study().volume;
    soon_.start();
}

void KeptSegments::flush() {
    soon_.stop();
    const auto at = left_.find(series_);
    if (!waiting_ || at == left_.end() || store_ == nullptr || unread_.contains(series_))
        return waiting_.reset();
    at->second.isKept = true;  // the store finishes what it was given, unless it says that it cannot
    store(series_, at->second.revision);
    waiting_.reset();
}

void KeptSegments::store(const std::string& series, const Revision& revision) {
    const auto failed = [this, series, revision](const Error& error) {
        post(this, [this, series, revision, error] {
            const auto at = left_.find(series);
            if (at != left_.end() && at->second.revision == revision)
                at->second.isKept = !hasVoxels(revision);
            Q_EMIT this->failed(error);
        });
    };
    store_->withStore([failed, keeper = store_, revision, volume = waiting_](session::Store* store) {
        // Without a store the keeper has told why, once.
        if (store == nullptr) return failed({ErrorCode::cancelled, Text("Nothing is stored."), {}, {}});
        const auto id = idOf(*volume, keeper->digests().of(volume));
        const auto json = scene::toJson(*revision, *volume);
        if (!json) return failed(json.error());
        constexpr std::array<std::string_view, 3> kKnown{"digest", "size", "segments"};
        if (const auto put = store->putDocument(id, kVersion, *json, kKnown); !put) failed(put.error());
    });
}

bool KeptSegments::isAllKept() const {
    return std::ranges::all_of(left_, [](const auto& each) { return each.second.isKept; });
}

KeptSegments::Mark KeptSegments::mark() const {
    const auto at = left_.find(series_);
    return {series_, at == left_.end() ? nullptr : at->second.revision};
}

void KeptSegments::wereSaved(const Mark& mark) {
    const auto at = left_.find(mark.volume);
    if (at != left_.end() && at->second.revision == mark.revision) at->second.isKept = true;
}

void KeptSegments::giveUp() {
    for (auto& [series, left] : left_) left.isKept = true;
}

}  // namespace macula::viewer

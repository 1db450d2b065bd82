#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/hanging/kept_arrangement.h"

#include <array>
#include <chrono>
#include <string_view>
#include <utility>

#include "base/log.h"
#include "live/store/study_keeper.h"
#include "viewer/jobs/post.h"

namespace macula::viewer {

namespace {

constexpr std::chrono::milliseconds kSoon{700};
constexpr std::int64_t kVersion = 1;
constexpr std::array<std::string_view, 5> kMembers{"version", "rows", "columns", "linked", "boxes"};

}  // namespace

study::KeptBoxes keptOf(const BoxArrangement& arrangement) {
    study::KeptBoxes kept{.rows = arrangement.rows,
                          .columns = arrangement.columns,
                          .isLinked = arrangement.isLinked,
                          .boxes = {}};
    for (const BoxArrangement::Box& box : arrangement.boxes) {
        kept.boxes.emplace_back();
        if (box.stack == nullptr) continue;
        const study::PlanarSeries of = study::seriesOf(*box.found, box.stack);
        if (of.stack != nullptr && !of.series->seriesInstanceUid.empty())
            kept.boxes.back() = {.series = study::seriesDigest(*of.series),
                                 .stack = std::size_t(of.stack - of.series->stacks.data()),
                                 .place = box.place.value_or(0)};
    }
    return kept;
}

BoxArrangement arrangementOf(const study::KeptBoxes& kept,
                             const std::shared_ptr<const study::FoundVolumes>& found, int patient) {
    BoxArrangement made{.rows = kept.rows, .columns = kept.columns, .boxes = {}, .isLinked = kept.isLinked};
    for (const auto& box : kept.boxes) {
        made.boxes.emplace_back();
        if (!box) continue;
        const dicom::Stack* stack = study::stackOf(*box, *found, patient);
        if (stack != nullptr) made.boxes.back() = {found, stack, box->place};
    }
    return made;
}

KeptArrangement::KeptArrangement(QObject* parent) : QObject(parent) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &KeptArrangement::keepNow);
}

KeptArrangement::~KeptArrangement() {
    keepNow();
}

void KeptArrangement::setKeeper(std::shared_ptr<live::StudyKeeper> keeper) {
    keepNow();
    keeper_ = std::move(keeper);
}

void KeptArrangement::open(const dicom::Study& study) {
    close();
    if (!keeper_ || study.studyInstanceUid.empty()) return Q_EMIT answered({});
    id_ = session::DocumentId{.kind = session::DocumentKind::studyState,
                              .study = session::studyIdentity(study.studyInstanceUid),
                              .name = "boxes of images"};
    stored_.clear();
    keeper_->withStore([home = this, opening = openings_, id = *id_](session::Store* store) {
        const auto document = store != nullptr ? store->getDocument(id)
                                               : Result<std::optional<session::Document>>(std::nullopt);
        const std::string text = document && *document ? (*document)->json : std::string();
        post(home, [home, opening, text] {
            if (opening != home->openings_) return;
            home->stored_ = text;
            Q_EMIT home->answered(study::keptBoxesOf(text));
        });
    });
}

void KeptArrangement::close() {
    keepNow();
    id_.reset();
    ++openings_;
}

void KeptArrangement::keep(const study::KeptBoxes& boxes) {
    if (!id_) return;
    waiting_ = study::toJson(boxes);
    timer_.start(kSoon);
}

void KeptArrangement::keepNow() {
    timer_.stop();
    const auto text = std::exchange(waiting_, {});
    if (!text || !id_ || !keeper_ || *text == stored_) return;
    stored_ = *text;
    keeper_->withStore([id = *id_, text = *text](session::Store* store) {
        if (store == nullptr) return;
        if (const auto done = store->putDocument(id, kVersion, text, kMembers); !done)
            log::warning("how boxes were arranged could not be stored");
    });
}

}  // namespace macula::viewer

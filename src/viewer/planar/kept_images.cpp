#include "viewer/planar/kept_images.h"

#include <chrono>
#include <utility>

#include "base/log.h"
#include "base/sha256.h"
#include "live/store/study_keeper.h"
#include "viewer/jobs/post.h"

namespace macula::viewer {

namespace {

constexpr std::chrono::milliseconds kSoon{700};
constexpr std::int64_t kVersion = 1;

session::DocumentId idOf(const session::OpenedVolume& opened, const std::string& name) {
    return {.kind = session::DocumentKind::studyState, .study = opened.study, .name = name};
}

// Of the stack's place in its series: each keeps its own.
std::size_t placeOf(const study::PlanarSeries& series) {
    return std::size_t(series.stack - series.series->stacks.data());
}

}  // namespace

KeptImages::KeptImages(QObject* parent) : QObject(parent) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &KeptImages::keepNow);
}

KeptImages::~KeptImages() {
    keepNow();
}

void KeptImages::setKeeper(std::shared_ptr<live::StudyKeeper> keeper) {
    keepNow();
    keeper_ = std::move(keeper);
}

void KeptImages::close() {
    keepNow();
    opened_.reset();
    ++openings_;
}

void KeptImages::open(const study::PlanarSeries& series) {
    close();
    const std::string& study = series.series->studyInstanceUid;
    const std::string& uid = series.series->seriesInstanceUid;
    if (!keeper_ || study.empty() || uid.empty()) return;
    // Images have no volume; their series stands for it, so that the study is listed and purged as others.
    opened_ = session::OpenedVolume{.study = session::studyIdentity(study),
                                    .series = session::seriesIdentity(study, uid),
                                    .volume = sha256Hex("images of " + uid)};
    name_ = opened_->series + " images " + std::to_string(placeOf(series) + 1);
    stored_.clear();
    isAnswered_ = false;
    keeper_->withStore([home = this, opening = openings_, opened = *opened_,
                        id = idOf(*opened_, name_)](session::Store* store) {
        if (store == nullptr) return;
        const auto document = store->getDocument(id);
        const std::string text = document && *document ? (*document)->json : std::string();
        post(home, [home, opening, text] {
            if (opening == home->openings_) home->answer(text);
        });
        // After the answer: it waits for the disk.
        (void)store->recordOpened(opened);
    });
}

// Nothing is written before, because it would replace what a person left the last time.
void KeptImages::answer(const std::string& text) {
    isAnswered_ = true;
    const auto state = text.empty() ? std::nullopt : study::imagesStateOf(text);
    if (!state) {
        if (waiting_) timer_.start(kSoon);
        return;
    }
    waiting_.reset();
    stored_ = study::toJsonText(*state);
    Q_EMIT found(*state);
}

void KeptImages::keep(const study::ImagesState& state) {
    if (!opened_) return;
    std::string text = study::toJsonText(state);
    if (text == stored_) {
        waiting_.reset();
        return timer_.stop();
    }
    waiting_ = std::move(text);
    if (isAnswered_) timer_.start(kSoon);
}

void KeptImages::keepNow() {
    timer_.stop();
    if (!waiting_ || !opened_ || !keeper_ || !isAnswered_) return waiting_.reset();
    stored_ = *std::exchange(waiting_, {});
    keeper_->withStore([id = idOf(*opened_, name_), text = stored_](session::Store* store) {
        if (store == nullptr) return;
        if (const auto done = store->putDocument(id, kVersion, text, study::kImagesStateMembers); !done)
            log::warning("how images were left could not be stored");
    });
}

}  // namespace macula::viewer

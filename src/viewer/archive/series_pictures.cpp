#include "viewer/archive/series_pictures.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <iterator>
#include <string_view>
#include <utility>

#include "net/connect.h"
#include "viewer/archive/archive_way.h"
#include "viewer/archive/safe_picture.h"
#include "viewer/archive/series_strip.h"

namespace macula::viewer {

namespace {

// Whoever walks through the list with the keyboard asks for nothing on the way.
constexpr std::chrono::milliseconds kSelectedFor{250};
constexpr std::size_t kAtOnce = 2;
constexpr std::size_t kMostSeries = 500;  // that are shown
constexpr qsizetype kMostKeptBytes = qsizetype{16} << 20;
constexpr qsizetype kCostOfNone = 64;

// Series of these hold no images that can be drawn.
constexpr std::array<std::string_view, 16> kWithoutImages{"SR",       "PR",     "KO",  "SEG", "DOC", "REG",
                                                          "RTSTRUCT", "RTPLAN", "AU",  "ECG", "FID", "PLAN",
                                                          "RTRECORD", "ASMT",   "RWV", "HD"};

bool hasImages(const net::FoundSeries& series) {
    return std::ranges::find(kWithoutImages, series.modality) == kWithoutImages.end();
}

bool isSame(const std::optional<study::ListedStudy>& a, const std::optional<study::ListedStudy>& b) {
    if (!a || !b) return !a && !b;
    return a->archive == b->archive && a->study.studyInstanceUid == b->study.studyInstanceUid;
}

}  // namespace

SeriesPictures::SeriesPictures(SeriesStrip& strip, QObject* parent)
    : QObject(parent),
      strip_(strip),
      pictures_(kMostKeptBytes),
      finding_(this, {.ended = [this](const Result<std::vector<net::FoundSeries>>& found) { show(found); }}) {
    for (std::size_t i = 0; i < kAtOnce; ++i)
        drawing_.push_back(std::make_unique<Job>(
            this, Job::Listener{.ended = [this](const Result<Drawn>& drawn) { take(drawn); }}));
    begins_.setSingleShot(true);
    connect(&begins_, &QTimer::timeout, this, &SeriesPictures::begin);
    connect(&strip_, &SeriesStrip::viewChanged, this, &SeriesPictures::askForPictures);
}

void SeriesPictures::select(const std::optional<study::ListedStudy>& study, const net::SourceList& sources) {
    if (isSame(study, selected_)) return;
    clear();
    selected_ = study;
    sources_ = sources;
    if (selected_ && !selected_->archive.empty()) begins_.start(kSelectedFor);
}

void SeriesPictures::clear() {
    begins_.stop();
    finding_.cancel();
    for (const auto& job : drawing_) job->cancel();
    asked_.clear();
    source_.reset();
    strip_.setSeries({});
}

void SeriesPictures::forgetArchives() {
    clear();
    selected_.reset();
    archives_.clear();
    pictures_.clear();
}

std::shared_ptr<net::PictureSource> SeriesPictures::picturesOf(const std::string& archive) {
    const auto known = archives_.find(archive);
    if (known != archives_.end()) return known->second;
    const auto source = sources_->find(archive);
    if (!source) return nullptr;
    auto made = net::picturesOf(*sources_, *source);
    if (!made) return nullptr;
    return archives_[archive] = std::shared_ptr<net::PictureSource>(*std::move(made));
}

// Where the archive does not answer, the search has said so, and opening the study will.
void SeriesPictures::begin() {
    source_ = picturesOf(selected_->archive);
    if (!source_ || !source_->isOffered()) return;
    auto way = wayTo(*sources_, QString::fromStdString(selected_->archive));
    if (!way) return;
    finding_.start([way = *std::move(way), uid = selected_->study.studyInstanceUid](
                       Progress& progress) -> Result<std::vector<net::FoundSeries>> {
        MACULA_TRY(const std::unique_ptr<net::Archive> archive, way.archive());
        return archive->findSeries(uid, progress);
    });
}

void SeriesPictures::show(const Result<std::vector<net::FoundSeries>>& series) {
    if (!series) return;
    std::vector<net::FoundSeries> drawable;
    std::ranges::copy_if(*series, std::back_inserter(drawable), hasImages);
    std::ranges::stable_sort(drawable, {},
                             [](const net::FoundSeries& each) { return each.number.value_or(0); });
    if (drawable.size() > kMostSeries) drawable.resize(kMostSeries);
    strip_.setSeries(std::move(drawable));
    askForPictures();
}

QString SeriesPictures::keyOf(const net::FoundSeries& series) const {
    return QString::fromStdString(selected_->archive + "\n" + selected_->study.studyInstanceUid + "\n" +
                                  series.seriesInstanceUid);
}

void SeriesPictures::askForPictures() {
    if (!selected_ || !source_) return;
    for (const std::size_t index : strip_.inView()) {
        const net::FoundSeries& series = strip_.series()[index];
        const QString key = keyOf(series);
        if (asked_.contains(key)) continue;
        if (const QImage* known = pictures_.object(key)) {
            asked_.insert(key);
            strip_.setPicture(index, *known);
            continue;
        }
        const auto idle = std::ranges::find_if(drawing_, [](const auto& job) { return !job->running(); });
        if (idle == drawing_.end()) return;
        asked_.insert(key);
        const int edgePx = int(kSeriesPicturePx * strip_.devicePixelRatioF());
        (*idle)->start([source = source_, series, key, edgePx,
                        uid = selected_->study.studyInstanceUid](Progress& progress) -> Result<Drawn> {
            MACULA_TRY(const auto picture, source->pictureOf(uid, series, edgePx, progress));
            return Drawn{key, picture ? decodedPicture(*picture, QSize(edgePx, edgePx)) : QImage()};
        });
    }
}

void SeriesPictures::take(const Result<Drawn>& drawn) {
    if (drawn) {
        pictures_.insert(drawn->key, new QImage(drawn->picture),
                         std::max(kCostOfNone, drawn->picture.sizeInBytes()));
        const auto& series = strip_.series();
        const auto shown =
            std::ranges::find_if(series, [&](const auto& each) { return keyOf(each) == drawn->key; });
        if (shown != series.end()) strip_.setPicture(std::size_t(shown - series.begin()), drawn->picture);
    }
    if (!source_ || source_->isOffered()) return askForPictures();
    for (const auto& job : drawing_) job->cancel();
    strip_.setSeries({});  // no list of empty frames
}

}  // namespace macula::viewer

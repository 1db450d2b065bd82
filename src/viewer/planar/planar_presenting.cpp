#include "viewer/planar/planar_presenting.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "base/exceptions.h"
#include "viewer/language/harmless_text.h"

namespace macula::viewer {

PlanarPresenting::PlanarPresenting(QObject* parent)
    : QObject(parent), reading_(this, {.ended = [this](const auto& read) { take(read); }}) {}

void PlanarPresenting::setSeries(const study::FoundVolumes* found, const study::PlanarSeries& series) {
    reading_.cancel();
    listed_.clear();
    if (found != nullptr && series.stack != nullptr) listed_ = study::presentationsOf(*found, series);
    chosen_ = wanted_ = 0;
    state_.reset();
}

QStringList PlanarPresenting::names(bool withNames) const {
    if (listed_.empty()) return {};
    QStringList names{tr("As stored")};
    for (std::size_t i = 0; i < listed_.size(); ++i) {
        const study::ListedPresentation& each = listed_[i];
        QStringList words;
        if (withNames) {
            for (const std::string* word : {&each.label, &each.creator, &each.date})
                if (!word->empty()) words += harmless(QString::fromStdString(*word));
        }
        if (words.isEmpty()) words += tr("Presentation state %1").arg(i + 1);
        names += words.join(QStringLiteral(", "));
    }
    return names;
}

void PlanarPresenting::choose(int index) {
    if (index < 0 || std::size_t(index) > listed_.size()) return;
    reading_.cancel();
    wanted_ = index;
    if (index == 0) {
        chosen_ = 0;
        state_.reset();
        return Q_EMIT chosenChanged();
    }
    reading_.start([file = listed_[std::size_t(index) - 1].file](Progress&) -> Result<dicom::SoftcopyState> {
        try {
            return dicom::readSoftcopyState(file);
        } catch (const std::exception& thrown) {
            return errorOf(thrown, Text("read the presentation state"));
        }
    });
}

void PlanarPresenting::choose(const std::filesystem::path& file) {
    const auto found = std::ranges::find(listed_, file, &study::ListedPresentation::file);
    if (found != listed_.end()) choose(int(found - listed_.begin()) + 1);
}

void PlanarPresenting::take(const Result<dicom::SoftcopyState>& read) {
    if (!read) {
        wanted_ = chosen_;
        return Q_EMIT failed(read.error());
    }
    chosen_ = wanted_;
    state_ = *read;
    Q_EMIT chosenChanged();
}

}  // namespace macula::viewer

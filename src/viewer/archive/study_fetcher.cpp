#include "viewer/archive/study_fetcher.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "study/spool/spool.h"
#include "viewer/jobs/newest_posted.h"
#include "viewer/language/window_language.h"
#include "viewer/status/status_widgets.h"

namespace macula::viewer {

namespace {

bool isSame(const FetchOrder& a, const FetchOrder& b) {
    return a.study.studyInstanceUid == b.study.studyInstanceUid && a.way.source.name == b.way.source.name;
}

}  // namespace

StudyFetcher::StudyFetcher(QObject* parent)
    : QObject(parent),
      bar_(new WorkBar),
      job_(this, {.progressed = [this](const ProgressUpdate& update) { showProgress(update); },
                  .ended = [this](const Result<study::FetchedStudy>& fetched) { finish(fetched); }}) {
    connect(bar_, &WorkBar::cancelClicked, this, &StudyFetcher::cancel);
}

void StudyFetcher::fetch(FetchOrder order) {
    if (current_ && isSame(*current_, order)) {
        current_->purpose = std::min(current_->purpose, order.purpose);
        current_->besideOf = order.besideOf;
        return;
    }
    const auto same = std::ranges::find_if(waiting_, [&](const auto& each) { return isSame(each, order); });
    if (same != waiting_.end()) {
        order.purpose = std::min(order.purpose, same->purpose);
        waiting_.erase(same);
    }
    // A person who asks for another study to be shown does not wait for the one before any more.
    const bool isUrgent = order.purpose != FetchFor::keep;
    if (isUrgent && current_) {
        job_.cancel();
        FetchOrder before = *std::exchange(current_, std::nullopt);
        if (before.purpose == order.purpose) before.purpose = FetchFor::keep;
        waiting_.push_front(std::move(before));
    }
    if (isUrgent) {
        for (FetchOrder& each : waiting_) {
            if (each.purpose == order.purpose) each.purpose = FetchFor::keep;
        }
    }
    waiting_.push_back(std::move(order));
    std::ranges::stable_sort(waiting_, {}, &FetchOrder::purpose);
    startNext();
}

bool StudyFetcher::cancel() {
    if (!current_) return false;
    job_.cancel();
    current_.reset();
    std::erase_if(waiting_, [](const FetchOrder& order) { return order.purpose == FetchFor::keep; });
    bar_->hide();
    Q_EMIT cancelled();
    startNext();
    return true;
}

void StudyFetcher::startNext() {
    if (current_ || waiting_.empty()) return;
    current_ = std::move(waiting_.front());
    waiting_.pop_front();
    ++number_;
    stage_.clear();
    bar_->begin(tr("Fetching a study"));
    const NewestPosted<study::Arrival> arrivals(this,
                                                [this, number = number_](const study::Arrival& arrival) {
                                                    if (current_ && number == number_)
                                                        Q_EMIT arrived(*current_, arrival);
                                                });
    const study::FetchRequest request{.studyInstanceUid = current_->study.studyInstanceUid,
                                      .chosen = study::identityOf(current_->study)};
    job_.start([way = current_->way, request, arrivals](Progress& progress) -> Result<study::FetchedStudy> {
        MACULA_TRY(const auto archive, way.archive());
        MACULA_TRY(study::Spool spool, study::Spool::open());
        return study::fetchStudy(*archive, way.source.name, request, spool, progress, arrivals);
    });
}

void StudyFetcher::finish(const Result<study::FetchedStudy>& fetched) {
    bar_->hide();
    const FetchOrder order = *std::exchange(current_, std::nullopt);
    Q_EMIT ended(order, fetched);
    startNext();
}

void StudyFetcher::showProgress(const ProgressUpdate& update) {
    const QString stage = inWindowsLanguage(update.stage);
    if (stage != stage_) timeLeft_.begin();
    stage_ = stage;
    QString text = stage;
    if (const auto left = timeLeft_.after(update.fraction))
        text += QStringLiteral(" · ") + timeLeftText(*left);
    if (!waiting_.empty()) text += QStringLiteral(" · ") + tr("%n more", nullptr, int(waiting_.size()));
    bar_->setProgress(text, update.fraction);
}

}  // namespace macula::viewer

#include "live/frame/render_reports.h"

namespace macula::live {

namespace {

constexpr std::chrono::milliseconds kModelToldEvery{500};
constexpr std::chrono::milliseconds kTimeToldEvery{250};

}  // namespace

void RenderReports::tellOfModel(std::uint64_t study, const hybrid::ModelNews& news) {
    const Clock::time_point now = Clock::now();
    if (news == modelTold_ || (news.stage == modelTold_.stage && now - modelToldAt_ < kModelToldEvery))
        return;
    modelTold_ = news;
    modelToldAt_ = now;
    tell(ModelChanged{study, news});
}

void RenderReports::tellOfTime(const Timeline& timeline) {
    const Clock::time_point now = Clock::now();
    if (now - timeToldAt_ < kTimeToldEvery) return;
    timeToldAt_ = now;
    tell(TimeSpent{timeline.stages()});
}

}  // namespace macula::live

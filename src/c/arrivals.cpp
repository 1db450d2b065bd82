#include "c/arrivals.h"

#include <algorithm>
#include <system_error>

namespace macula::c {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::milliseconds kBetweenReports{100};
constexpr int kLeastPauseInReports = 20;  // so that counting takes a twentieth of a fetch at most

std::uint64_t bytesIn(const fs::path& folder) {
    std::uint64_t bytes = 0;
    std::error_code failure;
    for (fs::directory_iterator file(folder, failure), end; !failure && file != end;
         file.increment(failure)) {
        std::error_code gone;
        const std::uintmax_t size = file->file_size(gone);
        if (!gone) bytes += size;
    }
    return bytes;
}

}  // namespace

Arrivals::Arrivals(const macula_progress& progress, const macula_fetch& fetch)
    : progress_(progress), fetch_(fetch), inTurn_(progress) {
    if (progress.told == nullptr) return;
    inTurn_.told = tellProgress;
    inTurn_.user = this;
}

std::int32_t Arrivals::tellProgress(void* arrivals, const char* stage, double fraction) {
    auto& to = *static_cast<Arrivals*>(arrivals);
    const std::scoped_lock lock(to.mutex_);
    return to.progress_.told(to.progress_.user, stage, fraction);
}

void Arrivals::tell(const study::Arrival& arrival, const CancelToken& token) {
    for (std::size_t most = most_; most < arrival.instances;)
        if (most_.compare_exchange_weak(most, arrival.instances)) break;
    if (fetch_.arrived == nullptr) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (lock && Clock::now() >= next_) tellNow({arrival.folder, most_}, token);
}

void Arrivals::tellRest(const fs::path& folder, const CancelToken& token) {
    if (fetch_.arrived == nullptr) return;
    const std::scoped_lock lock(mutex_);
    if (most_ > told_) tellNow({folder, most_}, token);
}

void Arrivals::tellNow(const study::Arrival& arrival, const CancelToken& token) {
    const Clock::time_point begin = Clock::now();
    const std::uint64_t bytes = bytesIn(arrival.folder);
    const Clock::duration counting = Clock::now() - begin;
    told_ = arrival.instances;
    if (fetch_.arrived(fetch_.user, arrival.folder.c_str(), arrival.instances, bytes) != 0) token.cancel();
    next_ = Clock::now() + std::max<Clock::duration>(kBetweenReports, kLeastPauseInReports * counting);
}

}  // namespace macula::c

// Studies that others send to this program unasked: each instance goes to the spooled study that it is of.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/message.h"
#include "base/result.h"
#include "net/archive/reception.h"
#include "study/open/identity.h"
#include "study/spool/arriving_files.h"
#include "study/spool/spool.h"

namespace macula::study {

struct ReceptionLimits {
    // A study of which nothing has come for so long is done: nobody says how many images a study that is sent
    // has.
    std::chrono::milliseconds quiet{5000};
    // New ones that came within `counted`; older ones are forgotten, as are those of which nothing was kept.
    std::size_t mostStudies = 10'000;
    std::chrono::milliseconds counted = std::chrono::hours(24);
    std::size_t mostStudiesAtOnce = 32;  // then those that have been quiet longest are done
};

// What has come of a study since it was last done.
struct ReceivedStudy {
    std::filesystem::path folder;
    Identity identity;                 // of the first image that was taken
    std::set<std::string> modalities;  // of what came
    std::vector<std::string> senders;  // AE titles, as the senders say themselves
    std::size_t kept = 0;
    std::size_t hadAlready = 0;
    std::size_t refused = 0;        // of another patient than the rest of the study
    std::size_t otherContents = 0;  // refused: under the UID of an instance that had come with other contents
    std::size_t instances = 0;      // that are there now
    std::vector<Message> messages;  // shown with the study
};

// What is on its way.
struct ArrivingStudies {
    std::size_t studies = 0;
    std::size_t images = 0;  // of these, that came since each began

    bool operator==(const ArrivingStudies&) const = default;
};

// Keeps what SpooledStudy keeps. The record of a study says who sent it, and never that it is complete; what
// an archive has promised of it stays there. Thread-safe.
class ReceivedStudies : public net::Reception {
  public:
    // The spool outlives it. Fails with outputNotWritable.
    static Result<std::unique_ptr<ReceivedStudies>> into(Spool& spool, const ReceptionLimits& limits = {});
    ~ReceivedStudies() override;

    std::unique_ptr<net::Receiver> receiverFor(const net::Caller& caller) override;

    // Those that are done now: on the disk, with their record, and open to others. To be called again and
    // again.
    std::vector<ReceivedStudy> finishQuiet();
    // The same for all, when nobody sends any more.
    std::vector<ReceivedStudy> finishAll();

    ArrivingStudies arriving() const;

    // Refused, because their header cannot be read, or because they are not what the sender said.
    std::size_t unreadable() const { return unreadable_.load(); }
    // The last error since this was asked, such as a full disk: it concerns what was not kept.
    std::optional<Error> takeTrouble();

  private:
    using Clock = std::chrono::steady_clock;
    struct Arriving;  // a study that is open here
    class FromCaller;

    ReceivedStudies(Spool& spool, const ReceptionLimits& limits);
    Result<net::Receiver::Verdict> take(const std::filesystem::path& file, const net::InstanceKey& promised,
                                        const std::string& sender);
    Result<std::shared_ptr<Arriving>> arrivingOf(const std::string& studyInstanceUid);
    Result<void> open(Arriving& arriving, const std::string& sender);
    Result<void> countNew(Arriving& arriving);
    void finish(const std::shared_ptr<Arriving>& arriving);
    void finishOldest();
    static std::vector<Message> messagesOf(const Arriving& arriving);
    std::vector<std::shared_ptr<Arriving>> quietSince(Clock::time_point time) const;
    std::vector<ReceivedStudy> takeFinished();
    Error noted(const Error& error);

    Spool& spool_;
    const ReceptionLimits limits_;
    ArrivingFiles files_;
    mutable std::mutex mutex_;
    std::map<std::string, std::shared_ptr<Arriving>> studies_;  // by Study Instance UID
    std::deque<Clock::time_point> begun_;                       // those that count, in order
    std::vector<ReceivedStudy> finished_;
    std::optional<Error> trouble_;
    std::atomic<std::size_t> unreadable_{0};
};

}  // namespace macula::study

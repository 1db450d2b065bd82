// Instances as an archive sends them (WADO-RS), each into a file of the receiver.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <unordered_set>

#include "base/progress.h"
#include "net/archive/receiver.h"
#include "net/web/http_exchange.h"
#include "net/web/multipart_parser.h"

namespace macula::net {

// What has come so far, over all requests of a fetch.
struct FetchTally {
    Receiver& receiver;
    Progress& progress;
    Fetched fetched;
    std::unordered_set<std::string> came;  // SOP Instance UIDs, whatever the receiver said to them
    std::unordered_set<std::string> had;   // those counted as had already
};

// Of one request.
class InstanceSink final : public HttpSink, private PartSink {
  public:
    // `mostInstances`: then the archive sends what it was not asked for, and is stopped.
    InstanceSink(FetchTally& tally, InstanceKey promised, std::size_t mostInstances);
    ~InstanceSink() override;
    InstanceSink(const InstanceSink&) = delete;
    InstanceSink& operator=(const InstanceSink&) = delete;

    Result<void> begin(const HttpHead& head) override;
    Result<void> write(std::span<const std::byte> bytes) override;
    // Errors of the receiver and of the disk end the fetch, those of the archive only the request.
    bool endsAll() const override { return isReceiversError_; }

    // The answer has ended well. Whether it was whole too.
    Result<bool> finish();
    // The answer ended with an error because it is none of instances, before one had come.
    bool isStrange() const { return hasBegun_ && instances_ == 0 && !isTooLarge_ && !isReceiversError_; }

  private:
    Result<void> beginPart(const PartHeaders& headers) override;
    Result<void> partBytes(std::span<const char> bytes) override;
    Result<void> endPart() override;
    Result<void> openFile();
    Result<void> writeFile(std::span<const char> bytes);
    void dropFile() noexcept;
    Error receivers(Error error);

    FetchTally& tally_;
    InstanceKey promised_;
    std::size_t mostInstances_;
    std::optional<MultipartParser> parser_;
    std::filesystem::path file_;  // empty between files
    int descriptor_ = -1;
    std::uintmax_t bytes_ = 0;  // of the file
    bool hasBegun_ = false;
    bool isSkipped_ = false;  // a part that is no instance
    bool isTooLarge_ = false;
    bool isReceiversError_ = false;
    std::size_t instances_ = 0;
};

}  // namespace macula::net

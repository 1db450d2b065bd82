// Listens for studies that others send, and keeps them in a spool, while somebody wants it to.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "base/file_lock.h"
#include "base/result.h"
#include "net/dimse/store_provider.h"
#include "study/archive/received_studies.h"
#include "study/spool/spool.h"

namespace macula::study {

struct ReceivingOptions {
    net::StoreProviderOptions provider;
    std::filesystem::path into;  // empty: the user's private spool
    ReceptionLimits limits;
};

class Receiving {
  public:
    // Fails as StoreProvider::start and Spool::open do. Where another program of Macula has the port, the
    // error says so.
    static Result<std::unique_ptr<Receiving>> start(const ReceivingOptions& options);
    ~Receiving();  // without the studies that are not finished yet: see end()
    Receiving(const Receiving&) = delete;
    Receiving& operator=(const Receiving&) = delete;

    // Listens no more, and ends what is under way, within a second. What came so far is finished by
    // studies().finishAll().
    void end();

    ReceivedStudies& studies() { return *studies_; }
    net::StoreProvider::Counts counts() const { return provider_->counts(); }
    std::uint16_t port() const { return provider_->port(); }

  private:
    explicit Receiving(Spool spool) : spool_(std::move(spool)) {}

    // In the order in which they need each other.
    Spool spool_;
    std::unique_ptr<ReceivedStudies> studies_;
    std::unique_ptr<net::StoreProvider> provider_;
    std::optional<FileLock> lock_;  // tells other programs of Macula of this user who has the port
};

}  // namespace macula::study

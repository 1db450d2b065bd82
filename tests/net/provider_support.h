// What the tests of the storage provider share.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "net/dimse/store_provider.h"
#include "net/dimse_support.h"
#include "net/hostile_peer.h"

namespace macula::net::test {

inline constexpr const char* kCtImages = "1.2.840.10008.5.1.4.1.1.2";
inline constexpr const char* kExplicitSyntax = "1.2.840.10008.1.2.1";

// All callers' instances go to one folder.
class FolderReception : public Reception {
  public:
    explicit FolderReception(std::uintmax_t mostBytesOfInstance = std::uintmax_t{1} << 30)
        : receiver(mostBytesOfInstance) {}

    std::unique_ptr<Receiver> receiverFor(const Caller& caller) override;
    std::vector<Caller> callers() const;

    FolderReceiver receiver;

  private:
    mutable std::mutex mutex_;
    std::vector<Caller> callers_;
};

// A provider at a free port of loopback, and what it tells.
class TestedProvider {
  public:
    // Fails the test if the options are refused.
    explicit TestedProvider(StoreProviderOptions options = {});

    std::uint16_t port() const { return provider_->port(); }
    StoreProvider::Counts counts() const { return provider_->counts(); }
    void end() { provider_->end(); }
    std::vector<TurnedAway> turnedAway() const;

    FolderReception reception;

  private:
    mutable std::mutex mutex_;
    std::vector<TurnedAway> turnedAway_;
    std::unique_ptr<StoreProvider> provider_;
};

// A connection to a provider.
class ProviderCaller {
  public:
    explicit ProviderCaller(std::uint16_t port);
    ~ProviderCaller();
    ProviderCaller(const ProviderCaller&) = delete;
    ProviderCaller& operator=(const ProviderCaller&) = delete;
    HostileLine* operator->() { return &line_; }

    bool associates(const std::string& calledAe = "MACULA");
    // The request alone.
    void beginStore(const std::string& sopInstanceUid);
    // The status of the response; nothing without one.
    std::optional<std::uint16_t> store(const std::string& study, const std::string& sopInstanceUid,
                                       std::size_t pixelBytes = 0);
    // Whether the other side ends the connection within seconds, whatever it still sends.
    bool isEnded();

  private:
    int socket_;
    HostileLine line_;
};

}  // namespace macula::net::test

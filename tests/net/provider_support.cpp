#include "net/provider_support.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <utility>

namespace macula::net::test {

namespace {

class Forwarding : public Receiver {
  public:
    explicit Forwarding(Receiver& to) : to_(to) {}
    Result<std::filesystem::path> place() override { return to_.place(); }
    Result<Verdict> take(const std::filesystem::path& file, const InstanceKey& promised) override {
        return to_.take(file, promised);
    }
    void drop(const std::filesystem::path& file) noexcept override { to_.drop(file); }
    std::uintmax_t mostBytesOfInstance() const override { return to_.mostBytesOfInstance(); }

  private:
    Receiver& to_;
};

}  // namespace

std::unique_ptr<Receiver> FolderReception::receiverFor(const Caller& caller) {
    const std::lock_guard lock(mutex_);
    callers_.push_back(caller);
    return std::make_unique<Forwarding>(receiver);
}

std::vector<Caller> FolderReception::callers() const {
    const std::lock_guard lock(mutex_);
    return callers_;
}

TestedProvider::TestedProvider(StoreProviderOptions options) {
    options.port = 0;
    options.onTurnedAway = [this](const TurnedAway& each) {
        const std::lock_guard lock(mutex_);
        turnedAway_.push_back(each);
    };
    auto provider = StoreProvider::start(options, reception);
    EXPECT_TRUE(provider) << told(provider.error());
    if (provider) provider_ = std::move(*provider);
}

std::vector<TurnedAway> TestedProvider::turnedAway() const {
    const std::lock_guard lock(mutex_);
    return turnedAway_;
}

ProviderCaller::ProviderCaller(std::uint16_t port) : socket_(connectionTo(port)), line_(socket_) {
    // A provider that never answers fails the test, and does not hold it up.
    const timeval patience{30, 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
}

ProviderCaller::~ProviderCaller() {
    close(socket_);
}

bool ProviderCaller::associates(const std::string& calledAe) {
    return line_.requestAssociation(calledAe, kCtImages, kExplicitSyntax);
}

void ProviderCaller::beginStore(const std::string& sopInstanceUid) {
    line_.sendCommand(1, {.field = CommandField::storeRequest,
                          .messageId = std::uint16_t{1},
                          .sopClassUid = kCtImages,
                          .sopInstanceUid = sopInstanceUid,
                          .hasDataset = true});
}

std::optional<std::uint16_t> ProviderCaller::store(const std::string& study,
                                                   const std::string& sopInstanceUid,
                                                   std::size_t pixelBytes) {
    beginStore(sopInstanceUid);
    line_.sendFragment(
        1, false, true,
        joined({explicitElement(0x00080018, "UI", sopInstanceUid), explicitElement(0x0020000d, "UI", study),
                explicitElement(0x7fe00010, "OW", std::string(pixelBytes, 'x'))}));
    const auto response = line_.receiveCommand();
    return response ? response->command.status : std::nullopt;
}

bool ProviderCaller::isEnded() {
    char byte = 0;
    ssize_t count = 0;
    do {
        count = recv(socket_, &byte, 1, 0);
    } while (count > 0);
    return count == 0 || errno == ECONNRESET;
}

}  // namespace macula::net::test

#include "study/archive/receiving.h"

#include <fmt/format.h>

#include <utility>

#include "base/user_folder.h"
#include "net/dimse/acceptor.h"

namespace macula::study {

namespace {

FileLock lockOf(std::uint16_t port) {
    return FileLock(userDataFolder() / fmt::format("receiving-{}.lock", port));
}

// The file is there as long as somebody of this user has received at the port before.
Error whoHasThePort(const Error& error, std::uint16_t port) {
    if (!net::saysPortInUse(error) || lockOf(port).isOurs()) return error;
    return {
        error.code,
        Text("Another window of Macula, or the command macula receive, already receives at port {}.", port),
        {},
        Text("Stop receiving there, or choose another port here and where the images come from.")};
}

}  // namespace

Result<std::unique_ptr<Receiving>> Receiving::start(const ReceivingOptions& options) {
    MACULA_TRY(Spool spool, options.into.empty() ? Spool::open() : Spool::chosen(options.into));
    std::unique_ptr<Receiving> receiving(new Receiving(std::move(spool)));
    MACULA_TRY(receiving->studies_, ReceivedStudies::into(receiving->spool_, options.limits));
    auto provider = net::StoreProvider::start(options.provider, *receiving->studies_);
    if (!provider) return whoHasThePort(provider.error(), options.provider.port);
    receiving->provider_ = *std::move(provider);
    receiving->lock_.emplace(lockOf(receiving->port()));
    static_cast<void>(receiving->lock_->isOurs());
    return receiving;
}

Receiving::~Receiving() = default;

void Receiving::end() {
    provider_->end();
    lock_.reset();
}

}  // namespace macula::study

// An association (PS3.8): DCMTK speaks the upper layer protocol over a Wire. Fragments of messages come and
// go one by one, so that nothing of a peer's making is ever held whole.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "net/dimse/failures.h"
#include "net/dimse/wire.h"

namespace macula::net {

constexpr std::size_t kMostContexts = 128;

struct ProposedContext {
    std::string abstractSyntax;
    std::vector<std::string> transferSyntaxes;
    bool asProvider = false;  // this side provides the service, as for instances that C-GET sends back
};

struct AcceptedContext {
    std::uint8_t id = 0;
    std::string abstractSyntax;
    std::string transferSyntax;
};

struct AssociationTitles {
    std::string callingAe;
    std::string calledAe;
};

// How somebody is met who asks for an association.
struct Welcome {
    // Why it is rejected; nothing for who may come. Titles are without the blanks around them.
    std::function<std::optional<Rejection>(const AssociationTitles&)> judge;
    // The classes besides verification that are offered, and in which transfer syntaxes.
    std::function<bool(std::string_view abstractSyntax)> offers;
    std::function<bool(std::string_view transferSyntax)> takes;  // empty: all that Macula knows
    std::chrono::milliseconds patience{30000};  // with the whole request, however slowly it comes
};

// A rejection of who does not call `ownAe`.
std::optional<Rejection> unlessCalled(const AssociationTitles& titles, const std::string& ownAe);

// Rejects an association that nothing has been read of, and reads over a little of what comes.
void rejectUnread(Wire& wire, const Rejection& rejection);

// A fragment of a message: a part of a command, or of a dataset (PS3.8 annex E).
struct Fragment {
    std::uint8_t context = 0;
    bool isCommand = false;
    bool isLast = false;
    std::span<const unsigned char> bytes;  // valid until the next one is read
};

class Association {
  public:
    static Result<std::unique_ptr<Association>> request(std::unique_ptr<Wire> wire,
                                                        const AssociationTitles& titles,
                                                        const std::vector<ProposedContext>& contexts);
    // Takes a request from somebody who may come and asks for something that is offered, and rejects all
    // others.
    static Result<std::unique_ptr<Association>> accept(std::unique_ptr<Wire> wire, const Welcome& welcome);
    ~Association();
    Association(const Association&) = delete;
    Association& operator=(const Association&) = delete;

    const std::vector<AcceptedContext>& contexts() const { return contexts_; }
    const AcceptedContext* contextOf(std::uint8_t id) const;
    const AcceptedContext* contextFor(const std::string& abstractSyntax) const;  // the first of it
    const AcceptedContext* contextFor(const std::string& abstractSyntax,
                                      const std::string& transferSyntax) const;

    // Whether this class would have been accepted in another transfer syntax.
    bool refusesTransferSyntax(const std::string& abstractSyntax) const;

    // Waits for a fragment. After `cancelled` the association lives on, if isOpen().
    Result<Fragment> next();
    Result<void> send(const Fragment& fragment);
    bool isOpen() const { return end_ == End::none; }
    bool wasReleased() const { return end_ == End::released; }

    std::uint16_t newMessageId() { return ++lastMessageId_; }
    Wire& wire();

    // Ends in order: waits two seconds at most for the peer to agree. Without it, the association is aborted.
    void release();
    // Ends at once, as after what no archive should send.
    void abort();

  private:
    enum class End { none, released, broken };
    struct Toolkit;

    explicit Association(std::unique_ptr<Toolkit> toolkit);
    Error broken();
    void reject(const Rejection& rejection);
    void keepContexts();

    std::unique_ptr<Toolkit> toolkit_;
    std::vector<AcceptedContext> contexts_;
    std::vector<std::string> otherSyntaxWanted_;  // classes
    std::uint16_t lastMessageId_ = 0;
    End end_ = End::none;
};

}  // namespace macula::net

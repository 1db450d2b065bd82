#include "net/dimse/association.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmnet/assoc.h>
#include <dcmtk/dcmnet/cond.h>
#include <dcmtk/dcmnet/dcmlayer.h>
#include <dcmtk/dcmnet/dcmtrans.h>
#include <dcmtk/dcmnet/dul.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <mutex>
#include <utility>

#include "base/parsing.h"
#include "net/dimse/contexts.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::net {

namespace {

constexpr std::chrono::milliseconds kPatienceForRelease{2000};
constexpr std::chrono::milliseconds kPatienceForAbort{500};
constexpr std::size_t kMostBytesUnread = std::size_t{256} << 10;
constexpr int kSecondsOfToolkit = 30;  // the wire's own limits end each wait

// DCMTK reads and writes here; what is on the other side is a Wire. It owns the socket that stands in for it.
class WireConnection : public DcmTransportConnection {
  public:
    WireConnection(DcmNativeSocketType standIn, Wire& wire) : DcmTransportConnection(standIn), wire_(wire) {}
    ~WireConnection() override { closeStandIn(); }

    OFCondition serverSideHandshake() override { return EC_Normal; }
    OFCondition clientSideHandshake() override { return EC_Normal; }
    OFCondition renegotiate(const char* /*suite*/) override { return EC_IllegalCall; }
    ssize_t read(void* bytes, size_t count) override {
        const std::size_t had = wire_.read(bytes, count);
        if (had == 0) errno = ECONNRESET;  // DCMTK asks again after EINTR
        return static_cast<ssize_t>(had);
    }
    ssize_t write(void* bytes, size_t count) override {
        if (wire_.write(bytes, count)) return static_cast<ssize_t>(count);
        errno = EPIPE;
        return -1;
    }
    void close() override { closeStandIn(); }
    void closeTransportConnection() override { closeStandIn(); }
    unsigned long getPeerCertificateLength() override { return 0; }
    unsigned long getPeerCertificate(void* /*bytes*/, unsigned long /*count*/) override { return 0; }
    OFBool networkDataAvailable(int /*seconds*/) override { return wire_.waitToTheEnd(); }
    OFBool isTransparentConnection() override { return OFTrue; }
    OFString& dumpConnectionParameters(OFString& text) override { return text; }

  private:
    // At once and for good: thousands that wait for their end would use up the ports of this machine.
    void closeStandIn() {
        const linger atOnce{1, 0};
        if (getSocket() >= 0) {
            setsockopt(getSocket(), SOL_SOCKET, SO_LINGER, &atOnce, sizeof atOnce);
            ::close(getSocket());
        }
        setSocket(-1);
    }
    Wire& wire_;
};

class WireLayer : public DcmTransportLayer {
  public:
    explicit WireLayer(Wire& wire) : wire_(wire) {}
    DcmTransportConnection* createConnection(DcmNativeSocketType standIn, OFBool /*isSecure*/) override {
        return new WireConnection(standIn, wire_);
    }

  private:
    Wire& wire_;
};

// DCMTK 3.6.7 wants to connect, and to accept, by itself: over IPv4, deaf to cancelling, with a limit that is
// one for the whole process, listening at all addresses. So it gets a connection within this machine, over
// which nothing is ever sent, and a transport layer that puts the real one in its place.
class StandIn {
  public:
    StandIn() : listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t length = sizeof address;
        auto* plain = reinterpret_cast<sockaddr*>(&address);
        const bool listens = listener_ >= 0 && bind(listener_, plain, length) == 0 &&
                             listen(listener_, 4) == 0 && getsockname(listener_, plain, &length) == 0;
        if (listens) port_ = ntohs(address.sin_port);
    }
    ~StandIn() {
        if (listener_ >= 0) ::close(listener_);
    }
    StandIn(const StandIn&) = delete;
    StandIn& operator=(const StandIn&) = delete;

    std::uint16_t port() const { return port_; }  // 0: there is none
    // The end of a connection to itself; -1 if there is none.
    int accepted() const {
        const int caller = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        address.sin_port = htons(port_);
        int end = -1;
        if (::connect(caller, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0)
            end = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
        ::close(caller);
        return end;
    }

  private:
    int listener_;
    std::uint16_t port_ = 0;
};

// DCMTK makes the whole process ignore SIGPIPE from then on. The program that Macula is a part of decides
// about its signals, so its choice is put back.
OFCondition makeNetwork(T_ASC_NetworkRole role, T_ASC_Network** network) {
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    struct sigaction before {};
    sigaction(SIGPIPE, nullptr, &before);
    const OFCondition made = ASC_initializeNetwork(role, 0, kSecondsOfToolkit, network);
    sigaction(SIGPIPE, &before, nullptr);
    return made;
}

Error errorOfToolkit() {
    return archiveError(Text("This machine could not make a connection."),
                        Text("Close other programs and try again."));
}

Error errorOfWire(const Wire& wire) {
    switch (wire.trouble()) {
        case WireTrouble::cancelled:
            return cancelledError();
        case WireTrouble::timedOut:
            return noAnswer();
        case WireTrouble::closed:
            return closedMidway();
        case WireTrouble::none:
            break;
    }
    return notWhatDicomSays();
}

}  // namespace

// Destroyed in the order that DCMTK needs.
struct Association::Toolkit {
    explicit Toolkit(std::unique_ptr<Wire> theWire) : wire(std::move(theWire)), layer(*wire) {}
    ~Toolkit() {
        if (association != nullptr) ASC_destroyAssociation(&association);
        if (network != nullptr) ASC_dropNetwork(&network);
    }
    std::unique_ptr<Wire> wire;
    WireLayer layer;
    T_ASC_Network* network = nullptr;
    T_ASC_Association* association = nullptr;
};

Association::Association(std::unique_ptr<Toolkit> toolkit) : toolkit_(std::move(toolkit)) {}

Association::~Association() {
    const QuietToolkit quiet;
    abort();
    toolkit_.reset();
}

void Association::abort() {
    if (end_ != End::none) return;
    const QuietToolkit quiet;
    toolkit_->wire->finishWithin(kPatienceForAbort);
    ASC_abortAssociation(toolkit_->association);
    end_ = End::broken;
}

Wire& Association::wire() {
    return *toolkit_->wire;
}

namespace {

// Frees the parameters if no association took them over.
class Parameters {
  public:
    Parameters() { ASC_createAssociationParameters(&parameters_, ASC_MAXIMUMPDUSIZE); }
    ~Parameters() {
        if (parameters_ != nullptr) ASC_destroyAssociationParameters(&parameters_);
    }
    Parameters(const Parameters&) = delete;
    Parameters& operator=(const Parameters&) = delete;
    T_ASC_Parameters* get() const { return parameters_; }
    void release() { parameters_ = nullptr; }

  private:
    T_ASC_Parameters* parameters_ = nullptr;
};

bool propose(T_ASC_Parameters* parameters, const std::vector<ProposedContext>& contexts) {
    unsigned id = 1;
    for (const ProposedContext& context : contexts) {
        std::vector<const char*> syntaxes;
        for (const std::string& syntax : context.transferSyntaxes) syntaxes.push_back(syntax.c_str());
        const OFCondition added = ASC_addPresentationContext(
            parameters, static_cast<T_ASC_PresentationContextID>(id), context.abstractSyntax.c_str(),
            syntaxes.data(), static_cast<int>(syntaxes.size()),
            context.asProvider ? ASC_SC_ROLE_SCP : ASC_SC_ROLE_DEFAULT);
        if (added.bad()) return false;
        id += 2;
    }
    return true;
}

}  // namespace

Result<std::unique_ptr<Association>> Association::request(std::unique_ptr<Wire> wire,
                                                          const AssociationTitles& titles,
                                                          const std::vector<ProposedContext>& contexts) {
    MACULA_CHECK_LE(contexts.size(), kMostContexts);
    const QuietToolkit quiet;
    auto toolkit = std::make_unique<Toolkit>(std::move(wire));
    const StandIn standIn;
    Parameters parameters;
    if (standIn.port() == 0 || parameters.get() == nullptr ||
        makeNetwork(NET_REQUESTOR, &toolkit->network).bad() ||
        ASC_setTransportLayer(toolkit->network, &toolkit->layer, 0).bad() ||
        !propose(parameters.get(), contexts))
        return errorOfToolkit();
    ASC_setAPTitles(parameters.get(), titles.callingAe.c_str(), titles.calledAe.c_str(), nullptr);
    ASC_setPresentationAddresses(parameters.get(), "localhost",
                                 fmt::format("127.0.0.1:{}", standIn.port()).c_str());
    const OFCondition requested =
        ASC_requestAssociation(toolkit->network, parameters.get(), &toolkit->association);
    if (requested == DUL_ASSOCIATIONREJECTED) {
        T_ASC_RejectParameters rejected{};
        ASC_getRejectParameters(parameters.get(), &rejected);
        if (toolkit->association != nullptr) parameters.release();
        return errorOfRejection(
            {static_cast<unsigned>(rejected.result), static_cast<unsigned>(rejected.source),
             static_cast<unsigned>(rejected.reason) & 0xffu},
            titles.callingAe, titles.calledAe);
    }
    if (toolkit->association != nullptr) parameters.release();  // it has them now
    if (requested.bad()) {
        const WireTrouble trouble = toolkit->wire->trouble();
        return trouble == WireTrouble::closed ? closedAtOnce() : errorOfWire(*toolkit->wire);
    }
    std::unique_ptr<Association> association(new Association(std::move(toolkit)));
    association->keepContexts();
    return association;
}

void Association::keepContexts() {
    T_ASC_Parameters* parameters = toolkit_->association->params;
    const int count = ASC_countPresentationContexts(parameters);
    for (int i = 0; i < count; ++i) {
        T_ASC_PresentationContext context{};
        if (ASC_getPresentationContext(parameters, i, &context).bad()) continue;
        if (context.resultReason == ASC_P_TRANSFERSYNTAXESNOTSUPPORTED)
            otherSyntaxWanted_.emplace_back(context.abstractSyntax);
        if (context.resultReason != ASC_P_ACCEPTANCE) continue;
        // A peer may name one that it was not offered.
        bool wasOffered = false;
        for (int j = 0; j < context.transferSyntaxCount; ++j)
            wasOffered |=
                std::string_view(context.proposedTransferSyntaxes[j]) == context.acceptedTransferSyntax;
        if (wasOffered)
            contexts_.push_back(
                {context.presentationContextID, context.abstractSyntax, context.acceptedTransferSyntax});
    }
}

namespace {

// For DCMTK's handle of a connection that somebody else accepted, which is one for the whole process.
std::mutex& externalHandleMutex() {
    static std::mutex mutex;
    return mutex;
}

class AcceptingLayer : public WireLayer {
  public:
    AcceptingLayer(Wire& wire, std::unique_lock<std::mutex>& lock) : WireLayer(wire), lock_(lock) {}
    DcmTransportConnection* createConnection(DcmNativeSocketType standIn, OFBool isSecure) override {
        dcmExternalSocketHandle.set(DCMNET_INVALID_SOCKET);
        lock_.unlock();
        return WireLayer::createConnection(standIn, isSecure);
    }

  private:
    std::unique_lock<std::mutex>& lock_;
};

bool offers(const Welcome& welcome, std::string_view abstractSyntax) {
    return abstractSyntax == kVerification || welcome.offers(abstractSyntax);
}

bool accepts(const Welcome& welcome, T_ASC_Parameters* parameters, const T_ASC_PresentationContext& context) {
    const bool isOffered = offers(welcome, context.abstractSyntax);
    // An archive that reports storage commitment proposes to stay the provider (PS3.4 J.3.3).
    const T_ASC_SC_ROLE role =
        std::string_view(context.abstractSyntax) == kCommitment ? context.proposedRole : ASC_SC_ROLE_DEFAULT;
    for (int i = 0; isOffered && i < context.transferSyntaxCount; ++i) {
        const char* syntax = context.proposedTransferSyntaxes[i];
        if (welcome.takes ? welcome.takes(syntax) : knowsTransferSyntax(syntax))
            return ASC_acceptPresentationContext(parameters, context.presentationContextID, syntax, role)
                .good();
    }
    ASC_refusePresentationContext(
        parameters, context.presentationContextID,
        isOffered ? ASC_P_TRANSFERSYNTAXESNOTSUPPORTED : ASC_P_ABSTRACTSYNTAXNOTSUPPORTED);
    return false;
}

AssociationTitles titlesOf(T_ASC_Parameters* parameters) {
    char calling[DUL_LEN_TITLE + 1] = {};
    char called[DUL_LEN_TITLE + 1] = {};
    ASC_getAPTitles(parameters, calling, sizeof calling, called, sizeof called, nullptr, 0);
    return {std::string(trimmed(calling)), std::string(trimmed(called))};
}

}  // namespace

std::optional<Rejection> unlessCalled(const AssociationTitles& titles, const std::string& ownAe) {
    if (titles.calledAe == ownAe) return {};
    return Rejection{.result = 1, .source = 1, .reason = 7};
}

void rejectUnread(Wire& wire, const Rejection& rejection) {
    wire.finishWithin(kPatienceForAbort);
    const unsigned char pdu[] = {3,
                                 0,
                                 0,
                                 0,
                                 0,
                                 4,
                                 0,
                                 static_cast<unsigned char>(rejection.result),
                                 static_cast<unsigned char>(rejection.source),
                                 static_cast<unsigned char>(rejection.reason)};
    if (!wire.write(pdu, sizeof pdu)) return;
    // Closing over unread bytes would take the rejection back before the peer has read it.
    std::array<unsigned char, 4096> unread;
    for (std::size_t count = 0; count < kMostBytesUnread;) {
        const std::size_t had = wire.read(unread.data(), unread.size());
        if (had == 0) return;
        count += had;
    }
}

Result<std::unique_ptr<Association>> Association::accept(std::unique_ptr<Wire> wire, const Welcome& welcome) {
    const QuietToolkit quiet;
    auto toolkit = std::make_unique<Toolkit>(std::move(wire));
    const StandIn standIn;
    const int end = standIn.accepted();
    if (end < 0) return errorOfToolkit();
    toolkit->wire->setEnd(Wire::Clock::now() + welcome.patience);
    OFCondition received;
    {
        std::unique_lock lock(externalHandleMutex());
        AcceptingLayer layer(*toolkit->wire, lock);
        dcmExternalSocketHandle.set(end);
        received = makeNetwork(NET_ACCEPTOR, &toolkit->network);
        if (received.good()) received = ASC_setTransportLayer(toolkit->network, &layer, 0);
        if (received.good())
            received = ASC_receiveAssociation(toolkit->network, &toolkit->association, ASC_MAXIMUMPDUSIZE);
        if (lock.owns_lock()) {  // it came to no connection
            dcmExternalSocketHandle.set(DCMNET_INVALID_SOCKET);
            ::close(end);
        }
        if (toolkit->network != nullptr) ASC_setTransportLayer(toolkit->network, &toolkit->layer, 0);
    }
    if (received.bad()) return errorOfWire(*toolkit->wire);
    toolkit->wire->setEnd({});
    T_ASC_Parameters* parameters = toolkit->association->params;
    std::optional<Rejection> rejection = welcome.judge(titlesOf(parameters));
    std::size_t acceptedCount = 0;
    const int count = ASC_countPresentationContexts(parameters);
    for (int i = 0; i < count && !rejection; ++i) {
        T_ASC_PresentationContext context{};
        if (ASC_getPresentationContext(parameters, i, &context).good() &&
            accepts(welcome, parameters, context))
            ++acceptedCount;
    }
    if (!rejection && acceptedCount == 0) rejection = Rejection{};
    std::unique_ptr<Association> association(new Association(std::move(toolkit)));
    if (rejection) {
        association->reject(*rejection);
        return notWhatDicomSays();
    }
    if (ASC_acknowledgeAssociation(association->toolkit_->association).bad()) {
        association->end_ = End::broken;
        return errorOfWire(association->wire());
    }
    association->keepContexts();
    return association;
}

void Association::reject(const Rejection& rejection) {
    // DCMTK's constants hold the source in their upper byte, where the code of a reason has it twice.
    const T_ASC_RejectParameters native{
        static_cast<T_ASC_RejectParametersResult>(rejection.result),
        static_cast<T_ASC_RejectParametersSource>(rejection.source),
        static_cast<T_ASC_RejectParametersReason>(rejection.source << 8 | rejection.reason)};
    wire().finishWithin(kPatienceForAbort);
    ASC_rejectAssociation(toolkit_->association, &native);
    end_ = End::broken;
}

const AcceptedContext* Association::contextOf(std::uint8_t id) const {
    const auto found = std::ranges::find(contexts_, id, &AcceptedContext::id);
    return found == contexts_.end() ? nullptr : &*found;
}

const AcceptedContext* Association::contextFor(const std::string& abstractSyntax) const {
    const auto found = std::ranges::find(contexts_, abstractSyntax, &AcceptedContext::abstractSyntax);
    return found == contexts_.end() ? nullptr : &*found;
}

const AcceptedContext* Association::contextFor(const std::string& abstractSyntax,
                                               const std::string& transferSyntax) const {
    const auto found = std::ranges::find_if(contexts_, [&](const AcceptedContext& each) {
        return each.abstractSyntax == abstractSyntax && each.transferSyntax == transferSyntax;
    });
    return found == contexts_.end() ? nullptr : &*found;
}

bool Association::refusesTransferSyntax(const std::string& abstractSyntax) const {
    return std::ranges::find(otherSyntaxWanted_, abstractSyntax) != otherSyntaxWanted_.end();
}

Error Association::broken() {
    end_ = End::broken;
    return errorOfWire(*toolkit_->wire);
}

Result<Fragment> Association::next() {
    if (end_ != End::none) return closedMidway();
    const QuietToolkit quiet;
    DUL_ASSOCIATIONKEY** key = &toolkit_->association->DULassociation;
    DUL_PDV fragment{};
    OFCondition read = DUL_NextPDV(key, &fragment);
    if (read.bad()) {
        const WireTrouble trouble = toolkit_->wire->wait();
        if (trouble == WireTrouble::cancelled && toolkit_->wire->trouble() == WireTrouble::none)
            return cancelledError();
        if (trouble != WireTrouble::none) return broken();
        read = DUL_ReadPDVs(key, nullptr, DUL_BLOCK, 0);
        if (read == DUL_PEERREQUESTEDRELEASE) {
            toolkit_->wire->finishWithin(kPatienceForRelease);
            ASC_acknowledgeRelease(toolkit_->association);
            end_ = End::released;
            return closedMidway();
        }
        if (read == DUL_PEERABORTEDASSOCIATION && toolkit_->wire->trouble() == WireTrouble::none) {
            end_ = End::broken;
            return closedMidway();
        }
        // DCMTK answers a PDU that has no place here with A-ABORT, and calls that a success.
        if (read.good() && read != DUL_PDATAPDUARRIVED) {
            end_ = End::broken;
            return notWhatDicomSays();
        }
        if (read == DUL_PDATAPDUARRIVED) read = DUL_NextPDV(key, &fragment);
    }
    if (read.bad()) return broken();
    return Fragment{fragment.presentationContextID,
                    fragment.pdvType == DUL_COMMANDPDV,
                    fragment.lastPDV == OFTrue,
                    {static_cast<const unsigned char*>(fragment.data), fragment.fragmentLength}};
}

Result<void> Association::send(const Fragment& fragment) {
    if (end_ != End::none) return closedMidway();
    const QuietToolkit quiet;
    DUL_PDV native{};
    native.fragmentLength = fragment.bytes.size();
    native.presentationContextID = fragment.context;
    native.pdvType = fragment.isCommand ? DUL_COMMANDPDV : DUL_DATASETPDV;
    native.lastPDV = fragment.isLast ? OFTrue : OFFalse;
    native.data = const_cast<unsigned char*>(fragment.bytes.data());
    DUL_PDVLIST list{};
    list.count = 1;
    list.pdv = &native;
    if (DUL_WritePDVs(&toolkit_->association->DULassociation, &list).good()) return {};
    return broken();
}

void Association::release() {
    if (end_ != End::none) return;
    const QuietToolkit quiet;
    if (!toolkit_->wire->isFinishing()) toolkit_->wire->finishWithin(kPatienceForRelease);
    ASC_releaseAssociation(toolkit_->association);
    end_ = End::released;
}

}  // namespace macula::net

#include "net/dimse/connection_test.h"

#include <utility>

#include "net/dimse/contexts.h"
#include "net/dimse/messages.h"
#include "net/dimse/move_receiver.h"

namespace macula::net {

namespace {

class Steps {
  public:
    void passed(Text name, Text detail) { steps_.push_back({std::move(name), true, std::move(detail), {}}); }
    std::vector<TestStep> failed(Text name, const Error& error) {
        steps_.push_back({std::move(name), false, error.message, error.hint});
        return std::move(steps_);
    }
    std::vector<TestStep> done() { return std::move(steps_); }

  private:
    std::vector<TestStep> steps_;
};

Result<void> echo(Association& association) {
    const AcceptedContext* context = association.contextFor(std::string(kVerification));
    if (context == nullptr) return serviceNotOffered(Service::echo);
    const std::uint16_t messageId = association.newMessageId();
    MACULA_TRY_VOID(sendCommand(association, context->id,
                                {.field = CommandField::echoRequest,
                                 .messageId = messageId,
                                 .sopClassUid = std::string(kVerification)}));
    MACULA_TRY(const ReceivedCommand received, receiveCommand(association));
    const Command& response = received.command;
    if (response.field != CommandField::echoResponse || response.respondsTo != messageId ||
        response.hasDataset || !response.status)
        return notWhatDicomSays();
    if (*response.status != 0) return errorOfStatus(Service::echo, *response.status);
    return {};
}

// By which way instances would come; what would have to be set up if by none.
Result<Text> wayOfFetching(const Association& association, const DimsePeer& peer) {
    const auto offers = [&](Service service) {
        return association.contextFor(std::string(modelOf(service, peer.patientRoot))) != nullptr;
    };
    if (peer.retrieve != Retrieve::move) {
        if (offers(Service::get)) return Text("Images come over the same connection (C-GET).");
        if (peer.retrieve == Retrieve::get || !offers(Service::move)) return serviceNotOffered(Service::get);
    }
    if (!offers(Service::move)) return serviceNotOffered(Service::move);
    if (peer.receiverPort == 0)
        return archiveError(
            Text("The archive can only send to a receiver, and this program has none set up."),
            Text("Enter a receiver's port in the settings of the archive, and ask the administrator of the "
                 "archive to add the receiver's AE title with the host name and this port of this machine."));
    return Text("The archive sends images to {} at port {} of this machine (C-MOVE).", receiverTitle(peer),
                peer.receiverPort);
}

}  // namespace

std::vector<TestStep> testConnection(const Connector& connector, Progress& progress) {
    const DimsePeer& peer = connector.peer();
    const CancelToken& cancel = progress.token();
    Steps steps;
    progress.beginStage(Text("Testing the connection"), 1);

    const Text hostName("Host name");
    const Result<std::vector<WireAddress>> addresses = connector.findHost(cancel);
    if (!addresses) return steps.failed(hostName, addresses.error());
    steps.passed(hostName, Text("The host name is known."));

    const Text port("Port");
    Result<std::unique_ptr<Wire>> wire = connector.connect(*addresses, cancel);
    if (!wire) return steps.failed(port, wire.error());
    steps.passed(port, Text("Somebody answers at port {}.", peer.port));

    if (peer.tls.isOn) {
        const Text tls("Protected connection");
        const Result<void> isProtected = connector.protect(**wire);
        if (!isProtected) return steps.failed(tls, isProtected.error());
        steps.passed(tls, Text("The connection is encrypted, and the archive's certificate is trusted."));
    }

    const Text titles("AE titles");
    const Result<std::unique_ptr<Association>> association =
        connector.associate(std::move(*wire), {plainContext(kVerification),
                                               plainContext(modelOf(Service::find, peer.patientRoot)),
                                               plainContext(modelOf(Service::get, peer.patientRoot)),
                                               plainContext(modelOf(Service::move, peer.patientRoot))});
    if (!association) return steps.failed(titles, association.error());
    steps.passed(titles, Text("The archive accepts {} as the AE title of this program.", peer.callingAe));

    const Text answer("Answer");
    const Result<void> echoed = echo(**association);
    if (!echoed) return steps.failed(answer, echoed.error());
    steps.passed(answer, Text("The archive answers."));

    const Text search("Search");
    const bool offersFind =
        (*association)->contextFor(std::string(modelOf(Service::find, peer.patientRoot))) != nullptr;
    if (!offersFind) {
        (*association)->release();
        return steps.failed(search, serviceNotOffered(Service::find));
    }
    steps.passed(search, Text("The archive lets this program search."));

    const Text retrieval("Retrieval");
    const Result<Text> way = wayOfFetching(**association, peer);
    (*association)->release();
    if (!way) return steps.failed(retrieval, way.error());
    steps.passed(retrieval, *way);
    progress.advance();
    return steps.done();
}

}  // namespace macula::net

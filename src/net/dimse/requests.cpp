#include "net/dimse/requests.h"

namespace macula::net {

namespace {

void answerEcho(Association& association, const ReceivedCommand& request) {
    const Command response{.field = CommandField::echoResponse,
                           .respondsTo = request.command.messageId,
                           .sopClassUid = request.command.sopClassUid,
                           .status = std::uint16_t{0}};
    static_cast<void>(sendCommand(association, request.context, response));
}

}  // namespace

void answerRequests(Association& association, const std::function<bool(const ReceivedCommand&)>& handle) {
    while (true) {
        const Result<ReceivedCommand> request = receiveCommand(association);
        if (!request) return;
        if (request->command.field == CommandField::echoRequest)
            answerEcho(association, *request);
        else if (!handle(*request))
            return;
    }
}

}  // namespace macula::net

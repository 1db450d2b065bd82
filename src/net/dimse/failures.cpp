#include "net/dimse/failures.h"

#include <fmt/format.h>

#include <cerrno>

namespace macula::net {

Error archiveError(Text message, Text hint) {
    return {ErrorCode::archiveNotUsable, std::move(message), {}, std::move(hint)};
}

Error cancelledError() {
    return {ErrorCode::cancelled, Text("Stopped."), {}, {}};
}

Error cancelledSending(std::size_t stored, std::size_t all) {
    return {ErrorCode::cancelled,
            Text("{} of {} files were stored before this was cancelled.", stored, all),
            {},
            {}};
}

Error unknownHost() {
    return archiveError(Text("No machine is known by the host name of this archive."),
                        Text("Check how the host name is written, or enter the archive's IP address."));
}

Error connectionRefused() {
    return archiveError(Text("The archive's machine is there, but nothing answers at this port."),
                        Text("Check the port number, and ask the administrator of the archive whether its "
                             "DICOM service is on."));
}

Error hostUnreachable() {
    return archiveError(Text("The archive's machine cannot be reached from here."),
                        Text("Check the host name and the network, or whether a VPN is needed."));
}

Error noAnswerToConnection() {
    return archiveError(Text("The archive's machine did not answer in time."),
                        Text("Check host name and port. A firewall in between may block this port."));
}

Error noAnswer() {
    return archiveError(Text("The archive took the connection and then did not answer in time."),
                        Text("Try again later. If the archive is only slow, allow it more time."));
}

Error closedMidway() {
    return archiveError(
        Text("The archive closed the connection before it was done."),
        Text("Try again. If this goes on, ask the administrator of the archive what its log says."));
}

Error closedAtOnce() {
    return archiveError(Text("The archive closed the connection without an answer."),
                        Text("Check whether this port expects TLS, and whether it is that of the archive's "
                             "DICOM service."));
}

Error notWhatDicomSays() {
    return archiveError(
        Text("What answered does not speak DICOM as the standard says."),
        Text("Check that the port is that of the archive's DICOM service, and whether it expects TLS."));
}

Error errorOfConnecting(int code) {
    switch (code) {
        case ECONNREFUSED:
            return connectionRefused();
        case ETIMEDOUT:
            return noAnswerToConnection();
        case ECONNRESET:
        case EPIPE:
            return closedMidway();
        default:
            return hostUnreachable();
    }
}

Error errorOfRejection(const Rejection& rejection, const std::string& callingAe,
                       const std::string& calledAe) {
    // A number for source and reason together, as 107 for a called AE title that is not recognised.
    switch (rejection.source * 100 + rejection.reason) {
        case 102:
            return archiveError(
                Text("The archive does not know the kind of connection that DICOM prescribes."),
                Text("Check that the port is that of the archive's DICOM service."));
        case 103:
            return archiveError(Text("The archive does not know this program by the AE title {}.", callingAe),
                                Text("Ask the administrator of the archive to add this AE title with the "
                                     "address of this machine, or enter the title that is known there."));
        case 107:
            return archiveError(
                Text("The archive does not go by the AE title {}.", calledAe),
                Text("Ask the administrator of the archive for its AE title. Capitals matter."));
        case 202:
            return archiveError(Text("The archive does not speak this version of the DICOM protocol."),
                                Text("Check that the port is that of the archive's DICOM service."));
        case 301:
            return archiveError(Text("The archive is busy and takes no more connections now."),
                                Text("Try again in a few minutes."));
        case 302:
            return archiveError(Text("The archive has as many connections as it allows."),
                                Text("Try again when others have ended theirs, or ask the administrator of "
                                     "the archive to allow more."));
        default:
            break;
    }
    if (rejection.result == 2)
        return archiveError(Text("The archive refused the connection temporarily, and gave no reason."),
                            Text("Try again in a few minutes."));
    return archiveError(
        Text("The archive refused the connection without a reason."),
        Text("Check both AE titles, and ask the administrator of the archive what its log says."));
}

bool isPending(std::uint16_t status) {
    return status == 0xff00 || status == 0xff01;
}

bool isWarning(std::uint16_t status) {
    return (status & 0xf000u) == 0xb000u || status == 0x0001 || status == 0x0107 || status == 0x0116;
}

namespace {

Error errorOfStoring(std::uint16_t status, const std::string& code) {
    if ((status & 0xff00u) == 0xa700u)
        return archiveError(
            Text("The archive has no room for this instance, or cannot use it (status {}).", code),
            Text("Ask the administrator of the archive what its log says, then send again."));
    if ((status & 0xff00u) == 0xa900u)
        return archiveError(
            Text("The archive says that this instance does not fit its own kind (status {}).", code),
            Text("The file may be damaged or against the standard. Ask the administrator of the archive."));
    return archiveError(Text("The archive could not take this instance (status {}).", code),
                        Text("Ask the administrator of the archive what its log says."));
}

Error errorOfResources(Service service, std::uint16_t status, const std::string& code) {
    if (status == 0xa701)
        return archiveError(
            Text("The archive lacks the means to find out how much matches (status {}).", code),
            Text("Ask for less at once, or try again later."));
    if (status == 0xa702)
        return archiveError(
            Text("The archive could not send the instances (status {}).", code),
            service == Service::move
                ? Text("Check that the archive knows host and port of this program's receiver, "
                       "and that no firewall blocks them.")
                : Text("Try again later, or ask the administrator of the archive what its log says."));
    return archiveError(Text("The archive lacks the means to do this now (status {}).", code),
                        Text("Ask for less at once, or try again later."));
}

}  // namespace

Error errorOfStatus(Service service, std::uint16_t status) {
    const std::string code = fmt::format("{:04X}", status);
    switch (status) {
        case 0xa801:
            return archiveError(
                Text("The archive does not know the AE title of this program's receiver (status {}).", code),
                Text("Ask the administrator of the archive to add the receiver's AE title with the host name "
                     "and the port of this machine."));
        case 0x0122:
            return archiveError(
                Text("The archive does not offer this service (status {}).", code),
                Text("Ask the administrator of the archive to switch it on for this program."));
        case 0x0124:
            return archiveError(Text("The archive does not allow this program to do this (status {}).", code),
                                Text("Ask the administrator of the archive for the right to do this."));
        case 0xfe00:
            return archiveError(Text("The archive stopped by itself (status {}).", code), Text("Try again."));
        case 0x0210:
        case 0x0211:
        case 0x0212:
            return archiveError(Text("The archive did not understand the request (status {}).", code),
                                Text("Ask the administrator of the archive what its log says."));
        default:
            break;
    }
    if (service == Service::store) return errorOfStoring(status, code);
    if ((status & 0xff00u) == 0xa700u) return errorOfResources(service, status, code);
    if (status == 0xa900)
        return archiveError(Text("The archive cannot search by what was asked (status {}).", code),
                            Text("Leave out some fields, or try the patient root model in the settings."));
    if ((status & 0xf000u) == 0xc000u)
        return archiveError(
            Text("The archive could not process the request (status {}).", code),
            Text("Ask for something simpler, or ask the administrator of the archive what its log says."));
    return archiveError(Text("The archive failed for a reason of its own (status {}).", code),
                        Text("Try again, or ask the administrator of the archive what its log says."));
}

Error errorOfCommitment(std::uint16_t reason) {
    const std::string code = fmt::format("{:04X}", reason);
    switch (reason) {
        case 0x0112:
            return archiveError(Text("The archive does not have this object (reason {}).", code),
                                Text("Send it again."));
        case 0x0119:
            return archiveError(
                Text("The archive has this object as one of another kind (reason {}).", code),
                Text("Ask the administrator of the archive what it has under this identity."));
        case 0x0122:
            return archiveError(
                Text("The archive does not promise to keep objects of this kind (reason {}).", code),
                Text("Ask the administrator of the archive where such objects are kept."));
        case 0x0131:
            return archiveError(
                Text("The archive took the request for one that it had before (reason {}).", code),
                Text("Ask it again."));
        case 0x0213:
            return archiveError(Text("The archive has no room to keep this object (reason {}).", code),
                                Text("Ask the administrator of the archive to make room, then send again."));
        default:
            break;
    }
    return archiveError(Text("The archive does not promise to keep this object (reason {}).", code),
                        Text("Ask the administrator of the archive what its log says."));
}

Error serviceNotOffered(Service service) {
    switch (service) {
        case Service::find:
            return archiveError(Text("The archive does not let this program search."),
                                Text("Ask the administrator of the archive to allow C-FIND for this AE "
                                     "title, or try the other query model in the settings."));
        case Service::get:
            return archiveError(
                Text("The archive does not let this program fetch over its own connection."),
                Text("Ask the administrator of the archive to allow C-GET for this AE title, or set up a "
                     "receiver's port here, and its AE title, host and port in the archive."));
        case Service::move:
            return archiveError(
                Text("The archive does not let this program ask for instances to be sent."),
                Text("Ask the administrator of the archive to allow C-MOVE for this AE title."));
        case Service::store:
            return archiveError(
                Text("The archive takes no instances of this kind."),
                Text("Ask the administrator of the archive to allow storing for this AE title."));
        case Service::commit:
            return archiveError(
                Text("The archive does not confirm what it keeps: it does not offer storage commitment."),
                Text("Ask the administrator of the archive whether it offers it to this AE title, or search "
                     "the archive for what was stored."));
        case Service::echo:
            break;
    }
    return archiveError(Text("The archive does not answer to a test of the connection."),
                        Text("Ask the administrator of the archive to allow C-ECHO for this AE title."));
}

}  // namespace macula::net

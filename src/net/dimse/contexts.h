// What is proposed when an association is made: SOP classes and transfer syntaxes (PS3.6 annex A).
#pragma once

#include <array>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "net/dimse/association.h"
#include "net/dimse/failures.h"

namespace macula::net {

inline constexpr std::string_view kVerification = "1.2.840.10008.1.1";
// Storage Commitment Push Model (PS3.4 annex J), and its one instance.
inline constexpr std::string_view kCommitment = "1.2.840.10008.1.20.1";
inline constexpr std::string_view kCommitmentInstance = "1.2.840.10008.1.20.1.1";
inline constexpr std::string_view kExplicitLittleEndian = "1.2.840.10008.1.2.1";
inline constexpr std::string_view kImplicitLittleEndian = "1.2.840.10008.1.2";
inline constexpr std::string_view kExplicitBigEndian = "1.2.840.10008.1.2.2";
inline constexpr std::string_view kDeflated = "1.2.840.10008.1.2.1.99";

// Whether instances in this transfer syntax are accepted and written: those that Macula reads, and those of
// which it says what they are.
bool knowsTransferSyntax(std::string_view uid);
// Some of these: those of pixels without compression, or the others.
enum class Encodings { any, plain, compressed };
bool isAmong(Encodings encodings, std::string_view transferSyntaxUid);
bool isStorageClass(std::string_view uid);

// The SOP class of a query or retrieval, in the study root or the patient root model.
std::string_view modelOf(Service service, bool patientRoot);

// For commands and identifiers.
ProposedContext plainContext(std::string_view abstractSyntax);
// For instances of these classes that C-GET brings: of each class, one context for each transfer syntax, so
// that the archive need not change one, and fewer where more would be above `most`.
std::vector<ProposedContext> contextsToReceive(const std::set<std::string>& classes, std::size_t most,
                                               Encodings encodings = Encodings::any);
// The classes of images, and of what accompanies them, of an archive that does not say which it has.
std::set<std::string> usualClasses(const std::set<std::string>& modalities);

}  // namespace macula::net

// Seeds of what archives send, over the web and by DIMSE.
#include <vector>

#include "fuzz/seeds.h"
#include "net/dimse/command.h"
#include "net/dimse/contexts.h"
#include "net/dimse/identifier.h"

namespace macula::fuzz {

namespace {

const std::string kMetaBegin = std::string(128, '\0') + "DICM";

void writeMultipartSeeds(const std::filesystem::path& folder) {
    const std::string type = "multipart/related; type=\"application/dicom\"; boundary=";
    save(folder / "two", std::string("\x05") + type +
                             "B\n--B\r\nContent-Type: application/dicom\r\n\r\none\r\n" +
                             "--B\r\nContent-Length: 3\r\n\r\ntwo\r\n--B--\r\n");
    save(folder / "quoted", std::string("\x01") + type +
                                "\"a b\\\"c\"\nbefore\r\n--a b\"c \t\r\nX: y\r\n z\r\n\r\n" +
                                "\r\n--a b\r\n--a b\"c--after");
    save(folder / "empty", std::string("\x02") + type + "B\n--B\r\n\r\n--B\r\n\r\n\r\n--B--");
    save(folder / "cut", std::string("\x60") + type + "B\n\r\n--B\r\n\r\n\r\r\n-\r\n--b\r\n--B-x\r\n--B");
    save(folder / "not", std::string("\x03") + "application/dicom\nDICM");
}

void writeQidoSeeds(const std::filesystem::path& folder) {
    save(
        folder / "studies",
        R"([{"00080020":{"vr":"DA","Value":["20200102"]},"00080061":{"vr":"CS","Value":["CT","SR"]},)"
        R"("00100010":{"vr":"PN","Value":[{"Alphabetic":"A^B","Ideographic":"i","Phonetic":"p"}]},)"
        R"("0020000D":{"vr":"UI","Value":["1.2.3"]},"00201208":{"vr":"IS","Value":[57]}},{"0020000D":"1.4"}])");
    save(folder / "series",
         R"([{"00080060":{"vr":"CS","Value":["MR"]},"0020000E":{"vr":"UI","Value":["1.5"]},)"
         R"("00200011":{"vr":"IS","Value":["-3"]},"00201209":{"vr":"IS","Value":[12.0]}}])");
    save(folder / "instances",
         R"([{"00080016":{"vr":"UI","Value":["1.7"]},"00080018":{"vr":"UI","Value":["1.8"]},)"
         R"("0020000E":{"vr":"UI","Value":[null,"1.5"]},"00200013":{"vr":"IS","Value":9}}])");
    save(
        folder / "stow",
        R"({"00081199":{"vr":"SQ","Value":[{"00081155":{"vr":"UI","Value":["1.1"]}}]},"00081198":)"
        R"({"vr":"SQ","Value":[{"00081155":{"vr":"UI","Value":["1.2"]},"00081197":{"vr":"US","Value":[290]}}]}})");
    const auto meta = [](char element, const std::string& vr, const std::string& uid) {
        return std::string{2, 0, element, 0} + vr + static_cast<char>(uid.size()) + std::string(1, '\0') +
               uid;
    };
    save(folder / "meta", kMetaBegin + meta(2, "UI", "1.2 ") + meta(3, "UI", "3.4 ") +
                              meta(16, "UI", "1.2.840 ") + std::string("\x08\0\x16\0", 4));
}

std::string big(std::size_t number, int count) {
    std::string bytes;
    for (int i = count - 1; i >= 0; --i) bytes += static_cast<char>(number >> (8 * i) & 0xff);
    return bytes;
}

std::string item(unsigned type, const std::string& body) {
    return big(type, 1) + big(0, 1) + big(body.size(), 2) + body;
}

std::string pdu(unsigned type, const std::string& body) {
    return big(type, 1) + big(0, 1) + big(body.size(), 4) + body;
}

std::string fragment(unsigned context, unsigned flags, const std::vector<unsigned char>& bytes) {
    const std::string text(bytes.begin(), bytes.end());
    return pdu(4, big(text.size() + 2, 4) + big(context, 1) + big(flags, 1) + text);
}

// PS3.8 9.3.3: both contexts of fuzz_association.cpp are accepted.
std::string acceptance() {
    std::string titles = "ARCHIVE         MACULA          ";
    std::string body = big(1, 2) + big(0, 2) + titles + std::string(32, '\0');
    body += item(0x10, "1.2.840.10008.3.1.1.1");
    for (const unsigned id : {1u, 3u})
        body += item(0x21, big(id, 1) + big(0, 3) + item(0x40, std::string(net::kExplicitLittleEndian)));
    body += item(0x50, item(0x51, big(0x4000, 4)) + item(0x52, "1.2.3"));
    return pdu(2, body);
}

std::vector<unsigned char> answerOfFind(std::uint16_t status) {
    return net::bytesOf({.field = net::CommandField::findResponse,
                         .respondsTo = std::uint16_t{1},
                         .sopClassUid = "1.2.840.10008.5.1.4.1.2.2.1",
                         .status = status,
                         .hasDataset = status != 0});
}

void writeAssociationSeeds(const std::filesystem::path& corpus) {
    const std::filesystem::path folder = corpus / "association";
    const std::filesystem::path messages = corpus / "command";
    const auto identifier = [](std::string_view syntax) {
        return net::identifierBytes({{net::Key::level, "STUDY"},
                                     {net::Key::patientName, "DOE^J"},
                                     {net::Key::studyDate, "20260101"},
                                     {net::Key::studyInstanceUid, "1.2.3"},
                                     {net::Key::instancesOfStudy, "12"}},
                                    syntax, "ISO_IR 192")
            .value();
    };
    const auto text = [](const std::vector<unsigned char>& bytes) {
        return std::string(bytes.begin(), bytes.end());
    };
    save(messages / "command", std::string(1, '\0') + text(answerOfFind(0xff00)));
    save(messages / "explicit", "\x01" + text(identifier(net::kExplicitLittleEndian)));
    save(messages / "implicit", "\x02" + text(identifier(net::kImplicitLittleEndian)));
    constexpr std::uint16_t kPending = 0xff00;
    const std::string found =
        fragment(1, 3, answerOfFind(kPending)) + fragment(1, 2, identifier(net::kExplicitLittleEndian));
    save(folder / "answers", acceptance() + found + found + fragment(1, 3, answerOfFind(0)));
    const auto store = net::bytesOf({.field = net::CommandField::storeRequest,
                                     .messageId = std::uint16_t{7},
                                     .sopClassUid = "1.2.840.10008.5.1.4.1.1.2",
                                     .sopInstanceUid = "1.2.3",
                                     .priority = std::uint16_t{0},
                                     .hasDataset = true});
    save(folder / "instance", acceptance() + fragment(3, 3, store) +
                                  fragment(3, 0, identifier(net::kExplicitLittleEndian)) +
                                  fragment(3, 2, identifier(net::kExplicitLittleEndian)));
    save(folder / "released", acceptance() + pdu(5, std::string(4, '\0')));
    save(folder / "aborted", acceptance() + pdu(7, big(2, 4)));
    save(folder / "rejected", pdu(3, big(0x00010107, 4)));
}

void writeLinkSeeds(const std::filesystem::path& folder) {
    save(folder / "study", "macula://open?study=1.2.840.1&archive=Hospital%20B");
    save(folder / "patient", "macula://open/?patient=P%2F1&issuer=S%C3%BCd");
    save(folder / "iid_study",
         "macula://IHEInvokeImageDisplay?requestType=STUDY&studyUID=1.2,1.3&viewerType=IHE_BIR&keyImagesOnly="
         "true");
    save(folder / "iid_patient",
         "https://a/IHEInvokeImageDisplay?requestType=PATIENT&patientID=1^^^A%261.2%26ISO&lowerDateTime="
         "2013-01-01T00:00:00&mostRecentResults=2&modalitiesInStudy=CT,MR");
    save(folder / "bad", "macula://open?accession=%zz&accession=*&file=/a#b");
}

}  // namespace

void writeArchiveSeeds(const std::filesystem::path& corpus) {
    writeLinkSeeds(corpus / "link");
    writeMultipartSeeds(corpus / "multipart");
    writeQidoSeeds(corpus / "qido");
    writeAssociationSeeds(corpus);
}

}  // namespace macula::fuzz

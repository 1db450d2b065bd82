// Seeds of what archives send over the web.
#include "fuzz/seeds.h"

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
}

}  // namespace macula::fuzz

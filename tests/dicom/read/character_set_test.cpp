// Text of all alphabets is UTF-8, whatever the file declares. Names are those of PS3.5 annexes H to K.
#include "toolkit/character_set.h"

#include <fstream>

#include "bytes.h"
#include "support.h"

namespace macula::dicom::test {
namespace {

struct Case {
    std::string declared, bytes, expected;
    bool fallback = false;
};

void expectName(const Case& c) {
    SCOPED_TRACE(c.declared + " -> " + c.expected);
    const DecodedText text = decodeText(c.bytes, c.declared, Delimiters::ofPersonNames);
    EXPECT_EQ(text.utf8, c.expected);
    EXPECT_EQ(text.fallback, c.fallback);
    EXPECT_TRUE(isValidUtf8(text.utf8));
}

TEST(CharacterSet, SingleByte) {
    for (const char* prefix : {"ISO_IR ", "ISO 2022 IR "}) {
        const auto is = [&](const char* number) { return prefix + std::string(number); };
        expectName({is("100"), "Buc^J\xE9r\xF4me", "Buc^Jérôme"});
        expectName({is("100"),
                    "\xC4neas^R\xFC"
                    "diger",
                    "Äneas^Rüdiger"});
        expectName({is("101"), "Wa\xB3\xEAsa", "Wałęsa"});
        expectName({is("109"),
                    "\xA1"
                    "al",
                    "Ħal"});
        expectName({is("110"),
                    "\xB6"
                    "is",
                    "ļis"});
        expectName({is("144"),
                    "\xBB\xEE\xDA"
                    "ce\xDC\xD1yp\xD3",
                    "Люкceмбypг"});
        expectName({is("127"), "\xE2\xC8\xC7\xE6\xEA^\xE4\xE6\xD2\xC7\xD1", "قباني^لنزار"});
        expectName({is("126"), "\xC4\xE9\xEF\xED\xF5\xF3\xE9\xEF\xF2", "Διονυσιος"});
        expectName({is("138"), "\xF9\xF8\xE5\xEF^\xE3\xE1\xE5\xF8\xE4", "שרון^דבורה"});
        expectName({is("148"), "Da\xF0", "Dağ"});
        expectName({is("203"), "\xA4 \xBD", "€ œ"});
        expectName({is("166"), "\xC2\xA1", "ยก"});  // would be valid UTF-8 too
        expectName({is("13"), "\xD4\xCF\xC0\xDE^\xC0\xDB\xB3", "ﾔﾏﾀﾞ^ﾀﾛｳ"});
    }
    // A Polish name whose two bytes would be valid UTF-8 too.
    expectName({"ISO_IR 101", "KR\xD3\xA3", "KRÓŁ"});
}

TEST(CharacterSet, ManyBytesWithoutEscapes) {
    expectName({"ISO_IR 192", "Wang^XiaoDong=王^小東=", "Wang^XiaoDong=王^小東="});
    expectName({"GB18030", "Wang^XiaoDong=\xCD\xF5^\xD0\xA1\xB6\xAB=", "Wang^XiaoDong=王^小东="});
    expectName({"GBK", "Wang^XiaoDong=\xCD\xF5^\xD0\xA1\xB6\xAB=", "Wang^XiaoDong=王^小东="});
    expectName({"GB18030", "\x90\x30\x81\x30", "\xF0\x90\x80\x80"});
    expectName({"GB18030", "\x81\x30\x81\x30", ""});  // U+0080, which is a control character
}

TEST(CharacterSet, EscapesAndTheirResets) {
    expectName({"\\ISO 2022 IR 87",
                "Yamada^Tarou=\x1B$B;3ED\x1B(B^\x1B$BB@O:\x1B(B=\x1B$B$d$^$@\x1B(B^\x1B$B$?$m$&\x1B(B",
                "Yamada^Tarou=山田^太郎=やまだ^たろう"});
    expectName({"ISO 2022 IR 13\\ISO 2022 IR 87",
                "\xD4\xCF\xC0\xDE^\xC0\xDB\xB3=\x1B$B;3ED\x1B(J^\x1B$BB@O:\x1B(J=\x1B$B$d$^$@\x1B(J^"
                "\x1B$B$?$m$&\x1B(J",
                "ﾔﾏﾀﾞ^ﾀﾛｳ=山田^太郎=やまだ^たろう"});
    expectName(
        {"\\ISO 2022 IR 149",
         "Hong^Gildong=\x1B$)C\xFB\xF3^\x1B$)C\xD1\xCE\xD4\xD7=\x1B$)C\xC8\xAB^\x1B$)C\xB1\xE6\xB5\xBF",
         "Hong^Gildong=洪^吉洞=홍^길동"});
    expectName({"\\ISO 2022 IR 58",
                "Zhang^XiaoDong=\x1B$)A\xD5\xC5^\x1B$)A\xD0\xA1\xB6\xAB=", "Zhang^XiaoDong=张^小东="});
    expectName({"\\ISO 2022 IR 159", "\x1B$(D\x30\x21\x1B(B", "丂"});
    expectName({"ISO 2022 IR 100\\ISO 2022 IR 144\\ISO 2022 IR 126",
                "J\xE9r\xF4me\x1B-L\xBB\xEE^\xE9=\x1B-F\xC4=\xC4", "JérômeЛю^é=Δ=Ä"});
    // A value of its own each, but not where backslashes are part of a text.
    const std::string two = "\x1B-L\xBB\\\xE9";
    const std::string declared = "ISO 2022 IR 100\\ISO 2022 IR 144";
    EXPECT_EQ(decodeText(two, declared, Delimiters::betweenValues).utf8, "Л\\é");
    EXPECT_EQ(decodeText(two, declared, Delimiters::none).utf8, "Л\\щ");
    EXPECT_EQ(decodeText("\x1B-L\xBB\r\n\xE9", declared, Delimiters::none).utf8, "Л\r\né");
    EXPECT_EQ(decodeText("\x1B-L\xBB^\xE9", declared, Delimiters::betweenValues).utf8, "Л^щ");
}

TEST(CharacterSet, WrongOrMissingDeclarations) {
    // UTF-8 that is not declared, or declared as what everybody declares.
    for (const char* declared : {"", "ISO_IR 6", "ISO_IR 100", "NONSENSE", "\\ISO 2022 IR 87", "ISO_IR 13"})
        expectName({declared, "Müller^Jürgen=王", "Müller^Jürgen=王", true});
    // Latin-1 that is not declared, or declared as UTF-8; Windows' quotation marks; no character at all.
    for (const char* declared : {"", "ISO_IR 192", "GIBBERISH"})
        expectName({declared, "M\xFCller^J\xFCrgen", "Müller^Jürgen", true});
    expectName({"ISO_IR 100",
                "\x93"
                "a\x94 \x81",
                "“a” \xEF\xBF\xBD", true});
    // Not in the Arabic set.
    expectName({"ISO_IR 127", "\xFC\xFE", "üþ", true});
    // Declared in other words.
    for (const char* declared : {"ISO IR 100", "ISO-IR-100", "iso_ir_100", "ISO2022IR100", "ISO8859-1"})
        expectName({declared, "J\xE9r\xF4me", "Jérôme"});
    expectName({"UTF-8", "王", "王"});
    // Escapes that nobody declared, and those that were not repeated after a delimiter, or forgotten at all.
    expectName({"", "\x1B$B;3ED\x1B(B", "山田", true});
    expectName({"\\ISO 2022 IR 149", "\x1B$)C\xC8\xAB^\xB1\xE6\xB5\xBF", "홍^길동", true});
    expectName({"\\ISO 2022 IR 149", "\xC8\xAB^\xB1\xE6\xB5\xBF", "홍^길동", true});
    expectName({"ISO 2022 IR 149", "\xC8\xAB^\xB1\xE6\xB5\xBF", "홍^길동"});
    // What Windows in Japan writes, with a backslash as second byte.
    expectName({"ISO_IR 13", "\x95\x5C\x8E\xA6", "表示", true});
    // Plain ASCII is never wrong.
    for (const char* declared : {"", "NONSENSE", "ISO_IR 192", "\\ISO 2022 IR 87"})
        expectName({declared, "DOE^JOHN", "DOE^JOHN"});
}

TEST(CharacterSet, CutOffInACharacter) {
    const std::string name = "王小東";
    expectName({"ISO_IR 192", name.substr(0, 8), "王小\xEF\xBF\xBD", true});
    expectName({"ISO_IR 192", name.substr(0, 7), "王小\xEF\xBF\xBD", true});
    expectName({"GB18030", "\xCD\xF5\xD0", "王\xEF\xBF\xBD", true});
    expectName({"ISO_IR 192", "Jos\xE9", "José", true});
    expectName({"\\ISO 2022 IR 87", "\x1B$B;3E", "山\xEF\xBF\xBD", true});
    expectName({"\\ISO 2022 IR 149", "\x1B$)C\xC8", "\xEF\xBF\xBD", true});
}

// No escape sequence of a file reaches a terminal.
TEST(CharacterSet, ControlCharactersAreDropped) {
    expectName({"ISO_IR 192",
                "a\xC2\x9B"
                "31mb",
                "a31mb"});
    expectName({"", "a\x1B[31mb", "a[31mb", true});
    expectName({"",
                std::string("a\0b\x07\x7F"
                            "c",
                            6),
                "abc"});
    EXPECT_EQ(decodeText("a\tb\r\nc\fd", "", Delimiters::none).utf8, "a\tb\r\nc\fd");
}

TEST(CharacterSet, AnyBytesGiveValidUtf8) {
    std::uint32_t state = 1;
    const auto random = [&] { return state = state * 1664525u + 1013904223u, state >> 16; };
    const std::vector<std::string> all{"",
                                       "ISO_IR 100",
                                       "ISO_IR 13",
                                       "ISO_IR 192",
                                       "GB18030",
                                       "GBK",
                                       "ISO_IR 127",
                                       "ISO_IR 166",
                                       "\\ISO 2022 IR 87",
                                       "\\ISO 2022 IR 149",
                                       "ISO 2022 IR 13\\ISO 2022 IR 87\\ISO 2022 IR 159",
                                       "\\\\\\",
                                       "ISO 2022 IR 58"};
    const std::vector<std::string> pieces{"\x1B$B", "\x1B(B", "\x1B$(D", "\x1B$)C", "\x1B-L", "\x1B(I",
                                          "\x1B",   "^",      "=",       "\\",      " "};
    for (int i = 0; i < 20000; ++i) {
        std::string bytes;
        for (std::uint32_t k = random() % 12; k > 0; --k) {
            if (random() % 3 == 0) {
                bytes += pieces[random() % pieces.size()];
            } else {
                bytes += static_cast<char>(random());
            }
        }
        const std::string& declared = all[random() % all.size()];
        const DecodedText text = decodeText(bytes, declared, static_cast<Delimiters>(random() % 3));
        ASSERT_TRUE(isValidUtf8(text.utf8)) << declared << ' ' << i;
        ASSERT_EQ(text.utf8.find('\x1B'), std::string::npos);
    }
}

TEST(CharacterSet, ValidUtf8) {
    for (const char* good : {"", "a", "é", "王", "\xF0\x9F\x98\x80", "\xF4\x8F\xBF\xBF", "\xED\x9F\xBF"})
        EXPECT_TRUE(isValidUtf8(good)) << good;
    for (const char* bad :
         {"\x80", "\xC3", "\xC0\x80", "\xC1\xBF", "\xE0\x80\x80", "\xED\xA0\x80", "\xF0\x80\x80\x80",
          "\xF4\x90\x80\x80", "\xF8\x88\x80\x80\x80", "\xFF", "\xE7\x8E", "\xC3(", "\xFE"})
        EXPECT_FALSE(isValidUtf8(bad));
}

HeaderFile read(const TemporaryFolder& folder, const std::string& elements) {
    std::ofstream(folder / "f", std::ios::binary) << preamble(kExplicit) + elements;
    return readHeader(folder / "f");
}

TEST(CharacterSet, OfAHeader) {
    const TemporaryFolder folder;
    const auto declared = [](const char* set) { return shortElement(tag::kSpecificCharacterSet, "CS", set); };
    const auto name = [](const char* bytes) { return shortElement(tag::kPatientName, "PN", bytes); };
    const auto good = read(folder, declared("ISO_IR 144") + sopClass() + name("\xBB\xEE"));
    EXPECT_EQ(good.header->text(tag::kPatientName), "Лю");
    EXPECT_FALSE(good.header->charsetFallback());
    const auto bad = read(folder, sopClass() + name("\xBB\xEE"));
    EXPECT_EQ(bad.header->text(tag::kPatientName), "»î");
    EXPECT_TRUE(bad.header->charsetFallback());
    EXPECT_FALSE(read(folder, declared("NONSENSE") + sopClass() + name("DOE")).header->charsetFallback());
    // Text of other kinds is none of a foreign alphabet, and valid all the same.
    const auto code = read(folder, declared("ISO_IR 192") + shortElement(tag::kModality, "CS", "C\xFF"));
    EXPECT_EQ(code.header->text(tag::kModality), "Cÿ");
    EXPECT_TRUE(code.header->charsetFallback());
    // An item with a set of its own, one that has the file's, and an item inside of it.
    const Tag outer{0x0008, 0x1110}, inner{0x0008, 0x1140};
    const auto items = read(
        folder, declared("ISO_IR 144") + sopClass() +
                    sequence(outer, {declared("ISO_IR 100") + sequence(inner, {name("\xE9")}) + name("\xE9"),
                                     name("\xE9")}));
    const auto all = items.header->items(outer);
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].text(tag::kPatientName), "é");
    EXPECT_EQ(all[0].items(inner).at(0).text(tag::kPatientName), "é");
    EXPECT_EQ(all[1].text(tag::kPatientName), "щ");
    // A backslash that is half a character separates nothing.
    const auto values = read(folder, declared("GB18030") + sopClass() +
                                         shortElement(tag::kSeriesDescription, "LO", "\x81\x5C\\b"));
    EXPECT_EQ(values.header->texts(tag::kSeriesDescription), (std::vector<std::string>{"乗", "b"}));
}

TEST(CharacterSet, RealFiles) {
    SKIP_WITHOUT_SHARED_DATA();
    struct Real {
        const char* file;
        std::u32string name;
    };
    const std::vector<Real> all{
        {"chrX1.dcm", U"Wang^XiaoDong=\u738B^\u5C0F\u6771="},
        {"chrH31.dcm", U"Yamada^Tarou=\u5C71\u7530^\u592A\u90CE=\u3084\u307E\u3060^\u305F\u308D\u3046"},
        {"chrRuss.dcm", U"\u041B\u044E\u043Ace\u043C\u0431yp\u0433"},
        {"chrArab.dcm", U"\u0642\u0628\u0627\u0646\u064A^\u0644\u0646\u0632\u0627\u0631"},
        {"chrKoreanMulti.dcm", U"\uAE40\uD76C\uC911"}};
    for (const Real& real : all) {
        const HeaderFile file = readHeader(sharedData() / "odd/charsets" / real.file);
        ASSERT_TRUE(file.header) << real.file;
        const std::string name = file.header->text(tag::kPatientName).value_or("");
        std::u32string codes;
        for (std::size_t i = 0; i < name.size();) {
            const auto lead = static_cast<unsigned char>(name[i]);
            const int more = lead < 0x80 ? 0 : lead < 0xE0 ? 1 : lead < 0xF0 ? 2 : 3;
            char32_t code = more == 0 ? lead : lead & (0x3F >> more);
            for (int k = 1; k <= more; ++k)
                code = code << 6 | (static_cast<unsigned char>(name[i + k]) & 0x3F);
            codes += code;
            i += static_cast<std::size_t>(more) + 1;
        }
        EXPECT_EQ(codes, real.name) << real.file;
        EXPECT_FALSE(file.header->charsetFallback()) << real.file;
    }
}

}  // namespace
}  // namespace macula::dicom::test

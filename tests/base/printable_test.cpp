/// Text from outside, made fit to be shown.

#include "limn/base/printable.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "limn/base/error.h"
#include "limn/base/utf8.h"

namespace limn {
namespace {

TEST(Printable, EscapesWhatATerminalOrAFileWouldObey) {
  EXPECT_EQ(base::printable("loop-7"), "loop-7");
  EXPECT_EQ(base::printable("Gérot √3 λ²"), "Gérot √3 λ²");
  EXPECT_EQ(base::printable("a\nb\r\tc"), "a\\nb\\r\\tc");
  EXPECT_EQ(base::printable("\x1b[31mred"), "\\x1b[31mred");
  EXPECT_EQ(base::printable(std::string_view("a\0b\x7f", 4)), "a\\x00b\\x7f");
  EXPECT_EQ(base::printable("\xc2\x9b"
                            "31m"),
            "\\u{9b}31m");  // a control sequence in one character
  EXPECT_EQ(base::printable("\u202egnp.exe"), "\\u{202e}gnp.exe");  // turns the text round
  EXPECT_EQ(base::printable("\u2028"), "\\u{2028}");
  EXPECT_EQ(base::printable("a\xff\xc3"), "a\\xff\\xc3");
  EXPECT_EQ(base::printable_lines("a\n\tb\x1b"), "a\n\tb\\x1b");
}

TEST(Printable, LatexTextIsNoMarkup) {
  EXPECT_EQ(base::latex_text("a_b & 50% $x$ #1 {y} ~ ^ \\input"),
            "a\\_b \\& 50\\% \\$x\\$ \\#1 \\{y\\} \\textasciitilde{} \\textasciicircum{} "
            "\\textbackslash{}input");
  EXPECT_EQ(base::latex_text("a\n\\end{document}"),
            "a\\textbackslash{}n\\textbackslash{}end\\{document\\}");
}

RC_GTEST_PROP(PrintableLaws, NoByteIsLostAndNoneIsAControl, (const std::string& text)) {
  const std::string shown = base::printable(text);
  for (std::string_view rest = shown; !rest.empty(); rest.remove_prefix(base::utf8_length(rest))) {
    RC_ASSERT(base::utf8_length(rest) > 0U);
    RC_ASSERT(static_cast<unsigned char>(rest[0]) >= ' ' && rest[0] != '\x7f');
  }
  RC_ASSERT(shown.size() >= text.size());
  RC_ASSERT(base::printable(shown) == shown);
}

/// Against the definition: every code point written out by hand.
TEST(Utf8, LengthsOfAllCodePoints) {
  for (unsigned code = 0; code < 0x110000U; code += code < 0x3000U ? 1 : 37) {
    std::string bytes;
    if (code < 0x80U) {
      bytes = {static_cast<char>(code)};
    } else if (code < 0x800U) {
      bytes = {static_cast<char>(0xC0U | code >> 6U), static_cast<char>(0x80U | (code & 0x3FU))};
    } else if (code < 0x10000U) {
      bytes = {static_cast<char>(0xE0U | code >> 12U),
               static_cast<char>(0x80U | (code >> 6U & 0x3FU)),
               static_cast<char>(0x80U | (code & 0x3FU))};
    } else {
      bytes = {static_cast<char>(0xF0U | code >> 18U),
               static_cast<char>(0x80U | (code >> 12U & 0x3FU)),
               static_cast<char>(0x80U | (code >> 6U & 0x3FU)),
               static_cast<char>(0x80U | (code & 0x3FU))};
    }
    const bool surrogate = code >= 0xD800U && code < 0xE000U;
    ASSERT_EQ(base::utf8_length(bytes), surrogate ? 0U : bytes.size()) << std::hex << code;
    if (bytes.size() > 1) ASSERT_EQ(base::utf8_length(bytes.substr(0, bytes.size() - 1)), 0U);
  }
  for (const char* bad : {"", "\x80", "\xc0\x80", "\xc1\xbf", "\xe0\x9f\xbf", "\xf0\x8f\xbf\xbf",
                          "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff"})
    EXPECT_EQ(base::utf8_length(bad), 0U) << bad;
}

TEST(ErrorText, NamesAreOfOneLine) {
  EXPECT_EQ((Error{"no 'a\nb'", "\x1b", "f\n.toml", 0, 0}.text()), "f\\n.toml: no 'a\\nb' (\\x1b)");
}

}  // namespace
}  // namespace limn

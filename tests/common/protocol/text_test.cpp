// Shows which text from outside is shown, and in which form.
#include "common/protocol/text.h"

#include "tests/common/protocol/generators.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace billiards::protocol {
namespace {

struct Case {
    const char* what;
    std::string text;
    std::optional<std::string> clean;
};

TEST(CleanText, ShowsWhatIsHarmlessAndNothingElse) {
    const Case cases[] = {
        {"plain", "Ada", "Ada"},
        {"empty", "", ""},
        {"blanks at the ends", "  Ada L. ", "Ada L."},
        {"other blanks at the ends", "\u00a0\u3000Ada\u2003", "Ada"},
        {"only blanks", " \u00a0 ", ""},
        {"other scripts", "Žofie 漢字 🎱", "Žofie 漢字 🎱"},
        {"composed", "e\u0301", "é"},
        {"two marks", "q\u0301\u0302", "q\u0301\u0302"},
        {"three marks", "q\u0301\u0302\u0303", std::nullopt},
        {"newline", "a\nb", std::nullopt},
        {"tab at the end", "a\t", std::nullopt},
        {"NUL", std::string("a\0b", 3), std::nullopt},
        {"escape", "\x1b[31m", std::nullopt},
        {"C1 control", "a\u0085", std::nullopt},
        {"right-to-left override", "a\u202eb", std::nullopt},
        {"zero width joiner", "a\u200db", std::nullopt},
        {"byte order mark", "\ufeffa", std::nullopt},
        {"line separator", "a\u2028b", std::nullopt},
        {"private use", "\ue000", std::nullopt},
        {"unassigned", "\u0378", std::nullopt},
        {"noncharacter", "\uffff", std::nullopt},
        {"surrogate", "\xed\xa0\x80", std::nullopt},
        {"overlong", "\xc0\xaf", std::nullopt},
        {"stray continuation", "\x80", std::nullopt},
        {"cut short", "\xe6\xbc", std::nullopt},
        {"beyond Unicode", "\xf4\x90\x80\x80", std::nullopt},
    };
    for (const Case& one : cases) EXPECT_EQ(clean_text(one.text, 40), one.clean) << one.what;
}

TEST(CleanText, CountsCodePointsAfterItHasComposedAndTrimmed) {
    EXPECT_EQ(clean_text(" e\u0301e\u0301 ", 2), "éé");
    EXPECT_EQ(clean_text("漢字漢", 2), std::nullopt);
}

RC_GTEST_PROP(CleanText, LeavesCleanTextAlone, ()) {
    const auto clean = clean_text(*any_text(20), 20);
    RC_PRE(clean.has_value());
    RC_ASSERT(clean_text(*clean, 20) == clean);
}

RC_GTEST_PROP(CleanText, GivesValidTextOrNothingWhateverTheBytes, (const std::string& bytes)) {
    const auto clean = clean_text(bytes, 40);
    if (!clean) return;  // RC_ASSERT takes expressions apart: it would look at both sides of ||.
    const auto length = code_points(*clean);
    RC_ASSERT(length.has_value());
    RC_ASSERT(*length <= 40U);
}

TEST(CodePoints, AreCountedInValidTextOnly) {
    EXPECT_EQ(code_points(""), 0U);
    EXPECT_EQ(code_points("aé漢🎱"), 4U);
    EXPECT_EQ(code_points("a\xff"), std::nullopt);
    EXPECT_EQ(code_points("\xed\xa0\x80"), std::nullopt);
}

TEST(Clipped, CutsNoCodePointInTwo) {
    EXPECT_EQ(clipped("aé漢", 6), "aé漢");
    EXPECT_EQ(clipped("aé漢", 5), "aé");
    EXPECT_EQ(clipped("aé漢", 2), "a");
    EXPECT_EQ(clipped("🎱", 3), "");
}

}  // namespace
}  // namespace billiards::protocol
